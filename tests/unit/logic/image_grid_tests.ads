--  SPDX-License-Identifier: GPL-3.0-or-later
--  When images are sent: sources of many rates, with jitter and drift.

package Image_Grid_Tests is

   procedure Add_Tests;

end Image_Grid_Tests;
