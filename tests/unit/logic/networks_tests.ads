--  SPDX-License-Identifier: GPL-3.0-or-later
--  Networks of IPv4: their text, their addresses, and whom a list admits.

with AUnit.Test_Cases;

package Networks_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Networks_Tests;
