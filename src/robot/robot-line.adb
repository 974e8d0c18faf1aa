--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Robot.Requests and Robot.Line_Status decide.

with Command_Lines;

package body Robot.Line with SPARK_Mode is

   use type Commands.Ticket;
   use type Requests.Source;

   procedure Look_At_Clock
     (Waiting : in out Requests.Requests; State : Line_Status.Status)
   is
      --  What is due by now
      Now : constant Time := Clock;
   begin
      for From in Requests.Source loop
         if From in Requests.Periodic then
            Waiting.Due (From) := Now >= Line_Status.Due (State, From);
         end if;
      end loop;
      Waiting.Quiet := Line_Status.Is_Quiet
        (State, Now, Milliseconds (Command_Lines.Given.Chosen.Answer_Timeout));
   end Look_At_Clock;

   procedure Choose
     (Waiting : in out Requests.Requests;
      State   : Line_Status.Status;
      Next    : out Turn)
   is
      Item : Requests.Job;
   begin
      Look_At_Clock (Waiting, State);
      Next := (others => <>);
      if Requests.May_Start (Waiting) then
         Item := Requests.Head (Waiting, Requests.Next (Waiting));
         Next := (Requests.User_Of (Item), Item.Order.Number);
      end if;
   end Choose;

   protected body Grant is

      procedure Begin_Session (First : Commands.Ticket) is
      begin
         Requests.Begin_Session (Waiting, First);
      end Begin_Session;

      procedure Take
        (Who     : Task_Name;
         Item    : in out Requests.Job;
         Verdict : out Requests.Verdict_Kind;
         Held    : out Line_Status.Dialogue;
         Found   : out Boolean)
      is
         Now : constant Time := Clock;
      begin
         Look_At_Clock (Waiting, State);
         Requests.Take (Waiting, Who, Item, Found);
         Verdict := Requests.Verdict_On
           (Waiting, Item,
            Is_Late => Now > Asked + Schedule.Mission_Order_Limit);
         Held := State.Held;
      end Take;

      procedure Get_Status (Current : out Line_Status.Status) is
      begin
         Current := State;
      end Get_Status;

      procedure Get_Rights
        (Number : Commands.Ticket; Is_Over, By_Hand : out Boolean) is
      begin
         Is_Over := Number < Waiting.First_Order;
         By_Hand := Number < Waiting.Last_Hand;
      end Get_Rights;

      procedure Put (Item : Requests.Job; Next : out Turn) is
      begin
         Requests.Put (Waiting, Item);
         if Item.From = Requests.Mission then
            Asked := Clock;
         end if;
         Choose (Waiting, State, Next);
      end Put;

      procedure Look
        (From : Requests.Periodic; Due : out Time; Next : out Turn) is
      begin
         Due := Line_Status.Due (State, From);
         Choose (Waiting, State, Next);
      end Look;

      procedure Finish
        (Done   : Requests.Job;
         Held   : Line_Status.Dialogue;
         Result : Commands.Outcome;
         Next   : out Turn)
      is
         Now : constant Time := Clock;
      begin
         Line_Status.Note (State, Done, Held, Result, Now);
         Waiting.In_Use := False;
         Choose (Waiting, State, Next);
      end Finish;

   end Grant;

   procedure Wake (Next : Turn) is
   begin
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
   end Wake;

   procedure Put (Order : in out Commands.Order) is
      Next : Turn;
   begin
      Grant.Put
        ((Requests.Source_Of (Order.Command.Name),
          Commands.Request_Of (Order.Command), Order),
         Next);
      Order.Owed := False;
      Wake (Next);
   end Put;

   procedure Ask
     (From    : Requests.Asked;
      Request : Commands.Request;
      Order   : Commands.Order)
   is
      Next : Turn;
   begin
      Grant.Put ((From, Request, Order), Next);
      Wake (Next);
   end Ask;

   procedure Look (From : Requests.Periodic; Next : out Time) is
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
     (Done   : Requests.Job;
      Held   : Line_Status.Dialogue;
      Result : Commands.Outcome)
   is
      Next : Turn;
   begin
      Grant.Finish (Done, Held, Result, Next);
      Wake (Next);
   end Finish;

end Robot.Line;
