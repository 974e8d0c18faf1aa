--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random missions, judged by where the robot truly was: the short form of
--  script/bench missions.

package Mission_Trial_Tests is

   procedure Register;

end Mission_Trial_Tests;
