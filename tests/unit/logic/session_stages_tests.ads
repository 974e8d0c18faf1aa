--  SPDX-License-Identifier: GPL-3.0-or-later
--  The stages of a session: their order, and that none begins at the end.

with AUnit.Test_Cases;

package Session_Stages_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Session_Stages_Tests;
