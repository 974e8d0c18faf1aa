--  SPDX-License-Identifier: GPL-3.0-or-later
--  vision_c itself: arguments, slots, unusual sizes, drawing, encoding.

with AUnit.Test_Cases;

package Vision_C_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Vision_C_Tests;
