--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether every command is seen to be answered exactly once.

with AUnit.Test_Cases;

package Answer_Ledgers_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Answer_Ledgers_Tests;
