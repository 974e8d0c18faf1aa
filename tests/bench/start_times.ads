--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long the supervisor takes to listen, and to be ready again when a
--  monitor has gone; how much memory it has.

package Start_Times is

   procedure Report;

end Start_Times;
