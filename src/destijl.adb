--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor: reads the command line, says what it will do, and lets
--  its tasks work until the process is ended.

with Ada.Exceptions;
with Ada.Real_Time; use Ada.Real_Time;
with Checks;
with Command_Lines;
with Console;
with Failures;
with Journal;
with Options;
with Process;
with Schedule;
with Serial_Line;
with Session;
with Settings;

with Monitor_Tasks;
with Robot_Tasks;
with Support_Tasks;
with Vision_Tasks;
pragma Unreferenced
  (Monitor_Tasks, Robot_Tasks, Support_Tasks, Vision_Tasks);

procedure Destijl with Priority => Schedule.Main_Priority is

   Request  : Command_Lines.Request_Kind;
   Chosen   : Options.Values;
   All_Well : Boolean;
   Held     : Process.Privilege_Kind;

begin
   Command_Lines.Read (Request, Chosen);
   case Request is
      when Command_Lines.Wrong =>
         Console.Put_Log ("destijl: " & Command_Lines.Reason);
         Console.Put_Log (Command_Lines.Usage);
         Process.Leave (Process.Bad_Usage);
      when Command_Lines.Show_Help =>
         Console.Put (Command_Lines.Usage);
         Process.Leave (Process.Success);
      when Command_Lines.Show_Version =>
         Console.Put (Command_Lines.Version);
         Process.Leave (Process.Success);
      when Command_Lines.Check =>
         Checks.Run (Chosen, All_Well);
         Process.Leave
           (if All_Well then Process.Success else Process.Cannot_Start);
      when Command_Lines.Run =>
         null;
   end case;

   Settings.Set (Chosen);
   Journal.Set_Level (Chosen.Log_Level);
   Session.Allow_Server;
   Session.Wait_Listening;
   Process.Get_Privileges (Held);
   Journal.Put
     (Options.Info,
      (case Held is
          when Process.Root_With_Real_Time =>
             "real-time priorities: yes (FIFO), ceilings checked",
          when Process.User_With_Real_Time =>
             "real-time priorities: yes (FIFO), ceilings not checked",
          when others =>
             "real-time priorities: none, deadlines are not guaranteed "
             & "(destijl --check tells how to get them)"));

   Failures.Wait_Stop_Failed;
   --  its last lines are written meanwhile
   delay until Clock + Schedule.Console_Limit;
   --  once more: orders may have been sent since the failure
   Serial_Line.Stop_Blindly;
   Process.Leave (Process.Internal_Failure);

exception
   when E : others =>
      Console.Put_Log
        ("destijl: internal failure: "
         & Ada.Exceptions.Exception_Information (E));
      Process.Report_Failure;
end Destijl;
