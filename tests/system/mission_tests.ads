--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions: the robot drives by itself, until it is there or something ends
--  it.

with AUnit.Test_Suites;

package Mission_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Mission_Tests;
