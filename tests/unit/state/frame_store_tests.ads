--  SPDX-License-Identifier: GPL-3.0-or-later
--  The frame slots: who holds which, and that the newest image wins.

with AUnit.Test_Cases;

package Frame_Store_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Frame_Store_Tests;
