--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line through a pair of radios (destijl_emulator --radio).

package Radio_Tests is

   procedure Register;

end Radio_Tests;
