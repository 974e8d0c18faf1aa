--  SPDX-License-Identifier: GPL-3.0-or-later
--  What orders mean: the robot's frame for each line of the monitor, and the
--  ranks.

with AUnit.Test_Cases;

package Order_Meanings_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Order_Meanings_Tests;
