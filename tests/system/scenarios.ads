--  SPDX-License-Identifier: GPL-3.0-or-later
--  System tests as AUnit test cases: each is one procedure with a name, and is
--  run by a process of its own.

with AUnit;
with AUnit.Simple_Test_Cases;

package Scenarios is

   type Routine is access procedure;

   type Scenario is new AUnit.Simple_Test_Cases.Test_Case with private;

   overriding function Name
     (Test : Scenario) return AUnit.Message_String;

   overriding procedure Run_Test (Test : in out Scenario);

   procedure Add
     (Name : String; Run : not null Routine; Alone : Boolean := False);
   --  A test. Alone: it runs when no other does

   procedure Add_Filter (Text : String);
   --  Only tests whose name contains one of these are run

   procedure Invert_Filters;
   --  Only those whose name contains none of them

   procedure Run_One (Title : String) with No_Return;
   --  Runs this test, prints its report and ends the process as a Run expects

   procedure Run (Jobs : Positive; Program : String; All_Passed : out Boolean);
   --  Runs the tests: each in a process of Program, with the options of this
   --  one and --one TITLE, so many at a time; then those that run alone. Ends
   --  with the number of tests passed and failed.
   --
   --  A test is repeated, alone, if it missed a limit of time while its own
   --  line (Child_Processes.Any_Was_Late) or a processor (Standstills) was
   --  late: three attempts, then it has failed. Every repeat is reported.

private

   type Name_Access is access String;

   type Scenario is new AUnit.Simple_Test_Cases.Test_Case with record
      Title  : Name_Access;
      Action : Routine;
      Alone  : Boolean;
   end record;

end Scenarios;
