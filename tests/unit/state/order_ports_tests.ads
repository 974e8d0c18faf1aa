--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks' ports: first in first out, the capacity, the end of a session.

with AUnit.Test_Cases;

package Order_Ports_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Order_Ports_Tests;
