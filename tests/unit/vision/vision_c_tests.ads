--  SPDX-License-Identifier: GPL-3.0-or-later
--  vision_c itself: arguments, slots, unusual sizes, drawing, encoding.

package Vision_C_Tests is

   procedure Add_Tests;

end Vision_C_Tests;
