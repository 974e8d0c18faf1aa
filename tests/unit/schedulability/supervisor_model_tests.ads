--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as the analysis sees it: complete, and sensitive.

with AUnit.Test_Cases;

package Supervisor_Model_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Supervisor_Model_Tests;
