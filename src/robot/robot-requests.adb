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
         pragma Loop_Invariant
           (for all D in Source'First .. S =>
              (if D not in Asked then
                  Job_Queues.Length (R.Waiting (D)) = 0));
      end loop;
   end Begin_Session;

   procedure Put (R : in out Requests; Order : Commands.Order) is
      Name : constant Robot_Command := Order.Command.Name;
      From : constant Source := Source_Of (Name);
      Item : Job := (From, Request_Of (Order.Command), Order);
   begin
      Item.Order.After := R.Last_Change;
      Job_Queues.Put (R.Waiting (From), Item);
      if From = Stop_Order then
         R.Last_Stop := Order.Number;
      elsif Robot.Session.Changes_Session (Item.Request.Kind) then
         R.Last_Change := Order.Number;
      end if;
      if Is_By_Hand (Name) then
         R.Last_Hand := Order.Number;
      end if;
   end Put;

   procedure Ask
     (R       : in out Requests;
      From    : Asked;
      Request : Commands.Request;
      Order   : Commands.Order) is
   begin
      Job_Queues.Put (R.Waiting (From), (From, Request, Order));
      if From = Mission then
         R.Last_Mission := Order.Number;
      end if;
   end Ask;

   function Next (R : Requests) return Choice is
   begin
      pragma Assert
        (if Is_Pending (R, Stop_Order) then
            May_Go (R, Stop_Order) or else May_Go (R, Reload));
      if not R.In_Use then
         for S in Source loop
            if May_Go (R, S) then
               return (True, S);
            end if;
            pragma Loop_Invariant
              (for all D in Source'First .. S => not May_Go (R, D));
         end loop;
      end if;
      return (others => <>);
   end Next;

   procedure Take
     (R     : in out Requests;
      Who   : Schedule.Task_Name;
      Item  : in out Job;
      Found : out Boolean)
   is
      First : constant Choice := Next (R);
   begin
      Found := First.Found and then User_Of (Head (R, First.From)) = Who;
      if Found then
         Item := Head (R, First.From);
         R.In_Use := True;
         R.Was_Stop := First.From = Stop_Order;
         if First.From not in Periodic then
            Job_Queues.Remove_First (R.Waiting (First.From));
         end if;
      end if;
   end Take;

end Robot.Requests;
