--  SPDX-License-Identifier: GPL-3.0-or-later
--  Packets, delays and losses of a pair of radios.

package Radio_Links_Tests is

   procedure Add_Tests;

end Radio_Links_Tests;
