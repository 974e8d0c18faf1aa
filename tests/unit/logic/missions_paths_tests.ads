--  SPDX-License-Identifier: GPL-3.0-or-later
--  The points of a mission: coordinates, their number, and what is no path.

with AUnit.Test_Cases;

package Missions_Paths_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Missions_Paths_Tests;
