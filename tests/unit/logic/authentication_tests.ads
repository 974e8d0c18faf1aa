--  SPDX-License-Identifier: GPL-3.0-or-later
--  The token: its file, the line that shows it, and what the log shows.

with AUnit.Test_Cases;

package Authentication_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Authentication_Tests;
