--  SPDX-License-Identifier: GPL-3.0-or-later
--  The wheels: distances, turns, walls.

package Robot_Motion_Tests is

   procedure Add_Tests;

end Robot_Motion_Tests;
