--  SPDX-License-Identifier: GPL-3.0-or-later
--  F7 to F13: the robot, its line and its orders.

package Robot_Tests is

   procedure Register;

end Robot_Tests;
