--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Robot.Requests and Robot.Line_Status decide.

with Command_Lines;

package body Robot.Line with SPARK_Mode is

   use type Commands.Ticket;
   use type Robot.Requests.Source;

   procedure Look_At_Clock
     (Waiting : in out Robot.Requests.Requests;
      State   : Robot.Line_Status.State)
   is
      --  What is due by now
      Now : constant Time := Clock;
   begin
      for From in Robot.Requests.Source loop
         if From in Robot.Requests.Periodic then
            Waiting.Due (From) := Now >= Robot.Line_Status.Due (State, From);
         end if;
      end loop;
      Waiting.Quiet := Robot.Line_Status.Is_Quiet
        (State, Now,
         Milliseconds (Command_Lines.Given.Chosen.Answer_Timeout));
   end Look_At_Clock;

   procedure Choose
     (Waiting : in out Robot.Requests.Requests;
      State   : Robot.Line_Status.State;
      Next    : out Turn)
   is
      Choice : Robot.Requests.Choice;
      Item   : Robot.Requests.Job;
   begin
      Look_At_Clock (Waiting, State);
      Choice := Robot.Requests.Next (Waiting);
      Next := (others => <>);
      if Choice.Found then
         Item := Robot.Requests.Head (Waiting, Choice.From);
         Next := (True, Robot.Requests.User_Of (Item), Item.Order.Number);
      end if;
   end Choose;

   protected body Grant is

      procedure Begin_Session (First : Commands.Ticket) is
      begin
         Robot.Requests.Begin_Session (Waiting, First);
      end Begin_Session;

      procedure Take
        (Who     : Task_Name;
         Item    : in out Robot.Requests.Job;
         Verdict : out Robot.Requests.Verdict_Kind;
         Held    : out Robot.Line_Status.Dialogue;
         Found   : out Boolean)
      is
         Now : constant Time := Clock;
      begin
         Look_At_Clock (Waiting, State);
         Robot.Requests.Take (Waiting, Who, Item, Found);
         Verdict := Robot.Requests.Verdict_On
           (Waiting, Item,
            Is_Late => Now > Asked + Schedule.Mission_Order_Limit);
         Held := Dialogue;
      end Take;

      procedure Get_Status (Current : out Robot.Line_Status.Status) is
      begin
         Current := State.Known;
      end Get_Status;

      procedure Get_Rights
        (Number : Commands.Ticket; Is_Over, By_Hand : out Boolean) is
      begin
         Is_Over := Number < Waiting.First_Order;
         By_Hand := Number < Waiting.Last_Hand;
      end Get_Rights;

      procedure Put (Item : Robot.Requests.Job; Next : out Turn) is
      begin
         Robot.Requests.Put (Waiting, Item);
         if Item.From = Robot.Requests.Mission then
            Asked := Clock;
         end if;
         Choose (Waiting, State, Next);
      end Put;

      procedure Look
        (From : Robot.Requests.Periodic; Due : out Time; Next : out Turn) is
      begin
         Due := Robot.Line_Status.Due (State, From);
         Choose (Waiting, State, Next);
      end Look;

      procedure Finish
        (Done   : Robot.Requests.Job;
         Held   : Robot.Line_Status.Dialogue;
         Result : Commands.Outcome;
         Next   : out Turn)
      is
         Now : constant Time := Clock;
      begin
         Dialogue := Held;
         Robot.Line_Status.Note (State, Done, Held, Result, Now);
         Waiting.In_Use := False;
         Choose (Waiting, State, Next);
      end Finish;

   end Grant;

   procedure Wake (Next : Turn) is
   begin
      if Next.Given then
         case Next.To is
            when Th_Open_Com_Robot => Open_Com.Set (Next.Number);
            when Th_Start_Robot    => Start.Set (Next.Number);
            when Th_Start_Robot_WD => Start_WD.Set (Next.Number);
            when Th_Reset_Robot    => Reset.Set (Next.Number);
            when Th_Move           => Move.Set (Next.Number);
            when Th_Battery_Level  => Battery.Set (Next.Number);
            when Th_Mission        => Mission.Set (Next.Number);
            when Th_Com_Mon_Perdue => Monitor_Lost.Set (Next.Number);
            when others            => null;
         end case;
      end if;
   end Wake;

   procedure Put (Order : in out Commands.Order) is
      Next : Turn;
   begin
      Grant.Put
        ((Robot.Requests.Source_Of (Order.Command.Name),
          Commands.Request_Of (Order.Command), Order),
         Next);
      Order.Owed := False;
      Wake (Next);
   end Put;

   procedure Ask
     (From    : Robot.Requests.Asked;
      Request : Commands.Request;
      Order   : Commands.Order)
   is
      Next : Turn;
   begin
      Grant.Put ((From, Request, Order), Next);
      Wake (Next);
   end Ask;

   procedure Look (From : Robot.Requests.Periodic; Next : out Time) is
      Now : constant Time := Clock;
      To  : Turn;
   begin
      Grant.Look (From, Next, To);
      Wake (To);
      if Next <= Now then
         --  it waits for the line
         Next := Now + Schedule.Keep_Alive_Period;
      end if;
   end Look;

   procedure Finish
     (Done   : Robot.Requests.Job;
      Held   : Robot.Line_Status.Dialogue;
      Result : Commands.Outcome)
   is
      Next : Turn;
   begin
      Grant.Finish (Done, Held, Result, Next);
      Wake (Next);
   end Finish;

end Robot.Line;
