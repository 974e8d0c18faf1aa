--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14 to F19: the camera, the arena and the positions.

package Camera_Tests is

   procedure Register;

end Camera_Tests;
