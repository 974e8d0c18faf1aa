--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's frames: every command, every argument, every short answer.

with AUnit.Test_Cases;

package Robot_Protocol_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Robot_Protocol_Tests;
