--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a program of unit tests.

with AUnit.Test_Cases;

package Unit_Runs is

   procedure Add (Tests : not null AUnit.Test_Cases.Test_Case_Access);
   --  Adds the tests to the run if their name is an argument of the program,
   --  or if it has no arguments

   procedure Run;
   --  Runs all added tests. Exit status 0 only if tests ran, all succeeded,
   --  and each argument was the name of some.

end Unit_Runs;
