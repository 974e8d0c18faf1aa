--  SPDX-License-Identifier: GPL-3.0-or-later
--  Blocklists: who floods, and who only connects now and then.

with AUnit;
with AUnit.Test_Cases;

package Blocklists_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Blocklists_Tests;
