--  SPDX-License-Identifier: GPL-3.0-or-later
--  One cycle of the periodic images.

package Image_Cycle_Tests is

   procedure Add_Tests;

end Image_Cycle_Tests;
