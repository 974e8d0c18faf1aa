--  SPDX-License-Identifier: GPL-3.0-or-later
--  The search for robots: accuracy at every heading, number, limits.

package Vision_Robot_Tests is

   procedure Add_Tests;

end Vision_Robot_Tests;
