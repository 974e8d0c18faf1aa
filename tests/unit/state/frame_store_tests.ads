--  SPDX-License-Identifier: GPL-3.0-or-later
--  The frame slots: who holds which, and that the newest image wins.

package Frame_Store_Tests is

   procedure Add_Tests;

end Frame_Store_Tests;
