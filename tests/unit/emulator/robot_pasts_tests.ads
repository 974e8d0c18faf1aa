--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the robot was a while ago.

package Robot_Pasts_Tests is

   procedure Add_Tests;

end Robot_Pasts_Tests;
