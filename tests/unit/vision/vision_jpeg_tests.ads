--  SPDX-License-Identifier: GPL-3.0-or-later
--  The camera's own JPEG: passed on as it is, or decoded, or refused.

with AUnit;
with AUnit.Test_Cases;

package Vision_Jpeg_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Vision_Jpeg_Tests;
