--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel tells of a connection, and of the queue of new ones.

with AUnit;
with AUnit.Test_Cases;

package Tcp_Infos_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Tcp_Infos_Tests;
