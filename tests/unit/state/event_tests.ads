--  SPDX-License-Identifier: GPL-3.0-or-later
--  Events: what is set is not lost, and wakes its task once.

with AUnit.Test_Cases;

package Event_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Event_Tests;
