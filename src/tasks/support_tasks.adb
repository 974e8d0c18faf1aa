--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Commands;
with Console;
with Journal;
with Monitor.Session;
with Monitor.Sockets.Connection;
with Options;
with Process.Signals;
with Process.Threads;
with Robot.Line;
with Robot.Line_Status;
with Robot.Serial_Line;
with Texts;
with Trace;
with Vision.State;

package body Support_Tasks with SPARK_Mode is

   use type Monitor.Session.Stage_Kind;
   use type Process.Signals.Kind;

   task body Th_Console is
      Item : Journal.Line;
      Text : Texts.Text;
   begin
      Process.Threads.Name_Task (Schedule.Th_Console);
      loop
         Journal.Take (Item);
         --  "[seconds.milliseconds] level: text"
         Texts.Set (Text, "[");
         Trace.Append_Time
           (Text, Time_Of (0, To_Time_Span (Item.At_Time)),
            Step => 1_000_000, Width => 3);
         Texts.Append (Text, "] " & Options.Name_Of (Item.Level) & ": ");
         Texts.Append (Text, Item.Text (1 .. Item.Length));
         Console.Put_Log (Text.Data (1 .. Text.Length));
      end loop;
   end Th_Console;

   procedure Wait_Session_End (Limit : Time) is
      --  Waits until the session has ended, Limit at most
      Known  : Monitor.Session.Status;
      Status : Robot.Line_Status.Status;
      Idle   : Boolean;
      Now    : Time;
   begin
      loop
         Monitor.Session.State.Get (Known);
         Robot.Line.Grant.Get_Status (Status);
         Vision.State.Store.Get_Idle (Idle);
         exit when Known.Stage = Monitor.Session.Free
           and then not Status.Held.State.Line_Open and then Idle;
         Now := Clock;
         exit when Now >= Limit;
         Process.Threads.Sleep_Until
           (Schedule.Th_Stop, Now + Schedule.Release_Poll, Trace.Tasks);
      end loop;
   end Wait_Session_End;

   procedure Wait_Console is
      --  Waits until the log has been written, Console_Limit at most
      Waiting : Natural;
      Now     : Time := Clock;
      Limit   : constant Time := Now + Schedule.Console_Limit;
   begin
      loop
         Journal.Get_Waiting (Waiting);
         exit when Waiting = 0;
         Now := Clock;
         exit when Now >= Limit;
         delay until Now + Schedule.Release_Poll;
      end loop;
   end Wait_Console;

   procedure React (Line : String; Of_Stop : Boolean) is
   begin
      Journal.Put (Options.Error, Line);
      if Of_Stop then
         Robot.Serial_Line.Stop_Blindly;
         Stop_Failed.Set;
      else
         Process.Signals.Report_Failure;
      end if;
   end React;

   procedure Finish_Trace is
      Reason : Texts.Text;
   begin
      Trace.Finish (Reason);
      if Reason.Length > 0 then
         Journal.Put
           (Options.Error,
            "the trace is not complete: " & Texts.Image (Reason));
         Wait_Console;
      end if;
   end Finish_Trace;

   task body Th_Stop is
      Kind    : Process.Signals.Kind;
      Status  : Robot.Line_Status.Status;
      Ignored : Boolean;
      Now     : Time;
   begin
      Process.Threads.Name_Task (Schedule.Th_Stop);
      loop
         Process.Signals.Wait (Kind);
         if Kind = Process.Signals.Failure then
            --  whichever task has failed, the robot stops now, for good
            Robot.Line.Grant.Begin_Session (Commands.Ticket'Last);
            Robot.Serial_Line.Stop_Blindly;
         end if;
         Journal.Put (Options.Info, "stopping");
         Monitor.Session.State.Stop;
         Monitor.Sockets.Connection.Shut_Down;
         Now := Clock;
         Wait_Session_End
           (Now + (if Kind = Process.Signals.Failure
                   then Schedule.Failure_Limit else Schedule.Stop_Limit));
         Robot.Line.Grant.Get_Status (Status);
         if Status.Held.State.Line_Open then
            Robot.Serial_Line.Stop_Blindly;
            Robot.Serial_Line.Close (Ignored);
         end if;
         Journal.Put
           (Options.Info,
            (if Kind = Process.Signals.Failure then "stopped after a failure"
             else "stopped"));
         Wait_Console;
         Finish_Trace;
         Process.Leave
           (if Kind = Process.Signals.Failure then Process.Internal_Failure
            else Process.Success);
      end loop;
   end Th_Stop;

end Support_Tasks;
