--  SPDX-License-Identifier: GPL-3.0-or-later
--  What orders mean: the robot's frame for each line of the monitor, and the
--  ranks.

package Commands_Tests is

   procedure Add_Tests;

end Commands_Tests;
