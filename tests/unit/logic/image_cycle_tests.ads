--  SPDX-License-Identifier: GPL-3.0-or-later
--  One cycle of the periodic images.

with AUnit.Test_Cases;

package Image_Cycle_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Image_Cycle_Tests;
