--  SPDX-License-Identifier: GPL-3.0-or-later
--  The search for robots: accuracy at every heading, number, limits.

with AUnit.Test_Cases;

package Vision_Robot_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Vision_Robot_Tests;
