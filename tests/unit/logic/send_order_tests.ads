--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes to the monitor next, and how long after the message before it.

with AUnit.Test_Cases;

package Send_Order_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Send_Order_Tests;
