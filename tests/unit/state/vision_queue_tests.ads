--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision: one at a time, in the order of the commands.

with AUnit.Test_Cases;

package Vision_Queue_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Vision_Queue_Tests;
