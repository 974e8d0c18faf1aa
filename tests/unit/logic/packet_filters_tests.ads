--  SPDX-License-Identifier: GPL-3.0-or-later
--  The packet filter, interpreted as the kernel does: who is dropped.

with AUnit;
with AUnit.Test_Cases;

package Packet_Filters_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Packet_Filters_Tests;
