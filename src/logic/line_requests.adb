--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and which of them is carried
--  out next. Urgency decides: the end of a session, a stop, the reload of the
--  watchdog, a movement, then the rest in the order of the commands.

package body Line_Requests with SPARK_Mode is

   -------------------
   -- Begin_Session --
   -------------------

   procedure Begin_Session (R : in out Requests; First : Orders.Ticket) is
   begin
      R.First := First;
      R.Last_Stop := 0;
      R.Completed := 0;
      R.Changed := 0;
      Order_Queues.Clear (R.Stops);
   end Begin_Session;

   ------------
   -- Finish --
   ------------

   procedure Finish (R : in out Requests; Done : Job) is
   begin
      if Done.Order.Number >= R.First and then Done.Order.Rank > 0 then
         R.Completed := R.Completed + 1;
         if Changes_Session (Done.Request.Kind) then
            R.Changed := Done.Order.Rank;
         end if;
      end if;
   end Finish;

   ---------
   -- Put --
   ---------

   procedure Put
     (R       : in out Requests;
      From    : Single;
      Request : Robot_Session.Request;
      Order   : Orders.Order) is
   begin
      R.Slots (From) :=
        (Pending => True, Request => Request, Order => Order);
   end Put;

   --------------
   -- Put_Stop --
   --------------

   procedure Put_Stop (R : in out Requests; Order : Orders.Order) is
   begin
      Order_Queues.Put (R.Stops, Order);
      R.Last_Stop := Order.Number;
   end Put_Stop;

   ----------
   -- Take --
   ----------

   procedure Take
     (R     : in out Requests;
      Quiet : Boolean;
      Next  : out Job;
      Found : out Boolean)
   is
      Best : Client := Keep_Alive;
   begin
      Found := False;
      for From in Client loop
         if May_Go (R, From, Quiet)
           and then (not Found or else Is_Before (R, From, Best))
         then
            Best := From;
            Found := True;
         end if;
         pragma Loop_Invariant
           (Found = (for some C in Client'First .. From =>
                       May_Go (R, C, Quiet)));
         pragma Loop_Invariant
           (if Found then Best <= From and then May_Go (R, Best, Quiet));
         pragma Loop_Invariant
           (if Found then
              (for all C in Client'First .. From =>
                 (if May_Go (R, C, Quiet) then not Is_Before (R, C, Best))));
      end loop;

      if Found then
         Next := (From    => Best,
                  Request => Request_Of (R, Best),
                  Order   => Order_Of (R, Best),
                  Verdict => Verdict_On (R, Best));
         if Best = Stop_Order then
            Order_Queues.Remove_First (R.Stops);
         else
            R.Slots (Best).Pending := False;
         end if;
      else
         Next := (others => <>);
      end if;
   end Take;

end Line_Requests;
