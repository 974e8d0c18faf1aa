--  SPDX-License-Identifier: GPL-3.0-or-later
--  How punctual the periodic tasks are, beside cyclictest and a bare program
--  that writes to a line of its own.

package Period_Times is

   procedure Report;
   --  No command is sent meanwhile: a reload waits for an exchange that is
   --  under way, by design

end Period_Times;
