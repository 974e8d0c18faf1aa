--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requests that wait for the robot's line, and the choice of the next. By
--  priority: end of a session, stop, reload of the watchdog, movement, order
--  of a mission, then the rest in the order of the commands.

with Order_Queues;
with Orders;
with Robot.Session;

package Robot.Requests with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Robot.Requests);

   use type Orders.Order;
   use type Orders.Ticket;
   use type Robot.Session.Request_Kind;

   type Client is
     (Safe_State,   --  the end of a session: stop and close
      Stop_Order,   --  a monitor's stop: queued directly, by no task
      Reload,
      Move,
      Mission,      --  an order of the mission that is under way
      Battery,
      Open,
      Start,
      Start_Watchdog,
      Reset,
      Query,
      Keep_Alive);
   --  The client that asks. Each has one request at a time; Stop_Order may
   --  have as many as commands may wait

   subtype Single is Client
   with Static_Predicate => Single in Safe_State | Reload .. Keep_Alive;
   --  Clients with one request at a time

   type Verdict_Kind is
     (Carry_Out,
      Overtaken,    --  a movement cancelled by a later stop or mission; an
      --  order of a mission that a later order by hand has ended
      Out_Of_Date,  --  its session has ended
      Late);        --  an order of a mission that has waited too long

   type Job is record
      From    : Client := Keep_Alive;
      Request : Robot.Session.Request;
      Order   : Orders.Order;
      Verdict : Verdict_Kind := Carry_Out;
   end record;

   type Slot is record
      Pending : Boolean := False;
      Request : Robot.Session.Request;
      Order   : Orders.Order;
      --  the monitor's order behind the request; number 0: none. Of Mission:
      --  the order that asked for the mission, never owed
   end record;

   type Slot_Array is array (Client) of Slot;
   --  The slot of Stop_Order is not used

   type Requests is record
      Slots       : Slot_Array;
      Stops       : Order_Queues.Queue;
      --  the monitor's stops, oldest first
      First_Order : Orders.Ticket := 1;
      --  of the session: orders with a lower number are out of date
      Last_Stop   : Orders.Ticket := 0;
      --  number of the last stop of the session, 0: none
      Last_Hand   : Orders.Ticket := 0;
      --  number of the last order by hand (Commands.Is_By_Hand), 0: none
      Completed   : Orders.Ticket := 0;
      --  ranked orders of the session that have been carried out
      Last_Change : Orders.Ticket := 0;
      --  rank of the last of them that changed the session, 0: none
      Was_Stop    : Boolean := False;
      --  the request taken last was a monitor's stop
   end record;

   --  Waiting requests

   function Is_Pending (R : Requests; From : Client) return Boolean is
     (if From = Stop_Order then Order_Queues.Length (R.Stops) > 0
      else R.Slots (From).Pending);

   function Request_Of (R : Requests; From : Client)
     return Robot.Session.Request
   is (if From = Stop_Order then (Robot.Session.Stop, others => <>)
       else R.Slots (From).Request)
   with Pre => Is_Pending (R, From);

   function Order_Of (R : Requests; From : Client) return Orders.Order is
     (if From = Stop_Order then Order_Queues.Element_At (R.Stops, 1)
      else R.Slots (From).Order)
   with Pre => Is_Pending (R, From);

   --  Requests that may start

   function Stops (R : Requests; From : Client) return Boolean is
     (Request_Of (R, From).Kind = Robot.Session.Stop)
   with Pre => Is_Pending (R, From);

   function Last_Mission (R : Requests) return Orders.Ticket is
     (R.Slots (Mission).Order.Number);
   --  The last mission that has made a request

   function Verdict_On (R : Requests; From : Client; Is_Late : Boolean)
     return Verdict_Kind
   is (if From = Stop_Order
         or else (Order_Of (R, From).Number = 0 and then From /= Mission)
       then Carry_Out
       elsif Order_Of (R, From).Number < R.First_Order then Out_Of_Date
       elsif From = Move
         and then
           (Order_Of (R, From).Number < R.Last_Stop
            or else Order_Of (R, From).Number < Last_Mission (R))
       then Overtaken
       elsif From = Mission and then Order_Of (R, From).Number < R.Last_Hand
       then Overtaken
       elsif From = Mission and then Is_Late and then not Stops (R, From)
       then Late
       else Carry_Out)
   with Pre => Is_Pending (R, From);
   --  Is_Late: the request of Mission has waited for too long. A stop is
   --  never late

   function Is_In_Turn (R : Requests; From : Client) return Boolean is
     (From = Stop_Order
      or else Order_Of (R, From).Number = 0
      or else Order_Of (R, From).Number < R.First_Order
      or else
        (if From = Mission then Order_Of (R, From).After <= R.Completed
         elsif Robot.Session.Changes_Session (Request_Of (R, From).Kind)
         then R.Completed + 1 = Order_Of (R, From).Rank
         else Order_Of (R, From).After <= R.Last_Change))
   with Pre => Is_Pending (R, From);
   --  An order that changes the session is in turn when all orders before it
   --  are done, and so is one of a mission; any other order when the last
   --  session change before it is done; a stop always

   function Waits_For_Quiet (R : Requests; From : Client) return Boolean is
     (From in Battery .. Keep_Alive
      or else (From = Mission and then not Stops (R, From)))
   with Pre => Is_Pending (R, From);
   --  Not started shortly before a reload of the watchdog is due

   function May_Go (R : Requests; From : Client; Quiet : Boolean)
     return Boolean
   is (Is_Pending (R, From)
       and then
         (From in Safe_State | Reload | Battery | Keep_Alive
          or else Is_In_Turn (R, From))
       and then
         (if From = Stop_Order and then R.Was_Stop then
             not Is_Pending (R, Reload))
       and then (if Quiet then not Waits_For_Quiet (R, From)));
   --  Between two stops a waiting reload has priority: an endless sequence of
   --  stops does not block the reloads

   subtype In_Order is Client range Open .. Query;
   --  Carried out in the order of the commands

   function Is_Before (R : Requests; Left, Right : Client) return Boolean is
     (if Left in In_Order and then Right in In_Order then
         Order_Of (R, Left).Number < Order_Of (R, Right).Number
      else Left < Right)
   with Pre => Is_Pending (R, Left) and then Is_Pending (R, Right);
   --  Left has priority over Right

   function Is_Ready (R : Requests) return Boolean is
     (for some From in Client =>
        Is_Pending (R, From) and then Is_In_Turn (R, From));
   --  A request may start, at least outside the quiet time before a reload

   --  Used in the contracts

   function Is_Same_Past (R, Before : Requests) return Boolean is
     (R.First_Order = Before.First_Order
      and then R.Last_Stop = Before.Last_Stop
      and then R.Last_Hand = Before.Last_Hand
      and then R.Completed = Before.Completed
      and then R.Last_Change = Before.Last_Change)
   with Ghost;

   procedure Begin_Session (R : in out Requests; First : Orders.Ticket)
   with
     Post => R.First_Order = First
       and then R.Last_Stop = 0
       and then R.Last_Hand = 0
       and then R.Completed = 0
       and then R.Last_Change = 0
       and then Order_Queues.Length (R.Stops) = 0
       and then R.Slots = R'Old.Slots;
   --  Orders with a number below First are now out of date

   procedure Put
     (R       : in out Requests;
      From    : Single;
      Request : Robot.Session.Request;
      Order   : Orders.Order)
   with
     Post => Is_Same_Past (R, R'Old)
       and then R.Slots (From) = (True, Request, Order)
       and then (for all C in Client =>
                   (if C /= From then R.Slots (C) = R'Old.Slots (C)))
       and then Order_Queues.Is_Same (R.Stops, R'Old.Stops);
   --  Client From makes a request

   procedure Put_Stop (R : in out Requests; Order : Orders.Order)
   with
     Post => R.First_Order = R'Old.First_Order
       and then R.Last_Stop = Order.Number
       and then R.Last_Hand = R'Old.Last_Hand
       and then R.Completed = R'Old.Completed
       and then R.Last_Change = R'Old.Last_Change
       and then R.Slots = R'Old.Slots
       and then
         (if Order_Queues.Is_Full (R'Old.Stops) then
             Order_Queues.Is_Same (R.Stops, R'Old.Stops)
          else Order_Queues.Begins_With (R.Stops, R'Old.Stops)
            and then Order_Queues.Length (R.Stops) =
              Order_Queues.Length (R'Old.Stops) + 1
            and then Order_Queues.Element_At
              (R.Stops, Order_Queues.Length (R.Stops)) = Order);
   --  Appends a monitor's stop. It cancels older movements that still wait

   procedure Note_Hand (R : in out Requests; Number : Orders.Ticket)
   with
     Post => R.Last_Hand = Number
       and then R.First_Order = R'Old.First_Order
       and then R.Last_Stop = R'Old.Last_Stop
       and then R.Completed = R'Old.Completed
       and then R.Last_Change = R'Old.Last_Change
       and then R.Slots = R'Old.Slots
       and then Order_Queues.Is_Same (R.Stops, R'Old.Stops);
   --  Order Number is one by hand: what an older mission has asked for, or
   --  will ask for, is not carried out any more

   function Job_Of (R : Requests; From : Client; Is_Late : Boolean)
     return Job
   is ((From    => From,
        Request => Request_Of (R, From),
        Order   => Order_Of (R, From),
        Verdict => Verdict_On (R, From, Is_Late)))
   with Pre => Is_Pending (R, From);

   procedure Take
     (R       : in out Requests;
      Quiet   : Boolean;
      Is_Late : Boolean;
      Next    : in out Job;
      Found   : out Boolean)
   with
     Post => Found = (for some C in Client => May_Go (R'Old, C, Quiet))
       and then Is_Same_Past (R, R'Old)
       and then
         (if Found then
             May_Go (R'Old, Next.From, Quiet)
             and then Next = Job_Of (R'Old, Next.From, Is_Late)
             and then (for all C in Client =>
                         (if May_Go (R'Old, C, Quiet) then
                             not Is_Before (R'Old, C, Next.From)))
             and then R.Was_Stop = (Next.From = Stop_Order)
             and then
               (if Next.From = Stop_Order then
                   Order_Queues.Is_Without_First (R.Stops, R'Old.Stops)
                else Order_Queues.Is_Same (R.Stops, R'Old.Stops)
                  and then not R.Slots (Next.From).Pending)
             and then (for all C in Client =>
                         (if C /= Next.From then
                             R.Slots (C) = R'Old.Slots (C)))
          else R = R'Old and then Next = Next'Old)
       and then
         (if Is_Pending (R'Old, Stop_Order) then
             Found
             and then
               (Next.From in Safe_State | Stop_Order
                or else (Next.From = Reload and then R'Old.Was_Stop)))
       and then
         (if Found
            and then Next.From = Mission
            and then Next.Verdict = Carry_Out
          then Next.Order.Number >= R.First_Order
            and then Next.Order.Number >= R.Last_Hand
            and then
              (if Is_Late then Next.Request.Kind = Robot.Session.Stop));
   --  Removes the request with the highest priority of those that may start. A
   --  stop precedes every other request, with two exceptions: the end of the
   --  session, and a reload that waits after another stop. A mission's request
   --  is dropped if a later order by hand has ended the mission

   procedure Finish (R : in out Requests; Done : Job)
   with
     Post => R.First_Order = R'Old.First_Order
       and then R.Last_Stop = R'Old.Last_Stop
       and then R.Last_Hand = R'Old.Last_Hand
       and then
         (if Done.Order.Number >= R.First_Order and then Done.Order.Rank > 0
          then R.Completed = R'Old.Completed + 1
            and then R.Last_Change =
              (if Robot.Session.Changes_Session (Done.Request.Kind)
               then Done.Order.Rank
               else R'Old.Last_Change)
          else R.Completed = R'Old.Completed
            and then R.Last_Change = R'Old.Last_Change)
       and then R.Slots = R'Old.Slots
       and then Order_Queues.Is_Same (R.Stops, R'Old.Stops);
   --  The request taken has been carried out; stops have no rank

end Robot.Requests;
