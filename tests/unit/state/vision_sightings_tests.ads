--  SPDX-License-Identifier: GPL-3.0-or-later
--  Vision.Sightings: what is seen, and whom it wakes.

with AUnit.Test_Cases;

package Vision_Sightings_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Vision_Sightings_Tests;
