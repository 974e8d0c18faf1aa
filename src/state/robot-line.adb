--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Robot.Requests and Robot.Line_Status decide.

with Ada.Real_Time; use Ada.Real_Time;
with Commands;
with Event;
with Schedule;
with Settings;
with Trace;

package body Robot.Line with SPARK_Mode is

   type Result_Array is
     array (Robot.Requests.Client) of Robot.Session.Outcome;

   package Work is new Event;

   protected Line with Priority => Schedule.Line_Ceiling is
      procedure Begin_Session (First : Orders.Ticket);
      procedure Put
        (From    : Robot.Requests.Single;
         Request : Robot.Session.Request;
         Order   : Orders.Order);
      procedure Put_In_Run
        (From    : Robot.Requests.Single;
         Request : Robot.Session.Request;
         Run     : Robot.Line_Status.Status;
         Same    : out Boolean);
      procedure Put_Stop (Order : Orders.Order);
      procedure Put_For_Mission
        (Request : Robot.Session.Request; Order : Orders.Order; Now : Time);
      procedure Note_Hand (Number : Orders.Ticket);
      procedure Set_Reload_Due (At_Time : Time);
      procedure Take
        (Now            : Time;
         Answer_Timeout : Time_Span;
         Next           : in out Robot.Requests.Job;
         Found          : out Boolean);
      procedure Finish
        (Done   : Robot.Requests.Job;
         Held   : Robot.Line_Status.Dialogue;
         Result : Robot.Session.Outcome;
         Now    : Time;
         More   : out Boolean);
      procedure Collect
        (From : Robot.Requests.Client; Result : out Robot.Session.Outcome);
      procedure Get_Status (Current : out Robot.Line_Status.Status);
      procedure Get_Rights
        (Number : Orders.Ticket; Is_Over, By_Hand : out Boolean);
   private
      Waiting : Robot.Requests.Requests;
      Results : Result_Array;
      State   : Robot.Line_Status.State;
      Asked   : Time := Time_First;
      --  when the mission made its last request
   end Line;

   protected body Line is

      procedure Begin_Session (First : Orders.Ticket) is
      begin
         Robot.Requests.Begin_Session (Waiting, First);
      end Begin_Session;

      procedure Put
        (From    : Robot.Requests.Single;
         Request : Robot.Session.Request;
         Order   : Orders.Order) is
      begin
         Robot.Requests.Put (Waiting, From, Request, Order);
      end Put;

      procedure Put_In_Run
        (From    : Robot.Requests.Single;
         Request : Robot.Session.Request;
         Run     : Robot.Line_Status.Status;
         Same    : out Boolean) is
      begin
         Same := Robot.Line_Status.Same_Run (State.Known, Run);
         if Same then
            Robot.Requests.Put (Waiting, From, Request, (others => <>));
         end if;
      end Put_In_Run;

      procedure Put_Stop (Order : Orders.Order) is
      begin
         Robot.Requests.Put_Stop (Waiting, Order);
      end Put_Stop;

      procedure Put_For_Mission
        (Request : Robot.Session.Request; Order : Orders.Order; Now : Time) is
      begin
         Robot.Requests.Put
           (Waiting, Robot.Requests.Mission, Request, Order);
         Asked := Now;
      end Put_For_Mission;

      procedure Note_Hand (Number : Orders.Ticket) is
      begin
         Robot.Requests.Note_Hand (Waiting, Number);
      end Note_Hand;

      procedure Set_Reload_Due (At_Time : Time) is
      begin
         State.Reload_Due := At_Time;
      end Set_Reload_Due;

      procedure Take
        (Now            : Time;
         Answer_Timeout : Time_Span;
         Next           : in out Robot.Requests.Job;
         Found          : out Boolean) is
      begin
         Robot.Requests.Take
           (R       => Waiting,
            Quiet   => Robot.Line_Status.Is_Quiet
              (State, Now, Answer_Timeout),
            Is_Late => Now > Asked + Schedule.Mission_Order_Limit,
            Next    => Next,
            Found   => Found);
      end Take;

      procedure Finish
        (Done   : Robot.Requests.Job;
         Held   : Robot.Line_Status.Dialogue;
         Result : Robot.Session.Outcome;
         Now    : Time;
         More   : out Boolean) is
      begin
         Results (Done.From) := Result;
         Robot.Line_Status.Note (State, Done, Held, Result, Now);
         Robot.Requests.Finish (Waiting, Done);
         More := Robot.Requests.Is_Ready (Waiting);
      end Finish;

      procedure Collect
        (From : Robot.Requests.Client; Result : out Robot.Session.Outcome) is
      begin
         Result := Results (From);
      end Collect;

      procedure Get_Status (Current : out Robot.Line_Status.Status) is
      begin
         Current := State.Known;
      end Get_Status;

      procedure Get_Rights
        (Number : Orders.Ticket; Is_Over, By_Hand : out Boolean) is
      begin
         Is_Over := Number < Waiting.First_Order;
         By_Hand := Number < Waiting.Last_Hand;
      end Get_Rights;

   end Line;

   procedure Wake (Number : Orders.Ticket := 0)
   with Annotate => (GNATprove, Terminating)
   is
      --  Wakes the owner of the line
   begin
      Trace.Release (Schedule.Th_Line, Number);
      Work.Set;
   end Wake;

   procedure Begin_Session (First : Orders.Ticket) is
   begin
      Line.Begin_Session (First);
      Wake;
   end Begin_Session;

   procedure Refuse_Orders is
   begin
      Begin_Session (Orders.Ticket'Last);
   end Refuse_Orders;

   procedure Put
     (From : Robot.Requests.Single; Request : Robot.Session.Request) is
   begin
      Line.Put (From, Request, (others => <>));
      Wake;
   end Put;

   procedure Put_In_Run
     (From    : Robot.Requests.Single;
      Request : Robot.Session.Request;
      Run     : Robot.Line_Status.Status;
      Same    : out Boolean) is
   begin
      Line.Put_In_Run (From, Request, Run, Same);
      Wake;
   end Put_In_Run;

   procedure Put
     (From : Robot.Requests.Single; Order : in out Orders.Order) is
   begin
      Order.Owed := False;
      Line.Put (From, Commands.Request_Of (Order.Command), Order);
      Wake (Order.Number);
   end Put;

   procedure Put_Stop (Order : in out Orders.Order) is
   begin
      Order.Owed := False;
      Line.Put_Stop (Order);
      Wake (Order.Number);
   end Put_Stop;

   procedure Put_For_Mission
     (Request : Robot.Session.Request; Order : Orders.Order)
   is
      Now : constant Time := Clock;
   begin
      Line.Put_For_Mission (Request, Order, Now);
      Wake;
   end Put_For_Mission;

   procedure Note_Hand (Number : Orders.Ticket) is
   begin
      Line.Note_Hand (Number);
   end Note_Hand;

   procedure Set_Reload_Due (At_Time : Ada.Real_Time.Time) is
   begin
      Line.Set_Reload_Due (At_Time);
      Wake;
   end Set_Reload_Due;

   procedure Take (Next : in out Robot.Requests.Job) is
      Answer_Timeout : constant Time_Span :=
        Milliseconds (Settings.Command_Line.Chosen.Answer_Timeout);
      Found          : Boolean;
      Now            : Time;
   begin
      Trace.Done (Schedule.Th_Line);
      loop
         Work.Wait;
         Now := Clock;
         Line.Take (Now, Answer_Timeout, Next, Found);
         exit when Found;
         Trace.Idle (Schedule.Th_Line);
      end loop;
      Trace.Start (Schedule.Th_Line, Next.Order.Number);
      Next.Order.Owed := Next.Order.Number /= 0
        and then Next.From /= Robot.Requests.Mission;
   end Take;

   procedure Finish
     (Done    : Robot.Requests.Job;
      Held    : Robot.Line_Status.Dialogue;
      Result  : Robot.Session.Outcome;
      At_Time : Ada.Real_Time.Time)
   is
      More : Boolean;
   begin
      Line.Finish (Done, Held, Result, At_Time, More);
      if More then
         --  the next Take returns at once
         Work.Set;
      end if;
   end Finish;

   procedure Collect
     (From : Robot.Requests.Client; Result : out Robot.Session.Outcome) is
   begin
      Line.Collect (From, Result);
   end Collect;

   procedure Get_Status (Current : out Robot.Line_Status.Status) is
   begin
      Line.Get_Status (Current);
   end Get_Status;

   procedure Get_Rights
     (Number : Orders.Ticket; Is_Over, By_Hand : out Boolean) is
   begin
      Line.Get_Rights (Number, Is_Over, By_Hand);
   end Get_Rights;

end Robot.Line;
