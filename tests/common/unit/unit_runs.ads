--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a program of unit tests.

with Ada.Containers.Indefinite_Vectors;
with AUnit.Assertions;
with GNAT.Source_Info;

package Unit_Runs is

   procedure Group (Name : String; Tests : not null access procedure);
   --  Calls Tests if Name is an argument of the program, or if it has no
   --  arguments

   procedure Run_Test (Title : String; Action : not null access procedure);
   --  Runs a test of the group

   procedure Assert
     (Condition : Boolean;
      Message   : String;
      Source    : String  := GNAT.Source_Info.File;
      Line      : Natural := GNAT.Source_Info.Line)
   renames AUnit.Assertions.Assert;
   --  The test fails unless Condition

   package Line_Vectors is
     new Ada.Containers.Indefinite_Vectors (Positive, String);

   function Split
     (Table : String; Bar : Character := '|') return Line_Vectors.Vector;
   --  What is between its bars

   procedure Run_Scripts
     (Play : not null access procedure (Script : String); Table : String);
   --  Runs a test of the group for each row of Table, which is its title, a
   --  colon, a blank and its script

   procedure Finish;
   --  Reports the tests. Exit status 0 only if tests ran, all succeeded, and
   --  each argument was the name of a group.

end Unit_Runs;
