--  SPDX-License-Identifier: GPL-3.0-or-later
--  Pending connections: turns, room and shares, and that no source keeps
--  another one out, whatever comes.

with AUnit;
with AUnit.Test_Cases;

package Pending_Connections_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Pending_Connections_Tests;
