--  SPDX-License-Identifier: GPL-3.0-or-later
--  The journal: first in first out, the capacity, what is not kept.

with AUnit.Test_Cases;

package Journal_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Journal_Tests;
