--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ground of a mission: what it needs, what ends it, its times.

with AUnit.Test_Cases;

package Mission_Grounds_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Mission_Grounds_Tests;
