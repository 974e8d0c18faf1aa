--  SPDX-License-Identifier: GPL-3.0-or-later
--  Makes files of --trace under the loads of the analysis, and puts where they
--  are, beside the bounds of the analysis.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Directories;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with System.Multiprocessors;

with Bench_Settings;        use Bench_Settings;
with Budgets;               use Budgets;
with Expectations;          use Expectations;
with Libc;
with Loads;
with Programs;
with Reports;               use Reports;
with Response_Times;        use Response_Times;
with Rigs;                  use Rigs;
with Supervisor_Model;      use Supervisor_Model;

procedure Report_Responses is

   Given : constant String := To_String (Trace_File);

   Last_Processor : constant Natural :=
     Natural (System.Multiprocessors.Number_Of_CPUs) - 1;

   Apart : constant Boolean := Last_Processor > 0;
   --  The supervisor runs with --cpu

   procedure Make (Path : String; Missions : Boolean) is
      --  A trace
      Own : constant String := Programs.Temporary_Folder & "/trace.txt";
      R   : Rig;
   begin
      Loads.Carry_Out
        (R, Missions,
         "--trace " & Own
         & (if Apart and then not As_Service
            then " --cpu" & Last_Processor'Image else ""));
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0,
             "the supervisor did not end in good order");
      Check (not R.Supervisor.Says ("the trace is not complete"),
             R.Supervisor.Text);
      Ada.Directories.Copy_File (Own, Path);
   end Make;

   procedure Put_Trace (Path : String; Missions : Boolean) is
      --  Of each activity the name, the task and the bound, 0 where there is
      --  none
      Known : Analysis;
      Text  : Unbounded_String;

      procedure Put (Name : String; From : Bound; Of_Task : String := "") is
      begin
         Append (Text, (if Text = "" then "" else ", ")
                 & "[" & Quoted (To_Lower (Name)) & ", " & Quoted (Of_Task)
                 & "," & Microseconds'Image
                   (if From.Exists then From.Local else 0) & "]");
      end Put;

   begin
      Analyse
        (Of_The_Table, (if Apart then Real_Time_Apart else One_Processor),
         (others => <>), (Mission => Missions, others => <>), Known);
      Known.Bounds (Line_Request) := Known.Owner (Other_Order).Request;
      Known.Bounds (Line_Answer) := Known.Owner (Other_Order).Outcome;
      for Name in Activity_Name loop
         Put (Name'Image, Known.Bounds (Name), Task_Name (Name));
      end loop;
      Reports.Put_Members
        ("""trace"": " & Quoted (Path) & ", ""missions"": "
         & To_Lower (Missions'Image) & ", ""made"": "
         & To_Lower (Boolean'Image (Given = "")) & ", ""order"":"
         & Microseconds'Image
             (if Known.Requirements (Mission_Order).Known
              then Known.Requirements (Mission_Order).Bound else 0)
         & ", ""activities"": [" & To_String (Text) & "]");
   end Put_Trace;

begin
   Reports.Begin_Section
     ("responses", "what each task takes from its release to its end");
   for Missions in Boolean loop
      declare
         Path : constant String :=
           (if Given /= "" then Given
            else To_String (Folder) & "/trace"
              & (if Missions then "-missions" else "") & ".txt");
      begin
         if Given = "" then
            Make (Path, Missions);
         end if;
         Put_Trace (Path, Missions);
      end;
   end loop;
   Reports.Put_Note
     ("the bounds are those of proofs/schedulability for this machine");
end Report_Responses;
