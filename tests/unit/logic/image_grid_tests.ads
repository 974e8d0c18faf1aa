--  SPDX-License-Identifier: GPL-3.0-or-later
--  When images are sent: sources of many rates, with jitter and drift.

with AUnit.Test_Cases;

package Image_Grid_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Image_Grid_Tests;
