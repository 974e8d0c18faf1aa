--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks of the robot: six of the report's, the owner of the line, and
--  the periodic ones that a start sets going.

with Ada.Real_Time;    use Ada.Real_Time;
with Journal;
with Line_Exchange;
with Line_Requests;
with Monitor_Protocol; use Monitor_Protocol;
with Orders;
with Options;
with Outbox;
with Process.Threads;
with Robot_Clients;
with Robot_Events;
with Robot_Line;
with Robot_Protocol;
with Robot_Session;    use Robot_Session;
with Task_Ports;
with Texts;
with Trace;

package body Robot_Tasks with SPARK_Mode is

   use type Line_Requests.Client;
   use type Line_Requests.Verdict_Kind;

   function Answer_To (Result : Outcome) return Answer_Kind is
     (case Result.Kind is
         when Done                  => Acknowledged,
         when Refused               => Monitor_Protocol.Refused,
         when Timed_Out             => Monitor_Protocol.Timed_Out,
         when Not_Open | Not_Opened => Not_Done);

   procedure Tell_Of (Note : Note_Kind);
   --  What the monitor and the log learn of Note

   function Drive_Command (M : Message) return Movement is
     (case M.Kind is
         when Go_Forward  => Robot_Protocol.Forward,
         when Go_Backward => Robot_Protocol.Backward,
         when Go_Left     => Robot_Protocol.Left,
         when Go_Right    => Robot_Protocol.Right,
         when Move_Robot  => (Robot_Protocol.Move, M.Value),
         when Turn_Robot  => (Robot_Protocol.Turn, M.Value),
         when others      => Robot_Protocol.Stop);

   function Same_Run (Now, Before : Robot_Line.Status) return Boolean is
     (Now.Mode /= Not_Started and then Now.Epoch = Before.Epoch);
   --  The robot has been running since Before without a new start

   procedure Skip_Past (Next : in out Time; Period : Time_Span);
   --  Next on its grid, in the future: periods that could not be kept are
   --  left out, not caught up with

   -------------
   -- Tell_Of --
   -------------

   procedure Tell_Of (Note : Note_Kind) is
      Text : Texts.Text;
   begin
      case Note is
         when Nothing =>
            null;
         when Missed_Window =>
            Journal.Put
              (Options.Warning,
               "watchdog reload outside its window: the robot runs on");
         when Not_Running =>
            Texts.Set
              (Text, "robot no longer runs (watchdog or reset): start again");
            Journal.Put (Options.Warning, Text);
            Outbox.Put_Text (Text);
         when Robot_Lost =>
            Journal.Put
              (Options.Warning,
               "robot lost: four failures in a row, its line is closed");
            Outbox.Put_Robot_Lost;
      end case;
   end Tell_Of;

   ---------------
   -- Skip_Past --
   ---------------

   procedure Skip_Past (Next : in out Time; Period : Time_Span) is
      Now : constant Time := Clock;
   begin
      while Next <= Now loop
         Next := Next + Period;
      end loop;
   end Skip_Past;

   -------------
   -- Th_Line --
   -------------

   task body Th_Line is
      State  : Robot_Session.State;
      Job    : Line_Requests.Job;
      Found  : Boolean;
      Result : Outcome;
      Ended  : Time;
   begin
      Process.Threads.Name_Task ("th_line");
      loop
         pragma Loop_Invariant (Is_Consistent (State));
         Robot_Line.Take (Job, Found);
         if Found then
            if Job.Verdict = Line_Requests.Carry_Out then
               Line_Exchange.Carry_Out (State, Job.Request, Result);
            else
               Result := (Kind => Refused, others => <>);
            end if;
            Ended := Clock;
            Robot_Line.Finish (Job, State, Result, Ended);
            if Job.From = Line_Requests.Stop_Order then
               Outbox.Answer (Job.Order.Number, Answer_To (Result));
            else
               Robot_Clients.Signal (Job.From);
            end if;
            Tell_Of (Result.Note);
         end if;
      end loop;
   end Th_Line;

   -----------------------
   -- Th_Open_Com_Robot --
   -----------------------

   task body Th_Open_Com_Robot is
      Order  : Orders.Order;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_open_com_rob");
      loop
         Task_Ports.Open_Robot.Wait (Order);
         if Order.Message.Kind = Open_Robot then
            Robot_Clients.Open.Ask
              ((Kind => Open_Line, others => <>), Order, Result);
         else
            Robot_Clients.Open.Ask
              ((Kind => Close_Line, others => <>), Order, Result);
         end if;
         Outbox.Answer (Order.Number, Answer_To (Result));
      end loop;
   end Th_Open_Com_Robot;

   --------------------
   -- Th_Start_Robot --
   --------------------

   task body Th_Start_Robot is
      Order  : Orders.Order;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_start_robot");
      loop
         Task_Ports.Start_Robot.Wait (Order);
         Robot_Clients.Start.Ask
           ((Kind => Start, others => <>), Order, Result);
         if Result.Kind = Done then
            Robot_Events.Started (With_Watchdog => False);
            Journal.Put (Options.Info, "robot started without watchdog");
         end if;
         Outbox.Answer (Order.Number, Answer_To (Result));
      end loop;
   end Th_Start_Robot;

   -----------------------
   -- Th_Start_Robot_WD --
   -----------------------

   task body Th_Start_Robot_WD is
      Order  : Orders.Order;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_start_robot_");
      loop
         Task_Ports.Start_Robot_Watchdog.Wait (Order);
         Robot_Clients.Start_Watchdog.Ask
           ((Kind => Start_Watchdog, others => <>), Order, Result);
         if Result.Kind = Done then
            Robot_Events.Started (With_Watchdog => True);
            Journal.Put (Options.Info, "robot started with watchdog");
         end if;
         Outbox.Answer (Order.Number, Answer_To (Result));
      end loop;
   end Th_Start_Robot_WD;

   ------------------
   -- Th_Reload_WD --
   ------------------

   task body Th_Reload_WD is
      Begun  : Robot_Line.Status;
      Now    : Robot_Line.Status;
      Next   : Time;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_reload_wd");
      loop
         Robot_Events.Wait_Reload;
         Robot_Line.Get_Status (Begun);
         Now := Begun;
         Next := Begun.Started_At + Schedule.Reload_Period;
         while Same_Run (Now, Begun)
           and then Now.Mode = Started_With_Watchdog
         loop
            Robot_Line.Set_Reload_Due (Next);
            Trace.Done (Schedule.Th_Reload_WD);
            delay until Next;
            Trace.Start (Schedule.Th_Reload_WD, Next);
            Robot_Line.Get_Status (Now);
            --  a run that has begun meanwhile has its own reloads
            exit when not Same_Run (Now, Begun);
            Robot_Clients.Reload.Ask
              ((Kind => Reload, others => <>), (others => <>), Result);
            Robot_Line.Get_Status (Now);
            if Result.Kind = Refused then
               --  the robot has begun to count anew
               Next := Now.Used_At;
            end if;
            Next := Next + Schedule.Reload_Period;
            Skip_Past (Next, Schedule.Reload_Period);
         end loop;
      end loop;
   end Th_Reload_WD;

   --------------------
   -- Th_Reset_Robot --
   --------------------

   task body Th_Reset_Robot is
      Order  : Orders.Order;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_reset_robot");
      loop
         Task_Ports.Reset_Robot.Wait (Order);
         if Order.Message.Kind = Reset_Robot then
            Robot_Clients.Reset.Ask
              ((Kind => Reset, others => <>), Order, Result);
         else
            Robot_Clients.Reset.Ask
              ((Kind => Power_Off, others => <>), Order, Result);
         end if;
         Outbox.Answer (Order.Number, Answer_To (Result));
      end loop;
   end Th_Reset_Robot;

   -------------
   -- Th_Move --
   -------------

   task body Th_Move is
      Order  : Orders.Order;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_move");
      loop
         Task_Ports.Move.Wait (Order);
         Robot_Clients.Move.Ask
           ((Kind => Drive, Command => Drive_Command (Order.Message)),
            Order, Result);
         Outbox.Answer (Order.Number, Answer_To (Result));
      end loop;
   end Th_Move;

   ----------------------
   -- Th_Battery_Level --
   ----------------------

   task body Th_Battery_Level is
      Begun  : Robot_Line.Status;
      Now    : Robot_Line.Status;
      Next   : Time;
      Result : Outcome;
   begin
      Process.Threads.Name_Task ("th_battery_leve");
      loop
         Robot_Events.Wait_Battery;
         Robot_Line.Get_Status (Begun);
         Now := Begun;
         Next := Begun.Started_At + Schedule.Battery_Offset;
         while Same_Run (Now, Begun) loop
            Trace.Done (Schedule.Th_Battery_Level);
            delay until Next;
            Trace.Start (Schedule.Th_Battery_Level, Next);
            Robot_Line.Get_Status (Now);
            if Same_Run (Now, Begun) then
               Robot_Clients.Battery.Ask
                 ((Kind => Get_Battery, others => <>), (others => <>),
                  Result);
               Robot_Line.Get_Status (Now);
               if Same_Run (Now, Begun) then
                  Outbox.Put_Battery
                    (Battery_Answer
                       (if Result.Kind = Done then Result.Value else -1));
               end if;
            end if;
            Next := Next + Schedule.Battery_Period;
            Skip_Past (Next, Schedule.Battery_Period);
         end loop;
      end loop;
   end Th_Battery_Level;

   --------------
   -- Th_Query --
   --------------

   task body Th_Query is
      Order  : Orders.Order;
      Result : Outcome;
      Answer : Answer_Kind;
      Kind   : Request_Kind;
   begin
      Process.Threads.Name_Task ("th_query");
      loop
         Task_Ports.Query.Wait (Order);
         Kind := (case Order.Message.Kind is
                     when Monitor_Protocol.Get_Battery => Get_Battery,
                     when Get_State                    => Get_Moving,
                     when Reload_Watchdog              => Reload_By_Hand,
                     when others                       => Ping);
         Robot_Clients.Query.Ask
           ((Kind => Kind, others => <>), Order, Result);
         Answer := Answer_To (Result);
         if Result.Kind = Done and then Kind = Get_Battery then
            Answer := Battery_Answer (Result.Value);
         elsif Result.Kind = Done and then Kind = Get_Moving then
            Answer := (if Result.Value = 0 then Standing else Moving);
         end if;
         Outbox.Answer (Order.Number, Answer);
      end loop;
   end Th_Query;

   -------------------
   -- Th_Keep_Alive --
   -------------------

   task body Th_Keep_Alive is
      Begun : Robot_Line.Status;
      Now   : Robot_Line.Status;
      Next  : Time;
   begin
      Process.Threads.Name_Task ("th_keep_alive");
      loop
         Robot_Events.Wait_Keep_Alive;
         Robot_Line.Get_Status (Begun);
         Now := Begun;
         Next := Begun.Started_At + Schedule.Keep_Alive_Period;
         while Same_Run (Now, Begun) loop
            Trace.Done (Schedule.Th_Keep_Alive);
            delay until Next;
            Trace.Start (Schedule.Th_Keep_Alive, Next);
            Robot_Line.Get_Status (Now);
            if Same_Run (Now, Begun)
              and then Next - Now.Used_At >= Schedule.Idle_Line
            then
               Robot_Clients.Keep_Alive.Ask
                 ((Kind => Keep_Alive, others => <>));
            end if;
            Next := Next + Schedule.Keep_Alive_Period;
            Skip_Past (Next, Schedule.Keep_Alive_Period);
         end loop;
      end loop;
   end Th_Keep_Alive;

end Robot_Tasks;
