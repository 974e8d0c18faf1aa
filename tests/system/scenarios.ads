--  SPDX-License-Identifier: GPL-3.0-or-later
--  System tests as AUnit test cases: each is one procedure with a name.

with AUnit;
with AUnit.Simple_Test_Cases;
with AUnit.Test_Suites;

package Scenarios is

   type Routine is access procedure;

   type Scenario is new AUnit.Simple_Test_Cases.Test_Case with private;

   overriding function Name
     (Test : Scenario) return AUnit.Message_String;

   overriding procedure Run_Test (Test : in out Scenario);
   --  Where Test fails and the machine stood still meanwhile, a processor or a
   --  byte through a pseudo-terminal for 20 ms or more in one piece
   --  (Standstills), or for 50 ms of processor time that its host took
   --  (Host_Time), it says so, waits for a calm moment, and runs it again: the
   --  robot has 80 ms to answer, and a test cannot tell who was late. Up to
   --  twelve times, and for half an hour of all tests together; then Test is
   --  not judged, which is neither passed nor failed. Of more than eight tests
   --  that is not taken: the next one fails. Never run again: what fails on a
   --  machine that ran, and where a program has ended after an internal
   --  failure or by a fault.

   procedure Add_Filter (Text : String);
   --  Only scenarios whose name contains one of these are added from now on

   procedure Invert_Filters;
   --  Only those whose name contains none of them

   procedure Add
     (Suite : AUnit.Test_Suites.Access_Test_Suite;
      Name  : String;
      Run   : not null Routine);

   function Run_Count return Natural;
   function Failed_Count return Natural;
   function Skipped_Count return Natural;

   function Not_Judged_Count return Natural;

   function Not_Judged_Names return String;
   --  Each after a blank

   function Repeated_Count return Natural;
   --  How often a test was run again

private

   type Name_Access is access String;

   type Scenario is new AUnit.Simple_Test_Cases.Test_Case with record
      Title  : Name_Access;
      Action : Routine;
   end record;

end Scenarios;
