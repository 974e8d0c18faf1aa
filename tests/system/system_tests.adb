--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the system tests; its options are those of Scenarios.

with GNAT.OS_Lib;

with Camera_Tests;
with Mission_Tests;
with Monitor_Tests;
with Never_Tests;
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
   Done : Boolean;
begin
   Own_Process.Ignore_Broken_Pipes;
   Scenarios.Read_Options;

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
   Trace_Tests;

   Scenarios.Run (Done);
   GNAT.OS_Lib.OS_Exit (if Done then 0 else 1);

exception
   when Occurrence : others =>
      Programs.Give_Up (Occurrence);
end System_Tests;
