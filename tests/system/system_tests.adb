--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the system tests. Arguments without dashes are parts of the names of
--  the tests to run, or with --but of those to leave out; --untimed skips
--  those that measure time. --supervisor, --emulator and --monitor name other
--  programs than those beside this one.

with Ada.Exceptions;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;
with AUnit.Options;
with AUnit.Reporter.Text;
with AUnit.Test_Results;
with AUnit.Test_Suites;
with GNAT.OS_Lib;

with Camera_Tests;
with Expectations;
with Mission_Tests;
with Monitor_Tests;
with Never_Tests;
with Option_Readers;
with Own_Process;
with Plain_Numbers; use Plain_Numbers;
with Process_Tests;
with Programs;
with Robot_Tests;
with Scenarios;
with Security_Tests;
with Server_Tests;
with Source_Tests;
with Standstills;
with Trace_Tests;

procedure System_Tests is

   use type AUnit.Status;

   Time_Limit : constant Duration := 3_000.0;
   --  The whole run takes an eighth of this; up to half an hour more where
   --  tests are run again because the machine stood still

   task Guard is
      entry Done;
   end Guard;
   --  Even if something hangs, the run ends and leaves nothing behind

   task body Guard is
   begin
      select
         accept Done;
      or
         delay Time_Limit;
         Programs.Give_Up ("the run has not ended within its time");
      end select;
   end Guard;

   Suite    : constant AUnit.Test_Suites.Access_Test_Suite :=
     AUnit.Test_Suites.New_Suite;
   Result   : AUnit.Test_Results.Result;
   Reporter : AUnit.Reporter.Text.Text_Reporter;
   Outcome  : AUnit.Status;

begin
   Own_Process.Ignore_Broken_Pipes;

   while Option_Readers.Next loop
      if Programs.Read_Option then
         null;
      elsif Option_Readers.Name = "--but" then
         Scenarios.Invert_Filters;
      elsif Option_Readers.Name = "--untimed" then
         Expectations.Leave_Out_Measurements;
      elsif Index (Option_Readers.Name, "-") = 1 then
         Option_Readers.Refuse;
      else
         Scenarios.Add_Filter (Option_Readers.Name);
      end if;
   end loop;

   Server_Tests.Add_To (Suite);
   Monitor_Tests.Add_To (Suite);
   Robot_Tests.Add_To (Suite);
   Camera_Tests.Add_To (Suite);
   Source_Tests.Add_To (Suite);
   Mission_Tests.Add_To (Suite);
   Process_Tests.Add_To (Suite);
   Security_Tests.Add_To (Suite);
   Trace_Tests.Add_To (Suite);
   Never_Tests.Add_To (Suite);

   Standstills.Watch (Lines => True);
   AUnit.Test_Suites.Run
     (Suite, AUnit.Options.Default_Options, Result, Outcome);
   New_Line;
   AUnit.Reporter.Text.Report
     (Reporter, Result, AUnit.Options.Default_Options);

   Guard.Done;
   Programs.Remove_Temporary_Folder;
   if Scenarios.Repeated_Count > 0 then
      Put_Line
        (Image (Scenarios.Repeated_Count)
         & " run again because the machine stood still");
   end if;
   if Scenarios.Not_Judged_Count > 0 then
      Put_Line
        (Image (Scenarios.Not_Judged_Count)
         & " not judged, as the machine stood still each time:"
         & Scenarios.Not_Judged_Names);
   end if;
   if Scenarios.Skipped_Count > 0 then
      Put_Line (Image (Scenarios.Skipped_Count) & " skipped");
   end if;
   Put_Line
     (Image (Scenarios.Run_Count - Scenarios.Failed_Count
             - Scenarios.Skipped_Count - Scenarios.Not_Judged_Count)
      & " passed, " & Image (Scenarios.Failed_Count) & " failed");
   GNAT.OS_Lib.OS_Exit
     (if Outcome = AUnit.Success
        and then Scenarios.Failed_Count = 0
        and then Scenarios.Run_Count > Scenarios.Skipped_Count
      then 0 else 1);

exception
   when Occurrence : Option_Readers.Bad_Usage =>
      Programs.Give_Up (Ada.Exceptions.Exception_Message (Occurrence));
   when Occurrence : others =>
      Programs.Give_Up (Ada.Exceptions.Exception_Information (Occurrence));
end System_Tests;
