--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and what is known of the
--  robot. Urgency decides: the end of a session, a stop, the reload of the
--  watchdog, a movement, then the rest.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Line_Health;
with Schedule;
with Trace;

package body Robot_Line with SPARK_Mode is

   use type Line_Requests.Verdict_Kind;
   use type Robot_Session.Mode_Kind;
   use type Robot_Session.Outcome_Kind;
   use type Robot_Session.Request_Kind;

   type Result_Array is
     array (Line_Requests.Client) of Robot_Session.Outcome;

   Work : Suspension_Object;

   protected Line with Priority => Schedule.Line_Ceiling is
      procedure Begin_Session (Number : Orders.Ticket);
      procedure Put
        (From    : Line_Requests.Single;
         Request : Robot_Session.Request;
         Order   : Orders.Order);
      procedure Put_Stop (Order : Orders.Order);
      procedure Set_Reload_Due (At_Time : Time);
      procedure Take
        (Next    : out Line_Requests.Job;
         Found   : out Boolean;
         Looked  : out Boolean;
         At_Time : Time);
      --  Looked: something has come since nothing was found
      procedure Finish
        (Done    : Line_Requests.Job;
         State   : Robot_Session.State;
         Result  : Robot_Session.Outcome;
         At_Time : Time);
      procedure Collect
        (From : Line_Requests.Client; Result : out Robot_Session.Outcome);
      procedure Get_Status (Value : out Status);
   private
      Waiting     : Line_Requests.Requests;
      Results     : Result_Array;
      Reload_Due  : Time := Time_First;
      Suspect     : Boolean := False;
      Current     : Status;
      Ready       : Boolean := False;
   end Line;

   protected body Line is

      function Quiet (Now : Time) return Boolean is
        (Current.Mode = Robot_Session.Started_With_Watchdog
         and then Now >= Reload_Due -
           (if Suspect then Schedule.Reload_Quiet_Suspect
            else Schedule.Reload_Quiet)
         and then Now < Reload_Due + Schedule.Reload_Quiet);

      procedure Refresh is
      begin
         Ready := Line_Requests.Is_Ready (Waiting);
      end Refresh;

      procedure Begin_Session (Number : Orders.Ticket) is
      begin
         Line_Requests.Begin_Session (Waiting, Number);
         Refresh;
      end Begin_Session;

      procedure Put
        (From    : Line_Requests.Single;
         Request : Robot_Session.Request;
         Order   : Orders.Order) is
      begin
         Line_Requests.Put (Waiting, From, Request, Order);
         Refresh;
      end Put;

      procedure Put_Stop (Order : Orders.Order) is
      begin
         Line_Requests.Put_Stop (Waiting, Order);
         Refresh;
      end Put_Stop;

      procedure Set_Reload_Due (At_Time : Time) is
      begin
         Reload_Due := At_Time;
         Refresh;
      end Set_Reload_Due;

      procedure Take
        (Next    : out Line_Requests.Job;
         Found   : out Boolean;
         Looked  : out Boolean;
         At_Time : Time)
      is
         From : Line_Requests.Client;
      begin
         Next := (others => <>);
         Found := False;
         Looked := Ready;
         if Ready then
            Line_Requests.Choose (Waiting, Quiet (At_Time), From, Found);
            if Found then
               Next := Line_Requests.Job_Of (Waiting, From);
               Line_Requests.Remove (Waiting, From);
               Refresh;
            else
               --  the reload that is due will make it ready again
               Ready := False;
            end if;
         end if;
      end Take;

      procedure Finish
        (Done    : Line_Requests.Job;
         State   : Robot_Session.State;
         Result  : Robot_Session.Outcome;
         At_Time : Time)
      is
         Began : constant Boolean :=
           Done.Request.Kind in
             Robot_Session.Start | Robot_Session.Start_Watchdog
           and then Done.Verdict = Line_Requests.Carry_Out
           and then Result.Kind = Robot_Session.Done;
      begin
         Results (Done.From) := Result;
         Suspect := Line_Health.Failures (State.Health) > 0;
         Current.Open := State.Line_Open;
         Current.Mode := State.Mode;
         Current.Used_At := At_Time;
         if Began then
            Current.Epoch :=
              (if Current.Epoch = Natural'Last then 0
               else Current.Epoch + 1);
            Current.Started_At := At_Time;
            Reload_Due := At_Time + Schedule.Reload_Period;
         end if;
         Line_Requests.Finish (Waiting, Done);
         Refresh;
      end Finish;

      procedure Collect
        (From : Line_Requests.Client; Result : out Robot_Session.Outcome) is
      begin
         Result := Results (From);
      end Collect;

      procedure Get_Status (Value : out Status) is
      begin
         Value := Current;
      end Get_Status;

   end Line;

   -------------------
   -- Begin_Session --
   -------------------

   procedure Begin_Session (First : Orders.Ticket) is
   begin
      Line.Begin_Session (First);
      Trace.Release (Schedule.Th_Line);
      Set_True (Work);
   end Begin_Session;

   -------------------
   -- Refuse_Orders --
   -------------------

   procedure Refuse_Orders is
   begin
      Line.Begin_Session (Orders.Ticket'Last);
      Trace.Release (Schedule.Th_Line);
      Set_True (Work);
   end Refuse_Orders;

   ---------
   -- Put --
   ---------

   procedure Put
     (From    : Line_Requests.Single;
      Request : Robot_Session.Request;
      Order   : Orders.Order := (others => <>)) is
   begin
      Line.Put (From, Request, Order);
      Trace.Release (Schedule.Th_Line, Order.Number);
      Set_True (Work);
   end Put;

   --------------
   -- Put_Stop --
   --------------

   procedure Put_Stop (Order : Orders.Order) is
   begin
      Line.Put_Stop (Order);
      Trace.Release (Schedule.Th_Line, Order.Number);
      Set_True (Work);
   end Put_Stop;

   --------------------
   -- Set_Reload_Due --
   --------------------

   procedure Set_Reload_Due (At_Time : Ada.Real_Time.Time) is
   begin
      Line.Set_Reload_Due (At_Time);
      Trace.Release (Schedule.Th_Line);
      Set_True (Work);
   end Set_Reload_Due;

   ----------
   -- Take --
   ----------

   procedure Take (Next : out Line_Requests.Job; Found : out Boolean) is
      Now    : Time;
      Looked : Boolean;
   begin
      Trace.Done (Schedule.Th_Line);
      loop
         Now := Clock;
         Line.Take (Next, Found, Looked, Now);
         exit when Looked;
         Trace.Idle (Schedule.Th_Line);
         Suspend_Until_True (Work);
      end loop;
      if Found then
         Trace.Start (Schedule.Th_Line, Next.Order.Number);
      end if;
   end Take;

   ------------
   -- Finish --
   ------------

   procedure Finish
     (Done    : Line_Requests.Job;
      State   : Robot_Session.State;
      Result  : Robot_Session.Outcome;
      At_Time : Ada.Real_Time.Time) is
   begin
      Line.Finish (Done, State, Result, At_Time);
   end Finish;

   -------------
   -- Collect --
   -------------

   procedure Collect
     (From : Line_Requests.Client; Result : out Robot_Session.Outcome) is
   begin
      Line.Collect (From, Result);
   end Collect;

   ----------------
   -- Get_Status --
   ----------------

   procedure Get_Status (Current : out Status) is
   begin
      Line.Get_Status (Current);
   end Get_Status;

end Robot_Line;
