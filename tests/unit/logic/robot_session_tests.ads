--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: the steps of every request, step by step.

with AUnit.Test_Cases;

package Robot_Session_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Robot_Session_Tests;
