--  SPDX-License-Identifier: GPL-3.0-or-later
--  Places in the arena, against a projective map in floating point.

package Mission_Arenas_Tests is

   procedure Add_Tests;

end Mission_Arenas_Tests;
