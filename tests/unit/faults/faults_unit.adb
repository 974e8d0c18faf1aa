--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of what judges the faults. Exit status 0 only if tests
--  ran and all of them succeeded.

with Ada.Command_Line;
with Ada_Containers;

with AUnit.Reporter.Text;
with AUnit.Run;
with AUnit.Test_Results;

with Faults_Suite;

procedure Faults_Unit is

   use type Ada_Containers.Count_Type;

   procedure Run is new AUnit.Run.Test_Runner_With_Results
     (Faults_Suite.Suite);

   Reporter : AUnit.Reporter.Text.Text_Reporter;
   Results  : AUnit.Test_Results.Result;

begin
   Ada.Command_Line.Set_Exit_Status (Ada.Command_Line.Failure);
   Run (Reporter, Results);
   if Results.Test_Count > 0 and then Results.Successful then
      Ada.Command_Line.Set_Exit_Status (Ada.Command_Line.Success);
   end if;
end Faults_Unit;
