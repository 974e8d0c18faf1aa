--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's connection: present, vanished, stalled.

package Monitor_Link_Tests is

   procedure Add_Tests;

end Monitor_Link_Tests;
