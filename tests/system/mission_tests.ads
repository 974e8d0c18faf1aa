--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions: the robot drives by itself, until it is there or something ends
--  it.

package Mission_Tests is

   procedure Register;

end Mission_Tests;
