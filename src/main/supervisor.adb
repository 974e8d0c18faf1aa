--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Checks;
with Command_Lines;
with Commands;
with Console;
with Crashes;
with Failures;
with Journal;
with Monitor.Session;
with Options;
with Process.Privileges;
with Process.Threads;
with Robot.Line;
with Robot.Serial_Line;
with Schedule;
with Settings;
with Texts;
with Trace;

with Mission_Tasks;
with Monitor.Tasks;
with Robot.Tasks;
with Support_Tasks;
with Vision.Library;
with Vision.Tasks;
pragma Unreferenced
  (Mission_Tasks, Monitor.Tasks, Robot.Tasks, Vision.Tasks);

package body Supervisor with SPARK_Mode is

   use type Command_Lines.Request_Kind;
   use type Process.Privileges.Scheduling;
   use type Vision.Library.Status;

   procedure Serve (Chosen : Options.Values);
   --  Runs the tasks; returns when the caller must end the process

   procedure Keep_On_Processor
     (Cpu : Options.Processor_Choice; Claim : out Texts.Text)
   is
      --  Claim: which deadlines hold, by the table of configurations in
      --  proofs/schedulability/README.md. Ends the process if Cpu is not
      --  allowed
      Chosen : Options.Processor_Choice := Cpu;
      Alone  : Boolean;
      Done   : Boolean;
   begin
      Process.Threads.Keep_On (Chosen, Alone, Done);
      if not Done then
         Texts.Set (Claim, "there is no processor ");
         Texts.Append (Claim, Chosen);
         Texts.Append (Claim, " for this process (--cpu)");
         Console.Cannot_Start (Texts.Image (Claim));
      elsif Alone then
         Texts.Set (Claim, "as analysed for one processor");
      elsif Chosen = Options.No_Processor then
         Texts.Set (Claim, "none guaranteed without --cpu");
      else
         Texts.Set (Claim, "as analysed with --cpu, on processor ");
         Texts.Append (Claim, Chosen);
      end if;
   end Keep_On_Processor;

   procedure Open_Trace (Path : Texts.Text) is
      --  Ends the process on failure
      Done   : Boolean;
      Reason : Texts.Text;
   begin
      if Path.Length > 0 then
         Trace.Open (Path, Done, Reason);
         if not Done then
            Console.Cannot_Start
              ("cannot use the trace file " & Texts.Image (Path) & ": "
               & Texts.Image (Reason));
         end if;
      end if;
   end Open_Trace;

   procedure Print_Markers (Chosen : Options.Values) is
      --  Ends the process
      Result : Vision.Library.Status;
      Reason : Vision.Library.Reason_Text;
      Last   : Natural;
   begin
      Vision.Library.Print_Markers
        (Chosen.First_Marker, Chosen.Marker_Size, Result);
      if Result = Vision.Library.Done then
         Process.Leave (Process.Success);
      end if;
      Vision.Library.Reason (Reason, Last);
      Console.Cannot_Start ("no page of markers: " & Reason (1 .. Last));
   end Print_Markers;

   procedure Run is
      Command_Line : Command_Lines.Reading renames Settings.Command_Line;
      All_Well     : Boolean;
      Written      : Boolean;
      Ignored      : Boolean;
      Report       : Texts.Text;
   begin
      if Command_Line.Request = Command_Lines.Check then
         Checks.Run (Command_Line.Chosen, All_Well);
         Process.Leave
           (if All_Well then Process.Success else Process.Cannot_Start);
      elsif Command_Line.Request = Command_Lines.Stop then
         Robot.Serial_Line.Send_Stop
           (Command_Line.Chosen.Serial, All_Well, Report);
         Console.Put (Texts.Image (Report), Written);
         Process.Leave
           (if All_Well and Written then Process.Success
            else Process.Cannot_Start);
      elsif Command_Line.Request = Command_Lines.Print_Markers then
         Print_Markers (Command_Line.Chosen);
      end if;
      Serve (Command_Line.Chosen);
      --  again: orders may have been sent since the failure's stop
      Robot.Serial_Line.Stop_Blindly;
      Robot.Serial_Line.Close (Ignored);
      Support_Tasks.Finish_Trace;
      Process.Leave (Process.Internal_Failure);
   end Run;

   procedure Serve (Chosen : Options.Values) is
      Claim     : Texts.Text;
      Granted   : Process.Privileges.Scheduling;
      Locked    : Boolean;
      Ignored   : Boolean;
      Report    : Texts.Text;
      Now       : Time;
   begin
      Crashes.Catch;
      Open_Trace (Chosen.Trace_File);
      Keep_On_Processor (Chosen.Cpu, Claim);
      Process.Privileges.Lock_Memory (Locked);
      Journal.Set_Level (Chosen.Log_Level);
      --  one that moves has lost its supervisor
      Robot.Serial_Line.Send_Stop (Chosen.Serial, Ignored, Report);
      Monitor.Session.Server_Allowed.Set;
      Monitor.Session.Listening.Wait;
      Process.Privileges.Get (Granted);
      Journal.Put
        (Options.Info,
         "real-time priorities: " & Process.Privileges.Image (Granted)
         & (if Locked then "; memory: locked"
            else "; memory: not locked (CAP_IPC_LOCK, LimitMEMLOCK=infinity)")
         & "; deadlines: "
         & (if Granted /= Process.Privileges.Fifo_With_Ceilings then
               "none guaranteed (destijl --check tells how to get them)"
            elsif Locked then Texts.Image (Claim)
            else "none guaranteed"));
      Journal.Put (Options.Info, Report);

      Failures.Wait_Stop_Failed;
      Robot.Line.Begin_Session (Commands.Ticket'Last);
      --  meanwhile its last lines are written
      Now := Clock;
      delay until Now + Schedule.Console_Limit;
   end Serve;

end Supervisor;
