--  SPDX-License-Identifier: GPL-3.0-or-later
--  The sources of images: files, what cannot be opened, pace, scaling.

package Vision_Source_Tests is

   procedure Add_Tests;

end Vision_Source_Tests;
