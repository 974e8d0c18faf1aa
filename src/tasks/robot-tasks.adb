--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;     use Ada.Real_Time;
with Journal;
with Monitor.Mailboxes;
with Monitor.Notices;
with Monitor.Outbox;
with Monitor.Protocol;
with Options;
with Orders;
with Process.Threads;
with Robot.Clients;
with Robot.Events;
with Robot.Exchange;
with Robot.Line;
with Robot.Line_Status; use Robot.Line_Status;
with Robot.Reload_Times; use Robot.Reload_Times;
with Robot.Requests;
with Robot.Serial_Line;
with Robot.Session;     use Robot.Session;
with Task_Ports;
with Trace;

package body Robot.Tasks with SPARK_Mode is

   use type Robot.Requests.Client;
   use type Robot.Requests.Verdict_Kind;

   Max_Idle_Failures : constant := 2;
   --  A robot that is not started and has left as many pings without an answer
   --  is off, and is asked no more: its line stays open

   procedure Tell_Of (Note : Note_Kind; Empty : Boolean) is
      --  What the monitor and the log learn of Note. Empty: the robot's
      --  battery, when last asked
      Gone : Boolean;
   begin
      case Note is
         when Nothing =>
            null;
         when Missed_Window =>
            Journal.Put
              (Options.Warning,
               "watchdog reload outside its window: the robot runs on");
         when Not_Running =>
            Journal.Put
              (Options.Warning,
               Monitor.Notices.Text_Of (Monitor.Notices.Robot_Not_Running));
            Monitor.Outbox.Put
              (Monitor.Mailboxes.Told (Monitor.Notices.Robot_Not_Running));
         when Robot_Lost =>
            Robot.Serial_Line.Get_Gone (Gone);
            Journal.Put
              (Options.Warning,
               (if Gone then
                   "robot lost: the device of its line has gone"
                elsif Empty then
                   Monitor.Notices.Text_Of (Monitor.Notices.Robot_Lost_Empty)
                else "robot lost: four failures in a row, its line is "
                  & "closed"));
            Monitor.Outbox.Put
              ((Kind   => Monitor.Mailboxes.Lost,
                Line   => Monitor.Protocol.Timed_Out,
                others => <>));
            if Empty then
               Monitor.Outbox.Put
                 (Monitor.Mailboxes.Told (Monitor.Notices.Robot_Lost_Empty));
            end if;
      end case;
   end Tell_Of;

   procedure Tell_Of_Start (Mode : Mode_Kind) is
      --  The robot has begun to run: sets the periodic tasks going
   begin
      Robot.Events.Started (With_Watchdog => Mode = Started_With_Watchdog);
      Journal.Put
        (Options.Info,
         (if Mode = Started_With_Watchdog then "robot started with watchdog"
          else "robot started without watchdog"));
   end Tell_Of_Start;

   procedure Skip_Past (Next : in out Time; Period : Time_Span) is
      --  Next on its grid, in the future: periods that could not be kept are
      --  left out, not caught up with
      Now : constant Time := Clock;
   begin
      while Next <= Now loop
         Next := Next + Period;
      end loop;
   end Skip_Past;

   task body Th_Line is
      Held   : Dialogue;
      Job    : Robot.Requests.Job;
      Result : Outcome;
      Ended  : Time;
   begin
      Process.Threads.Name_Task (Schedule.Th_Line);
      loop
         pragma Loop_Invariant (not Job.Order.Owed);
         Robot.Line.Take (Job);
         if Job.Verdict = Robot.Requests.Carry_Out then
            Robot.Exchange.Carry_Out (Held, Job.Request, Result);
         else
            Result :=
              (Kind   =>
                 (if Job.Verdict = Robot.Requests.Late then Timed_Out
                  else Refused),
               others => <>);
         end if;
         Ended := Clock;
         Robot.Line.Finish (Job, Held, Result, Ended);
         if Robot.Line_Status.Starts (Job, Result) then
            Tell_Of_Start (Held.State.Mode);
         end if;
         if Job.Order.Owed then
            Monitor.Outbox.Answer
              (Job.Order,
               Monitor.Protocol.Reply_To (Job.Order.Command.Name, Result));
         end if;
         if Job.From /= Robot.Requests.Stop_Order then
            Robot.Clients.Signal (Job.From);
         end if;
         Tell_Of (Result.Note, Held.Empty);
         Held.Empty := Held.State.Line_Open
           and then
             (if Job.Request.Kind = Get_Battery and then Result.Kind = Done
              then Is_Zero (Result) else Held.Empty);
      end loop;
   end Th_Line;

   task body Th_Open_Com_Robot is
      Order : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Open_Com_Robot);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Task_Ports.Open_Robot.Wait (Order);
         Robot.Clients.Open.Ask (Order);
      end loop;
   end Th_Open_Com_Robot;

   task body Th_Start_Robot is
      Order : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Start_Robot);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Task_Ports.Start_Robot.Wait (Order);
         Robot.Clients.Start.Ask (Order);
      end loop;
   end Th_Start_Robot;

   task body Th_Start_Robot_WD is
      Order : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Start_Robot_WD);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Task_Ports.Start_Robot_Watchdog.Wait (Order);
         Robot.Clients.Start_Watchdog.Ask (Order);
      end loop;
   end Th_Start_Robot_WD;

   task body Th_Reload_WD is
      Begun      : Status;
      Now        : Status;
      Next       : Time;
      Result     : Outcome;
      Unanswered : Unanswered_Count;
   begin
      Process.Threads.Name_Task (Schedule.Th_Reload_WD);
      loop
         Robot.Events.Wait_Reload;
         Robot.Line.Get_Status (Begun);
         Now := Begun;
         Unanswered := 0;
         Next := Begun.Counts_From + Schedule.Reload_Period;
         while Same_Run (Now, Begun)
           and then Now.Mode = Started_With_Watchdog
         loop
            Robot.Line.Set_Reload_Due (Next);
            Trace.Done (Schedule.Th_Reload_WD);
            delay until Next;
            Trace.Start (Schedule.Th_Reload_WD, Next);
            --  a run that has begun meanwhile has its own reloads
            Robot.Clients.Reload.Ask
              (Begun, (Kind => Reload, others => <>), Result);
            Robot.Line.Get_Status (Now);
            if Now.Counts_From > Next + Schedule.Reload_Quiet then
               --  the line was not free
               Next := Now.Counts_From;
            end if;
            Unanswered :=
              (if Result.Kind = Timed_Out then
                  Unanswered_Count'Min (Unanswered, 1) + 1
               else 0);
            Next := Next + Milliseconds (Interval_After (Unanswered));
            Skip_Past (Next, Schedule.Reload_Period);
         end loop;
      end loop;
   end Th_Reload_WD;

   task body Th_Reset_Robot is
      Order : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Reset_Robot);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Task_Ports.Reset_Robot.Wait (Order);
         Robot.Clients.Reset.Ask (Order);
      end loop;
   end Th_Reset_Robot;

   task body Th_Move is
      Order : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Move);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Task_Ports.Move.Wait (Order);
         Robot.Clients.Move.Ask (Order);
      end loop;
   end Th_Move;

   task body Th_Battery_Level is
      Begun  : Status;
      Now    : Status;
      Next   : Time;
      Result : Outcome;
   begin
      Process.Threads.Name_Task (Schedule.Th_Battery_Level);
      loop
         Robot.Events.Wait_Battery;
         Robot.Line.Get_Status (Begun);
         Now := Begun;
         Next := Begun.Counts_From + Schedule.Battery_Offset;
         while Same_Run (Now, Begun) loop
            Trace.Done (Schedule.Th_Battery_Level);
            delay until Next;
            Trace.Start (Schedule.Th_Battery_Level, Next);
            Robot.Line.Get_Status (Now);
            if Same_Run (Now, Begun) then
               Robot.Clients.Battery.Ask
                 ((Kind => Get_Battery, others => <>), Result);
               Robot.Line.Get_Status (Now);
               if Same_Run (Now, Begun) then
                  Monitor.Outbox.Put
                    ((Kind   => Monitor.Mailboxes.Level,
                      Line   => Monitor.Protocol.Battery_Notice (Result),
                      others => <>));
               end if;
            end if;
            Next := Next + Schedule.Battery_Period;
            Skip_Past (Next, Schedule.Battery_Period);
         end loop;
      end loop;
   end Th_Battery_Level;

   task body Th_Query is
      Order : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Query);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Task_Ports.Query.Wait (Order);
         Robot.Clients.Query.Ask (Order);
      end loop;
   end Th_Query;

   task body Th_Keep_Alive is
      Begun   : Status;
      Now     : Status;
      Next    : Time;
      Ignored : Outcome;
   begin
      Process.Threads.Name_Task (Schedule.Th_Keep_Alive);
      loop
         Robot.Events.Wait_Keep_Alive;
         Robot.Line.Get_Status (Begun);
         if Begun.Mode = Not_Started
           and then Begun.Open
           and then Begun.Failures < Max_Idle_Failures
         then
            Robot.Clients.Keep_Alive.Ask
              ((Kind => Keep_Alive, others => <>), Ignored);
         end if;
         Now := Begun;
         Next := Begun.Counts_From + Schedule.Keep_Alive_Period;
         while Same_Run (Now, Begun) loop
            Trace.Done (Schedule.Th_Keep_Alive);
            delay until Next;
            Trace.Start (Schedule.Th_Keep_Alive, Next);
            Robot.Line.Get_Status (Now);
            if Same_Run (Now, Begun)
              and then Next - Now.Used_At >= Schedule.Idle_Line
            then
               Robot.Clients.Keep_Alive.Ask
                 ((Kind => Keep_Alive, others => <>), Ignored);
            end if;
            Next := Next + Schedule.Keep_Alive_Period;
            Skip_Past (Next, Schedule.Keep_Alive_Period);
         end loop;
      end loop;
   end Th_Keep_Alive;

end Robot.Tasks;
