--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision's mode: F14 to F19, and everything from every state.

with AUnit.Test_Cases;

package Vision_Mode_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Vision_Mode_Tests;
