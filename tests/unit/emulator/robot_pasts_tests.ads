--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the robot was a while ago.

with AUnit.Test_Cases;

package Robot_Pasts_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Robot_Pasts_Tests;
