--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line: lost at the fourth failure, and back into step.

with AUnit.Test_Cases;

package Line_Health_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Line_Health_Tests;
