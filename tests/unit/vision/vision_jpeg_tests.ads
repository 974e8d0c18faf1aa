--  SPDX-License-Identifier: GPL-3.0-or-later
--  The camera's own JPEG: passed on as it is, or decoded, or refused.

package Vision_Jpeg_Tests is

   procedure Add_Tests;

end Vision_Jpeg_Tests;
