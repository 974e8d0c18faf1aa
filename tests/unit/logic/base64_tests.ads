--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64: the vectors of RFC 4648, round trips, and what must be refused.

with AUnit.Test_Cases;

package Base64_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Base64_Tests;
