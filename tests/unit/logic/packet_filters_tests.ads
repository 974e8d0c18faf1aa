--  SPDX-License-Identifier: GPL-3.0-or-later
--  The packet filter, interpreted as the kernel does: who is dropped.

package Packet_Filters_Tests is

   procedure Add_Tests;

end Packet_Filters_Tests;
