--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and which of them is carried
--  out next. Urgency decides: the end of a session, a stop, the reload of the
--  watchdog, a movement, then the rest in the order of the commands.

with Order_Queues;
with Orders;
with Robot_Session;

package Line_Requests with SPARK_Mode is

   use type Orders.Order;
   use type Orders.Ticket;
   use type Robot_Session.Request;

   type Client is
     (Safe_State,   --  the end of a session: stop and close
      Stop_Order,   --  a monitor's stop: past its thread, straight here
      Reload,
      Move,
      Battery,
      Open,
      Start,
      Start_Watchdog,
      Reset,
      Query,
      Keep_Alive);
   --  Who asks. Each has one request at a time, Stop_Order as many as
   --  commands may wait

   subtype Single is Client
   with Static_Predicate => Single in Safe_State | Reload .. Keep_Alive;
   --  Those with one request at a time

   type Verdict_Kind is
     (Carry_Out,
      Overtaken,    --  a movement that a later stop has made void
      Out_Of_Date); --  its session has ended

   type Job is record
      From    : Client := Keep_Alive;
      Request : Robot_Session.Request;
      Order   : Orders.Order;
      Verdict : Verdict_Kind := Carry_Out;
   end record;

   type Requests is private;
   --  Initially none, in a session that begins with order number 1

   function Changes_Session (Kind : Robot_Session.Request_Kind) return Boolean
   is (Kind in Robot_Session.Open_Line | Robot_Session.Close_Line
         | Robot_Session.Start | Robot_Session.Start_Watchdog
         | Robot_Session.Reset | Robot_Session.Power_Off);
   --  These keep their place among the orders: all earlier ones come before
   --  them and all later ones after. Stops alone go past them

   --  What waits

   function Stops (R : Requests) return Order_Queues.Queue
   with Ghost;
   --  Of the monitor, oldest first

   function Is_Pending (R : Requests; From : Client) return Boolean
   with
     Post => (if From = Stop_Order then
                 Is_Pending'Result = (Order_Queues.Length (Stops (R)) > 0));

   function Request_Of (R : Requests; From : Client)
     return Robot_Session.Request
   with
     Pre  => Is_Pending (R, From),
     Post => (if From = Stop_Order then
                 Request_Of'Result = (Robot_Session.Stop, others => <>));

   function Order_Of (R : Requests; From : Client) return Orders.Order
   with
     Pre  => Is_Pending (R, From),
     Post => (if From = Stop_Order then
                 Order_Of'Result = Order_Queues.Element_At (Stops (R), 1));
   --  The monitor's order behind the request; its number is 0 for none

   --  What has been so far

   function First_Order (R : Requests) return Orders.Ticket;
   --  Of the session: what has a lower number is out of date

   function Last_Stop (R : Requests) return Orders.Ticket;
   --  The number of the last stop of the session, 0 for none

   function Completed (R : Requests) return Orders.Ticket;
   --  Orders of the session that have been carried out, but stops

   function Last_Change (R : Requests) return Orders.Ticket;
   --  The rank of the last of them that changed the session, 0 for none

   --  What may go next

   function Verdict_On (R : Requests; From : Client) return Verdict_Kind is
     (if From = Stop_Order or else Order_Of (R, From).Number = 0
      then Carry_Out
      elsif Order_Of (R, From).Number < First_Order (R) then Out_Of_Date
      elsif From = Move and then Order_Of (R, From).Number < Last_Stop (R)
      then Overtaken
      else Carry_Out)
   with Pre => Is_Pending (R, From);

   function Is_In_Turn (R : Requests; From : Client) return Boolean is
     (From = Stop_Order
      or else Order_Of (R, From).Number = 0
      or else Verdict_On (R, From) = Out_Of_Date
      or else
        (if Changes_Session (Request_Of (R, From).Kind)
         then Completed (R) + 1 = Order_Of (R, From).Rank
         else Order_Of (R, From).After <= Last_Change (R)))
   with Pre => Is_Pending (R, From);
   --  An order that changes the session is when all orders before it have
   --  been carried out; another one when the last before it that changes
   --  the session has been; a stop always is

   function Waits_For_Quiet (From : Client) return Boolean is
     (From in Battery .. Keep_Alive);
   --  Is not begun shortly before the watchdog is to be reloaded

   function May_Go (R : Requests; From : Client; Quiet : Boolean)
     return Boolean
   is (Is_Pending (R, From)
       and then
         (From in Safe_State | Reload | Battery | Keep_Alive
          or else Is_In_Turn (R, From))
       and then (if Quiet then not Waits_For_Quiet (From)));

   subtype In_Order is Client range Open .. Query;
   --  Go in the order of the commands

   function Is_Before (R : Requests; Left, Right : Client) return Boolean is
     (if Left in In_Order and then Right in In_Order then
         Order_Of (R, Left).Number < Order_Of (R, Right).Number
      else Left < Right)
   with Pre => Is_Pending (R, Left) and then Is_Pending (R, Right);
   --  Left is more urgent than Right

   function Is_Ready (R : Requests) return Boolean
   with
     Post => Is_Ready'Result =
       (for some From in Client =>
          Is_Pending (R, From) and then Is_In_Turn (R, From));
   --  Something may be taken, at least when it need not be quiet

   --  The words of the contracts

   function Is_Same (R, Before : Requests; From : Client) return Boolean is
     (Is_Pending (R, From) = Is_Pending (Before, From)
      and then
        (if Is_Pending (R, From) then
            Request_Of (R, From) = Request_Of (Before, From)
            and then Order_Of (R, From) = Order_Of (Before, From)))
   with Ghost;

   function Are_Others_Same (R, Before : Requests; But : Client)
     return Boolean
   is (for all From in Client =>
         From in But | Stop_Order or else Is_Same (R, Before, From))
   with Ghost;
   --  All requests are as before, but that of But, and perhaps the stops

   function Is_Same_Past (R, Before : Requests) return Boolean is
     (First_Order (R) = First_Order (Before)
      and then Last_Stop (R) = Last_Stop (Before)
      and then Completed (R) = Completed (Before)
      and then Last_Change (R) = Last_Change (Before))
   with Ghost;

   --  The operations

   procedure Begin_Session (R : in out Requests; First : Orders.Ticket)
   with
     Post => First_Order (R) = First
       and then Last_Stop (R) = 0
       and then Completed (R) = 0
       and then Last_Change (R) = 0
       and then Order_Queues.Length (Stops (R)) = 0
       and then Are_Others_Same (R, R'Old, But => Stop_Order);
   --  Orders with a lower number than First are out of date from now on

   procedure Put
     (R       : in out Requests;
      From    : Single;
      Request : Robot_Session.Request;
      Order   : Orders.Order)
   with
     Post => Is_Same_Past (R, R'Old)
       and then Is_Pending (R, From)
       and then Request_Of (R, From) = Request
       and then Order_Of (R, From) = Order
       and then Order_Queues.Is_Same (Stops (R), Stops (R'Old))
       and then Are_Others_Same (R, R'Old, But => From);
   --  From has a request

   procedure Put_Stop (R : in out Requests; Order : Orders.Order)
   with
     Post => Last_Stop (R) = Order.Number
       and then First_Order (R) = First_Order (R'Old)
       and then Completed (R) = Completed (R'Old)
       and then Last_Change (R) = Last_Change (R'Old)
       and then
         (if Order_Queues.Is_Full (Stops (R'Old)) then
             Order_Queues.Is_Same (Stops (R), Stops (R'Old))
          else Order_Queues.Begins_With (Stops (R), Stops (R'Old))
            and then Order_Queues.Length (Stops (R)) =
              Order_Queues.Length (Stops (R'Old)) + 1
            and then Order_Queues.Element_At
              (Stops (R), Order_Queues.Length (Stops (R))) = Order)
       and then Are_Others_Same (R, R'Old, But => Stop_Order);
   --  A monitor's stop, behind those that wait already. Movements that wait
   --  and are older become void

   procedure Take
     (R     : in out Requests;
      Quiet : Boolean;
      Next  : out Job;
      Found : out Boolean)
   with
     Post => Is_Same_Past (R, R'Old)
       and then Found =
         (for some From in Client => May_Go (R'Old, From, Quiet))
       and then
         (if Found then
             May_Go (R'Old, Next.From, Quiet)
             and then (for all From in Client =>
                         (if May_Go (R'Old, From, Quiet) then
                             not Is_Before (R'Old, From, Next.From)))
             and then Next.Request = Request_Of (R'Old, Next.From)
             and then Next.Order = Order_Of (R'Old, Next.From)
             and then Next.Verdict = Verdict_On (R'Old, Next.From))
       and then
         (if Found and then Next.From = Stop_Order then
             Order_Queues.Is_Without_First (Stops (R), Stops (R'Old))
          else Order_Queues.Is_Same (Stops (R), Stops (R'Old)))
       and then
         (if Found then
             Are_Others_Same (R, R'Old, But => Next.From)
             and then (if Next.From /= Stop_Order then
                          not Is_Pending (R, Next.From))
          else Are_Others_Same (R, R'Old, But => Stop_Order));
   --  The most urgent of what may go now, which waits no longer

   procedure Finish (R : in out Requests; Done : Job)
   with
     Post => First_Order (R) = First_Order (R'Old)
       and then Last_Stop (R) = Last_Stop (R'Old)
       and then
         (if Done.Order.Number >= First_Order (R) and then Done.Order.Rank > 0
          then Completed (R) = Completed (R'Old) + 1
            and then Last_Change (R) =
              (if Changes_Session (Done.Request.Kind) then Done.Order.Rank
               else Last_Change (R'Old))
          else Completed (R) = Completed (R'Old)
            and then Last_Change (R) = Last_Change (R'Old))
       and then Order_Queues.Is_Same (Stops (R), Stops (R'Old))
       and then Are_Others_Same (R, R'Old, But => Stop_Order);
   --  What was taken has been carried out; stops have no rank

private

   type Slot is record
      Pending : Boolean := False;
      Request : Robot_Session.Request;
      Order   : Orders.Order;
   end record;

   type Slot_Array is array (Client) of Slot;
   --  That of Stop_Order is not used

   type Requests is record
      Slots     : Slot_Array;
      Stops     : Order_Queues.Queue;
      First     : Orders.Ticket := 1;
      Last_Stop : Orders.Ticket := 0;
      Completed : Orders.Ticket := 0;
      Changed   : Orders.Ticket := 0;
   end record;

   function Stops (R : Requests) return Order_Queues.Queue is (R.Stops);

   function Is_Pending (R : Requests; From : Client) return Boolean is
     (if From = Stop_Order then Order_Queues.Length (R.Stops) > 0
      else R.Slots (From).Pending);

   function Request_Of (R : Requests; From : Client)
     return Robot_Session.Request
   is (if From = Stop_Order then (Robot_Session.Stop, others => <>)
       else R.Slots (From).Request);

   function Order_Of (R : Requests; From : Client) return Orders.Order is
     (if From = Stop_Order then Order_Queues.Element_At (R.Stops, 1)
      else R.Slots (From).Order);

   function First_Order (R : Requests) return Orders.Ticket is (R.First);

   function Last_Stop (R : Requests) return Orders.Ticket is (R.Last_Stop);

   function Completed (R : Requests) return Orders.Ticket is (R.Completed);

   function Last_Change (R : Requests) return Orders.Ticket is (R.Changed);

   function Is_Ready (R : Requests) return Boolean is
     (for some From in Client =>
        Is_Pending (R, From) and then Is_In_Turn (R, From));

end Line_Requests;
