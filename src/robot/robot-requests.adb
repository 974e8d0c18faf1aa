--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Requests with SPARK_Mode is

   procedure Begin_Session (R : in out Requests; First : Commands.Ticket) is
   begin
      R.First_Order := First;
      R.Last_Stop := 0;
      R.Last_Hand := 0;
      R.Last_Change := 0;
      for S in Source loop
         if S not in Asked then
            Job_Queues.Clear (R.Waiting (S));
         end if;
      end loop;
   end Begin_Session;

   procedure Put (R : in out Requests; Item : Job) is
      Number : constant Commands.Ticket := Item.Order.Number;
      Placed : Job := Item;
   begin
      Placed.Order.After := R.Last_Change;
      Job_Queues.Put (R.Waiting (Item.From), Placed);
      if Item.From = Stop_Order then
         R.Last_Stop := Number;
      elsif Item.From = Mission then
         R.Last_Mission := Number;
      elsif Item.From = Other_Order
        and then Session.Changes_Session (Item.Request.Kind)
      then
         R.Last_Change := Number;
      end if;
      if Item.From not in Asked
        and then Is_By_Hand (Item.Order.Command.Name)
      then
         R.Last_Hand := Number;
      end if;
   end Put;

   function Next (R : Requests) return Source is
   begin
      pragma Assert
        (if Is_Pending (R, Stop_Order) then
            May_Go (R, Stop_Order) or else May_Go (R, Reload));
      for S in Source loop
         if May_Go (R, S) then
            return S;
         end if;
         pragma Loop_Invariant
           (for all D in Source'First .. S => not May_Go (R, D));
      end loop;
      raise Program_Error;
   end Next;

   procedure Take
     (R     : in out Requests;
      Who   : Schedule.Task_Name;
      Item  : in out Job;
      Found : out Boolean)
   is
      From : constant Source :=
        (if May_Start (R) then Next (R) else Source'Last);
   begin
      Found := May_Start (R) and then User_Of (Head (R, From)) = Who;
      if Found then
         Item := Head (R, From);
         R.In_Use := True;
         R.Was_Stop := From = Stop_Order;
         if From not in Periodic then
            Job_Queues.Remove_First (R.Waiting (From));
         end if;
      end if;
   end Take;

end Robot.Requests;
