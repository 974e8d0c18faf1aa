--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14 to F19: the camera, the arena and the positions.

with AUnit.Test_Suites;

package Camera_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Camera_Tests;
