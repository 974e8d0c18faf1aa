--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Robot.Requests and Robot.Line_Status decide.

with Ada.Real_Time; use Ada.Real_Time;
with Robot.Users;
with Settings;

package body Robot.Line with SPARK_Mode is

   type Turn is record
      Given  : Boolean := False;
      To     : Schedule.Task_Name := Schedule.Th_Move;
      Number : Orders.Ticket := 0;
   end record;
   --  Given: the line is free, and this task is to be woken for the next
   --  request. Number: of the monitor's order, if it is one

   procedure Look_At_Clock
     (Waiting : in out Robot.Requests.Requests;
      State   : Robot.Line_Status.State;
      Now     : Time)
   with Annotate => (GNATprove, Terminating)
   is
      --  What is due by now
   begin
      for From in Robot.Requests.Source loop
         if From in Robot.Requests.Periodic then
            Waiting.Due (From) := Now >= Robot.Line_Status.Due (State, From);
         end if;
      end loop;
      Waiting.Quiet := Robot.Line_Status.Is_Quiet
        (State, Now,
         Milliseconds (Settings.Command_Line.Chosen.Answer_Timeout));
   end Look_At_Clock;

   procedure Choose
     (Waiting : in out Robot.Requests.Requests;
      State   : Robot.Line_Status.State;
      Now     : Time;
      Next    : out Turn)
   with
     Post => Next.Given = Robot.Requests.Next (Waiting).Found,
     Annotate => (GNATprove, Terminating)
   is
      Choice : Robot.Requests.Choice;
      Item   : Robot.Requests.Job;
   begin
      Look_At_Clock (Waiting, State, Now);
      Choice := Robot.Requests.Next (Waiting);
      Next := (others => <>);
      if Choice.Found then
         Item := Robot.Requests.Head (Waiting, Choice.From);
         Next := (True, Robot.Requests.User_Of (Item), Item.Order.Number);
      end if;
   end Choose;

   protected Line with Priority => Schedule.Line_Ceiling is
      procedure Begin_Session (First : Orders.Ticket);
      procedure Put
        (Order : Orders.Order; Now : Time; Next : out Turn)
      with Pre => Order.Command.Name in Commands.Robot_Command;
      procedure Ask
        (From    : Robot.Requests.Asked;
         Request : Commands.Request;
         Order   : Orders.Order;
         Now     : Time;
         Next    : out Turn);
      procedure Look
        (From : Robot.Requests.Periodic;
         Now  : Time;
         Due  : out Time;
         Next : out Turn);
      procedure Take
        (Who     : Schedule.Task_Name;
         Now     : Time;
         Item    : in out Robot.Requests.Job;
         Verdict : out Robot.Requests.Verdict_Kind;
         Held    : out Robot.Line_Status.Dialogue;
         Found   : out Boolean);
      procedure Finish
        (Done   : Robot.Requests.Job;
         Held   : Robot.Line_Status.Dialogue;
         Result : Commands.Outcome;
         Now    : Time;
         Next   : out Turn);
      procedure Get_Status (Current : out Robot.Line_Status.Status);
      procedure Get_Rights
        (Number : Orders.Ticket; Is_Over, By_Hand : out Boolean);
   private
      Waiting  : Robot.Requests.Requests;
      State    : Robot.Line_Status.State;
      Dialogue : Robot.Line_Status.Dialogue;
      --  while no task has the line
      Asked    : Time := Time_First;
      --  when the mission made its last request
   end Line;

   protected body Line is

      procedure Begin_Session (First : Orders.Ticket) is
      begin
         Robot.Requests.Begin_Session (Waiting, First);
      end Begin_Session;

      procedure Put
        (Order : Orders.Order; Now : Time; Next : out Turn) is
      begin
         Robot.Requests.Put (Waiting, Order);
         Choose (Waiting, State, Now, Next);
      end Put;

      procedure Ask
        (From    : Robot.Requests.Asked;
         Request : Commands.Request;
         Order   : Orders.Order;
         Now     : Time;
         Next    : out Turn) is
      begin
         Robot.Requests.Ask (Waiting, From, Request, Order);
         if From = Robot.Requests.Mission then
            Asked := Now;
         end if;
         Choose (Waiting, State, Now, Next);
      end Ask;

      procedure Look
        (From : Robot.Requests.Periodic;
         Now  : Time;
         Due  : out Time;
         Next : out Turn) is
      begin
         Due := Robot.Line_Status.Due (State, From);
         Choose (Waiting, State, Now, Next);
      end Look;

      procedure Take
        (Who     : Schedule.Task_Name;
         Now     : Time;
         Item    : in out Robot.Requests.Job;
         Verdict : out Robot.Requests.Verdict_Kind;
         Held    : out Robot.Line_Status.Dialogue;
         Found   : out Boolean) is
      begin
         Look_At_Clock (Waiting, State, Now);
         Robot.Requests.Take (Waiting, Who, Item, Found);
         Verdict := Robot.Requests.Verdict_On
           (Waiting, Item,
            Is_Late => Now > Asked + Schedule.Mission_Order_Limit);
         Held := Dialogue;
      end Take;

      procedure Finish
        (Done   : Robot.Requests.Job;
         Held   : Robot.Line_Status.Dialogue;
         Result : Commands.Outcome;
         Now    : Time;
         Next   : out Turn) is
      begin
         Dialogue := Held;
         Robot.Line_Status.Note (State, Done, Held, Result, Now);
         Robot.Requests.Release (Waiting);
         Choose (Waiting, State, Now, Next);
      end Finish;

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

   procedure Wake (Next : Turn)
   with Annotate => (GNATprove, Terminating)
   is
   begin
      if Next.Given then
         Robot.Users.Signal (Next.To, Next.Number);
      end if;
   end Wake;

   procedure Begin_Session (First : Orders.Ticket) is
   begin
      Line.Begin_Session (First);
   end Begin_Session;

   procedure Refuse_Orders is
   begin
      Line.Begin_Session (Orders.Ticket'Last);
   end Refuse_Orders;

   procedure Put (Order : in out Orders.Order) is
      Now  : constant Time := Clock;
      Next : Turn;
   begin
      Order.Owed := False;
      Line.Put (Order, Now, Next);
      Wake (Next);
   end Put;

   procedure Ask
     (From    : Robot.Requests.Asked;
      Request : Commands.Request;
      Order   : Orders.Order)
   is
      Now  : constant Time := Clock;
      Next : Turn;
   begin
      Line.Ask (From, Request, Order, Now, Next);
      Wake (Next);
   end Ask;

   procedure Look
     (From : Robot.Requests.Periodic; Next : out Ada.Real_Time.Time)
   is
      Now : constant Time := Clock;
      To  : Turn;
   begin
      Line.Look (From, Now, Next, To);
      Wake (To);
      if Next <= Now then
         --  it waits for the line
         Next := Now + Schedule.Keep_Alive_Period;
      end if;
   end Look;

   procedure Take
     (Who     : Schedule.Task_Name;
      Item    : in out Robot.Requests.Job;
      Verdict : out Robot.Requests.Verdict_Kind;
      Held    : out Robot.Line_Status.Dialogue;
      Found   : out Boolean)
   is
      Now : constant Time := Clock;
   begin
      Line.Take (Who, Now, Item, Verdict, Held, Found);
      Item.Order.Owed := Found
        and then Item.Order.Number /= 0
        and then Item.From /= Robot.Requests.Mission;
   end Take;

   procedure Finish
     (Done   : Robot.Requests.Job;
      Held   : Robot.Line_Status.Dialogue;
      Result : Commands.Outcome)
   is
      Now  : constant Time := Clock;
      Next : Turn;
   begin
      Line.Finish (Done, Held, Result, Now, Next);
      Wake (Next);
   end Finish;

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
