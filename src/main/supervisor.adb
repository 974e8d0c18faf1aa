--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Checks;
with Command_Lines;
with Commands;
with Console;
with Failures;
with Journal;
with Monitor.Session;
with Options;
with Process.Privileges;
with Process.Threads;
with Robot.Line;
with Robot.Serial_Line;
with Schedule;
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
      --  Ends the process on failure
      Result : Vision.Library.Status;
      Reason : Vision.Library.Reason_Text;
      Last   : Natural;
   begin
      Vision.Library.Print_Markers
        (Chosen.First_Marker, Chosen.Marker_Size, Result);
      if Result /= Vision.Library.Done then
         Vision.Library.Reason (Reason, Last);
         Console.Cannot_Start ("no page of markers: " & Reason (1 .. Last));
      end if;
   end Print_Markers;

   procedure Answer (Asked : Command_Lines.Reading) with No_Return is
      --  What needs no task; then the process ends
      All_Well : Boolean := True;
      Written  : Boolean := True;
      Report   : Texts.Text;
   begin
      case Asked.Request is
         when Command_Lines.Run =>
            null;
         when Command_Lines.Check =>
            Checks.Run (Asked.Chosen, All_Well);
         when Command_Lines.Stop =>
            Robot.Serial_Line.Send_Stop
              (Asked.Chosen.Serial, All_Well, Report);
            Console.Put (Texts.Image (Report), Written);
         when Command_Lines.Print_Markers =>
            Print_Markers (Asked.Chosen);
         when Command_Lines.Show_Version | Command_Lines.Show_Help =>
            Console.Put
              ((if Asked.Request = Command_Lines.Show_Help
                then Command_Lines.Usage else Command_Lines.Version),
               Written);
            if not Written then
               Console.Cannot_Start ("standard output does not take it");
            end if;
         when Command_Lines.Wrong =>
            Console.Put_Log ("destijl: " & Texts.Image (Asked.Reason));
            Console.Put_Log (Command_Lines.Usage);
            Process.Leave (Process.Bad_Usage);
      end case;
      Process.Leave
        (if All_Well and Written then Process.Success
         else Process.Cannot_Start);
   end Answer;

   procedure Run is
      Chosen  : Options.Values renames Command_Lines.Given.Chosen;
      Claim   : Texts.Text;
      Granted : Process.Privileges.Scheduling;
      Locked  : Boolean;
      Ignored : Boolean;
      Report  : Texts.Text;
      Now     : Time;
   begin
      if Command_Lines.Given.Request /= Command_Lines.Run then
         Answer (Command_Lines.Given);
      end if;
      Failures.Catch_Crashes;
      Open_Trace (Chosen.Trace_File);
      Keep_On_Processor (Chosen.Cpu, Claim);
      Process.Privileges.Lock_Memory (Locked);
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
      Journal.Put (Options.Info, Texts.Image (Report));

      Support_Tasks.Stop_Failed.Wait;
      Robot.Line.Grant.Begin_Session (Commands.Ticket'Last);
      --  meanwhile its last lines are written
      Now := Clock;
      delay until Now + Schedule.Console_Limit;
      --  again: orders may have been sent since the failure's stop
      Robot.Serial_Line.Stop_Blindly;
      Robot.Serial_Line.Close (Ignored);
      Support_Tasks.Finish_Trace;
      Process.Leave (Process.Internal_Failure);
   end Run;

begin
   pragma SPARK_Mode (Off);
   --  Off: in SPARK an elaboration has no effect outside. Here no task has
   --  started yet, and none is needed
   if Command_Lines.Given.Request in Command_Lines.Settled_Kind then
      Answer (Command_Lines.Given);
   end if;
end Supervisor;
