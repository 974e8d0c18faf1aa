--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: the steps of every request, step by step.

package Robot_Session_Tests is

   procedure Add_Tests;

end Robot_Session_Tests;
