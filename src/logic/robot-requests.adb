--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Requests with SPARK_Mode is

   procedure Prove_Transitivity (R : Requests; From, Best : Client)
   with
     Ghost,
     Pre  => Best < From
       and then Is_Pending (R, From)
       and then Is_Pending (R, Best)
       and then Is_Before (R, From, Best),
     Post =>
       (for all C in Client =>
          (if C < From and then Is_Pending (R, C)
             and then not Is_Before (R, C, Best)
           then not Is_Before (R, C, From)));
   --  What does not precede Best does not precede From, which does

   procedure Begin_Session (R : in out Requests; First : Orders.Ticket) is
   begin
      R.First_Order := First;
      R.Last_Stop := 0;
      R.Last_Hand := 0;
      R.Completed := 0;
      R.Last_Change := 0;
      Order_Queues.Clear (R.Stops);
   end Begin_Session;

   procedure Finish (R : in out Requests; Done : Job) is
   begin
      if Done.Order.Number >= R.First_Order and then Done.Order.Rank > 0 then
         R.Completed := R.Completed + 1;
         if Robot.Session.Changes_Session (Done.Request.Kind) then
            R.Last_Change := Done.Order.Rank;
         end if;
      end if;
   end Finish;

   procedure Note_Hand (R : in out Requests; Number : Orders.Ticket) is
   begin
      R.Last_Hand := Number;
   end Note_Hand;

   procedure Put
     (R       : in out Requests;
      From    : Single;
      Request : Robot.Session.Request;
      Order   : Orders.Order) is
   begin
      R.Slots (From) :=
        (Pending => True, Request => Request, Order => Order);
   end Put;

   procedure Put_Stop (R : in out Requests; Order : Orders.Order) is
   begin
      Order_Queues.Put (R.Stops, Order);
      R.Last_Stop := Order.Number;
   end Put_Stop;

   procedure Prove_Transitivity (R : Requests; From, Best : Client) is null;

   procedure Take
     (R       : in out Requests;
      Quiet   : Boolean;
      Is_Late : Boolean;
      Next    : in out Job;
      Found   : out Boolean)
   is
      From : Client := Keep_Alive;
   begin
      Found := False;
      for C in Client loop
         if May_Go (R, C, Quiet) then
            if not Found then
               From := C;
               Found := True;
            elsif Is_Before (R, C, From) then
               Prove_Transitivity (R, C, From);
               From := C;
            end if;
         end if;
         pragma Loop_Invariant
           (Found = (for some D in Client'First .. C =>
                       May_Go (R, D, Quiet)));
         pragma Loop_Invariant
           (if Found then From <= C and then May_Go (R, From, Quiet));
         pragma Loop_Invariant
           (if Found then
              (for all D in Client'First .. C =>
                 (if May_Go (R, D, Quiet) then not Is_Before (R, D, From))));
      end loop;
      pragma Assert
        (if Is_Pending (R, Stop_Order) then
            not Waits_For_Quiet (R, Stop_Order));
      pragma Assert
        (if Is_Pending (R, Stop_Order) then Is_In_Turn (R, Stop_Order));
      pragma Assert
        (if Is_Pending (R, Stop_Order) then
            May_Go (R, Stop_Order, Quiet)
            or else (R.Was_Stop and then May_Go (R, Reload, Quiet)));
      if Found then
         Next := Job_Of (R, From, Is_Late);
         R.Was_Stop := From = Stop_Order;
         if From = Stop_Order then
            Order_Queues.Remove_First (R.Stops);
         else
            R.Slots (From).Pending := False;
         end if;
      end if;
   end Take;

end Robot.Requests;
