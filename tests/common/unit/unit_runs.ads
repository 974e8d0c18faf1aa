--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a program of unit tests.

package Unit_Runs is

   type Routine is not null access procedure;

   procedure Add (Group : String; Add_Tests : Routine);
   --  Calls Add_Tests if Group is an argument of the program, or if it has no
   --  arguments

   procedure Add_Test (Name : String; Test : Routine);
   --  Adds a test to the run; for the Add_Tests of its group

   procedure Run;
   --  Runs all added tests. Exit status 0 only if tests ran, all succeeded,
   --  and each argument was the name of a group.

end Unit_Runs;
