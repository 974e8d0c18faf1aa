--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision's mode: F14 to F19, and everything from every state.

package Vision_Mode_Tests is

   procedure Add_Tests;

end Vision_Mode_Tests;
