--  SPDX-License-Identifier: GPL-3.0-or-later
--  The jitter of the periodic tasks, compared with cyclictest and a minimal
--  program that writes to its own line.

package Period_Times is

   procedure Report;
   --  No command is sent meanwhile: by design a reload waits for a current
   --  exchange

end Period_Times;
