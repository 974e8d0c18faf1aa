--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and what is known of the
--  robot. Urgency decides: the end of a session, a stop, the reload of the
--  watchdog, a movement, then the rest.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Line_Health;
with Schedule;

package body Robot_Line with SPARK_Mode is

   use type Orders.Ticket;
   use type Robot_Session.Mode_Kind;
   use type Robot_Session.Outcome_Kind;
   use type Robot_Session.Request_Kind;

   type Slot is record
      Pending : Boolean := False;
      Request : Robot_Session.Request;
      Order   : Orders.Order;
      Result  : Robot_Session.Outcome;
   end record;

   type Slot_Array is array (Client) of Slot;
   type Stop_Array is array (1 .. Orders.Capacity) of Orders.Order;
   subtype Stop_Index is Positive range 1 .. Orders.Capacity;

   function Changes_Session (Kind : Robot_Session.Request_Kind) return Boolean
   is (Kind in Robot_Session.Open_Line | Robot_Session.Close_Line
         | Robot_Session.Start | Robot_Session.Start_Watchdog
         | Robot_Session.Reset | Robot_Session.Power_Off);
   --  These keep their place among the orders: all earlier ones come before
   --  them and all later ones after. Stops alone go past them

   Work : Suspension_Object;

   protected Line with Priority => Schedule.Line_Ceiling is
      procedure Begin_Session (Number : Orders.Ticket);
      procedure Put
        (From    : Client;
         Request : Robot_Session.Request;
         Order   : Orders.Order);
      procedure Put_Stop (Order : Orders.Order);
      procedure Set_Reload_Due (At_Time : Time);
      procedure Get_Ready (Now : out Boolean);
      procedure Take (Next : out Job; Found : out Boolean; Now : Time);
      procedure Finish
        (Done    : Job;
         State   : Robot_Session.State;
         Result  : Robot_Session.Outcome;
         At_Time : Time);
      procedure Collect
        (From : Client; Result : out Robot_Session.Outcome);
      procedure Get_Status (Value : out Status);
   private
      Slots       : Slot_Array;
      Stops       : Stop_Array;
      First_Stop  : Stop_Index := 1;
      Stop_Count  : Orders.Order_Count := 0;
      Last_Stop   : Orders.Ticket := 0;
      Session     : Orders.Ticket := 1;  --  its first order
      Completed   : Orders.Ticket := 0;  --  orders of the session, but stops
      Changed     : Orders.Ticket := 0;  --  rank of the last that changed it
      Reload_Due  : Time := Time_First;
      Suspect     : Boolean := False;
      Current     : Status;
      Ready       : Boolean := False;
   end Line;

   protected body Line is

      function Verdict (C : Client) return Verdict_Kind is
        (if Slots (C).Order.Number = 0 then Carry_Out
         elsif Slots (C).Order.Number < Session then Out_Of_Date
         elsif C = Move and then Slots (C).Order.Number < Last_Stop
         then Overtaken
         else Carry_Out);

      function In_Turn (C : Client) return Boolean is
        (Slots (C).Order.Number = 0
         or else Verdict (C) = Out_Of_Date
         or else
           (if Changes_Session (Slots (C).Request.Kind)
            then Completed + 1 = Slots (C).Order.Rank
            else Slots (C).Order.After <= Changed));

      function Quiet (Now : Time) return Boolean is
        (Current.Mode = Robot_Session.Started_With_Watchdog
         and then Now >= Reload_Due -
           (if Suspect then Schedule.Reload_Quiet_Suspect
            else Schedule.Reload_Quiet)
         and then Now < Reload_Due + Schedule.Reload_Quiet);

      procedure Refresh;
      procedure Refresh is
      begin
         Ready := Stop_Count > 0
           or else (for some C in Client =>
                      Slots (C).Pending and then In_Turn (C));
      end Refresh;

      procedure Begin_Session (Number : Orders.Ticket) is
      begin
         Session := Number;
         Stop_Count := 0;
         Last_Stop := 0;
         Completed := 0;
         Changed := 0;
         Refresh;
      end Begin_Session;

      procedure Put
        (From    : Client;
         Request : Robot_Session.Request;
         Order   : Orders.Order) is
      begin
         Slots (From).Pending := True;
         Slots (From).Request := Request;
         Slots (From).Order := Order;
         Refresh;
      end Put;

      procedure Put_Stop (Order : Orders.Order) is
      begin
         if Stop_Count < Orders.Capacity then
            Stops ((First_Stop - 1 + Stop_Count) mod Orders.Capacity + 1) :=
              Order;
            Stop_Count := Stop_Count + 1;
         end if;
         Last_Stop := Order.Number;
         Refresh;
      end Put_Stop;

      procedure Set_Reload_Due (At_Time : Time) is
      begin
         Reload_Due := At_Time;
         Refresh;
      end Set_Reload_Due;

      procedure Get_Ready (Now : out Boolean) is
      begin
         Now := Ready;
      end Get_Ready;

      procedure Take (Next : out Job; Found : out Boolean; Now : Time) is

         procedure Choose (C : Client);
         procedure Choose (C : Client) is
         begin
            Next := (From    => C,
                     Request => Slots (C).Request,
                     Order   => Slots (C).Order,
                     Verdict => Verdict (C));
            Slots (C).Pending := False;
            Found := True;
         end Choose;

         Best : Client := Keep_Alive;
      begin
         Next := (others => <>);
         Found := False;
         if Slots (Safe_State).Pending then
            Choose (Safe_State);
         elsif Stop_Count > 0 then
            Next := (From    => Stop_Order,
                     Request => (Kind => Robot_Session.Stop, others => <>),
                     Order   => Stops (First_Stop),
                     Verdict => Carry_Out);
            First_Stop := First_Stop mod Orders.Capacity + 1;
            Stop_Count := Stop_Count - 1;
            Found := True;
         elsif Slots (Reload).Pending then
            Choose (Reload);
         elsif Slots (Move).Pending and then In_Turn (Move) then
            Choose (Move);
         elsif not Quiet (Now) then
            if Slots (Battery).Pending then
               Choose (Battery);
            else
               --  the rest in the order of the commands
               for C in Client range Open .. Query loop
                  if Slots (C).Pending and then In_Turn (C)
                    and then (not Found
                              or else Slots (C).Order.Number
                                < Slots (Best).Order.Number)
                  then
                     Best := C;
                     Found := True;
                  end if;
               end loop;
               if Found then
                  Choose (Best);
               elsif Slots (Keep_Alive).Pending then
                  Choose (Keep_Alive);
               end if;
            end if;
         end if;
         if Found then
            Refresh;
         else
            --  the reload that is due will make it ready again
            Ready := False;
         end if;
      end Take;

      procedure Finish
        (Done    : Job;
         State   : Robot_Session.State;
         Result  : Robot_Session.Outcome;
         At_Time : Time)
      is
         Began : constant Boolean :=
           Done.Request.Kind in
             Robot_Session.Start | Robot_Session.Start_Watchdog
           and then Done.Verdict = Carry_Out
           and then Result.Kind = Robot_Session.Done;
      begin
         Slots (Done.From).Result := Result;
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
         if Done.Order.Number >= Session and then Done.Order.Rank > 0 then
            Completed := Completed + 1;
            if Changes_Session (Done.Request.Kind) then
               Changed := Done.Order.Rank;
            end if;
         end if;
         Refresh;
      end Finish;

      procedure Collect
        (From : Client; Result : out Robot_Session.Outcome) is
      begin
         Result := Slots (From).Result;
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
      Set_True (Work);
   end Begin_Session;

   ---------
   -- Put --
   ---------

   procedure Put
     (From    : Client;
      Request : Robot_Session.Request;
      Order   : Orders.Order := (others => <>)) is
   begin
      Line.Put (From, Request, Order);
      Set_True (Work);
   end Put;

   --------------
   -- Put_Stop --
   --------------

   procedure Put_Stop (Order : Orders.Order) is
   begin
      Line.Put_Stop (Order);
      Set_True (Work);
   end Put_Stop;

   --------------------
   -- Set_Reload_Due --
   --------------------

   procedure Set_Reload_Due (At_Time : Ada.Real_Time.Time) is
   begin
      Line.Set_Reload_Due (At_Time);
      Set_True (Work);
   end Set_Reload_Due;

   ----------
   -- Take --
   ----------

   procedure Take (Next : out Job; Found : out Boolean) is
      Now   : Time;
      Ready : Boolean;
   begin
      loop
         Line.Get_Ready (Ready);
         exit when Ready;
         Suspend_Until_True (Work);
      end loop;
      Now := Clock;
      Line.Take (Next, Found, Now);
   end Take;

   ------------
   -- Finish --
   ------------

   procedure Finish
     (Done   : Job;
      State  : Robot_Session.State;
      Result : Robot_Session.Outcome;
      At_Time : Ada.Real_Time.Time) is
   begin
      Line.Finish (Done, State, Result, At_Time);
   end Finish;

   -------------
   -- Collect --
   -------------

   procedure Collect (From : Client; Result : out Robot_Session.Outcome) is
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
