--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the system tests: all but the timed ones; with --timed these, one by
--  one. Arguments without dashes are parts of the names of tests to run, of
--  both kinds; --jobs N: how many at a time. --supervisor, --emulator and
--  --monitor name other programs than those beside this one; --terminals: no
--  preloaded line. It runs itself with --one NAME for a test.

with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with GNAT.OS_Lib;
with System.Multiprocessors;

with Camera_Tests;
with Mission_Tests;
with Mission_Trial_Tests;
with Monitor_Tests;
with Never_Tests;
with Option_Readers;
with Own_Process;
with Process_Tests;
with Programs;
with Radio_Tests;
with Robot_Tests;
with Scenarios;
with Security_Tests;
with Server_Tests;
with Source_Tests;
with Trace_Tests;

procedure System_Tests is

   Jobs : Positive :=
     (if Own_Process.Real_Time_Allowed then 3 else 2)
     * Positive (System.Multiprocessors.Number_Of_CPUs);
   --  Most tests wait most of the time, but what waits without priority is
   --  disturbed by the others
   Done : Boolean;

begin
   Own_Process.Ignore_Broken_Pipes;

   while Option_Readers.Next loop
      if Programs.Read_Option then
         null;
      elsif Option_Readers.Name = "--timed" then
         Scenarios.Select_Timed;
      elsif Option_Readers.Name = "--jobs" then
         Jobs := Option_Readers.Number (1, 64);
      elsif Option_Readers.Name = "--one" then
         Scenarios.Select_One (Option_Readers.Value);
      elsif Index (Option_Readers.Name, "-") = 1 then
         Option_Readers.Refuse;
      else
         Scenarios.Add_Filter (Option_Readers.Name);
      end if;
   end loop;

   --  the longest first
   Never_Tests;
   Robot_Tests;
   Process_Tests;
   Monitor_Tests;
   Security_Tests;
   Server_Tests;
   Radio_Tests;
   Camera_Tests;
   Source_Tests;
   Mission_Tests;
   Mission_Trial_Tests;
   Trace_Tests;

   Scenarios.Run (Jobs, Programs.Beside ("system_tests"), Done);
   GNAT.OS_Lib.OS_Exit (if Done then 0 else 1);

exception
   when Occurrence : others =>
      Programs.Give_Up (Occurrence);
end System_Tests;
