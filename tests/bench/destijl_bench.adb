--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measures what the supervisor takes and what the floor is: one section of
--  tests/bench/report.py, which runs it.

with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with GNAT.OS_Lib;
with Interfaces.C;            use Interfaces.C;

with Bench_Settings;
with Libc;
with Option_Readers;          use Option_Readers;
with Own_Process;
with Programs;
with Report_Deadlines;
with Report_Order_Times;
with Report_Period_Times;
with Report_Responses;
with Report_Task_Times;

procedure Destijl_Bench is

   Section : Unbounded_String;

begin
   Own_Process.Ignore_Broken_Pipes;
   while Next loop
      if Name = "--seconds" then
         Bench_Settings.Seconds := Number;
      elsif Name = "--samples" then
         Bench_Settings.Sample_Count := Number;
      elsif Name = "--service" then
         Bench_Settings.As_Service := True;
      elsif Name = "--file" then
         Bench_Settings.Trace_File := To_Unbounded_String (Value);
      elsif Name = "--out" then
         Bench_Settings.Folder := To_Unbounded_String (Value);
      elsif Name in "orders" | "periods" | "tasks" | "responses" | "deadlines"
      then
         Section := To_Unbounded_String (Name);
      else
         Programs.Read_Option ("see script/bench --help");
      end if;
   end loop;
   if Bench_Settings.As_Service
     and then (Libc.Geteuid /= 0 or else not Own_Process.Real_Time_Allowed)
   then
      raise Bad_Usage with "--service is for root";
   end if;
   if Section = "orders" then
      Report_Order_Times;
   elsif Section = "periods" then
      Report_Period_Times;
   elsif Section = "tasks" then
      Report_Task_Times;
   elsif Section = "responses" then
      Report_Responses;
   elsif Section = "deadlines" then
      Report_Deadlines;
   end if;
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit (0);

exception
   when Problem : others =>
      Programs.Give_Up (Problem);
end Destijl_Bench;
