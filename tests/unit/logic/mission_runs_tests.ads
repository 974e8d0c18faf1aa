--  SPDX-License-Identifier: GPL-3.0-or-later
--  The runs of missions, their angles and their guards.

with AUnit.Test_Cases;

package Mission_Runs_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Mission_Runs_Tests;
