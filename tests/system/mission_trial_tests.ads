--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random missions, judged by where the robot truly was: the short form of
--  script/bench missions.

with AUnit.Test_Suites;

package Mission_Trial_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Mission_Trial_Tests;
