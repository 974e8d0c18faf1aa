--  SPDX-License-Identifier: GPL-3.0-or-later
--  F7 to F13: the robot, its line and its orders.

with AUnit.Test_Suites;

package Robot_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Robot_Tests;
