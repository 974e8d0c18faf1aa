--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which processors the real-time tasks have, and which all others.

with AUnit.Test_Cases;

package Processor_Sets_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Processor_Sets_Tests;
