--  SPDX-License-Identifier: GPL-3.0-or-later
--  Robots that are followed: the same answers as a search everywhere gives.

with AUnit.Test_Cases;

package Following_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Following_Tests;
