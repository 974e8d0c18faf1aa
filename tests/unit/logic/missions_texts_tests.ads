--  SPDX-License-Identifier: GPL-3.0-or-later
--  The lines on a mission: progress, every end, every refusal.

with AUnit.Test_Cases;

package Missions_Texts_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Missions_Texts_Tests;
