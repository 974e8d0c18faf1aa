--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requests that wait for the robot's line, and to whom it is granted next.

with Bounded_Queues;
with Commands; use Commands;
with Robot.Session;
with Schedule;

package Robot.Requests with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Robot.Requests);  --  proved

   use type Schedule.Task_Name;

   type Source is
     (Safe_State,   --  the end of a session: stop and close
      Stop_Order,   --  the monitor's stops
      Reload,       --  of the watchdog
      Movement,     --  the monitor's movements
      Mission,      --  the mission that is under way
      Battery,      --  its level
      Other_Order,  --  the monitor's other orders
      Keep_Alive);  --  a ping
   --  What asks for the line, the most urgent first

   subtype Periodic is Source
   with Static_Predicate => Periodic in Reload | Battery | Keep_Alive;
   --  Asked for by the clock (Robot.Line_Status.Due)

   subtype Asked is Source
   with Static_Predicate => Asked in Safe_State | Mission;
   --  Asked for by a task, one request at a time

   type Job is record
      From    : Source := Keep_Alive;
      Request : Commands.Request;
      Order   : Commands.Order;
      --  the monitor's; number 0: none. Of Mission: the order that asked for
      --  the mission, never owed
   end record;

   function Source_Of (Name : Robot_Command) return Source is
     (case Table (Name).Asks.Kind is
         when Commands.Stop  => Stop_Order,
         when Commands.Drive => Movement,
         when others              => Other_Order);

   function User_Of (Item : Job) return Schedule.Task_Name is
     (case Item.From is
         when Safe_State => Schedule.Th_Com_Mon_Perdue,
         when Reload     => Schedule.Th_Start_Robot_WD,
         when Mission    => Schedule.Th_Mission,
         when Battery    => Schedule.Th_Battery_Level,
         when Keep_Alive => Schedule.Th_Open_Com_Robot,
         when others     => Table (Item.Order.Command.Name).By);
   --  The task that carries it out

   package Job_Queues is new Bounded_Queues (Job, Commands.Capacity);

   type Queue_Array is array (Source) of Job_Queues.Queue;
   type Source_Set is array (Source) of Boolean;

   type Requests is record
      Waiting      : Queue_Array;
      --  the oldest first; empty for a periodic source
      Due          : Source_Set := (others => False);
      --  the periodic ones that are due
      Quiet        : Boolean := False;
      --  a reload is due soon: only a stop or a movement may start
      In_Use       : Boolean := False;
      --  a task has the line
      Was_Stop     : Boolean := False;
      --  the last one was a monitor's stop
      First_Order  : Commands.Ticket := 1;
      --  of the session: orders with a lower number are out of date
      Last_Stop    : Commands.Ticket := 0;
      --  the session's last stop, 0: none
      Last_Hand    : Commands.Ticket := 0;
      --  its last order by hand (Commands.Is_By_Hand), 0: none
      Last_Change  : Commands.Ticket := 0;
      --  its last order that changes the robot's session, 0: none
      Last_Mission : Commands.Ticket := 0;
      --  the last mission that has asked for something, 0: none
   end record;

   function Is_Pending (R : Requests; From : Source) return Boolean is
     (if From in Periodic then R.Due (From)
      else Job_Queues.Length (R.Waiting (From)) > 0);

   function Head (R : Requests; From : Source) return Job is
     (case From is
         when Reload     => (From, (Commands.Reload, others => <>),
                             others => <>),
         when Battery    => (From, (Commands.Get_Battery, others => <>),
                             others => <>),
         when Keep_Alive => (From, (Commands.Keep_Alive, others => <>),
                             others => <>),
         when others     => Job_Queues.Element_At (R.Waiting (From), 1))
   with Pre => Is_Pending (R, From);

   function Waits_For
     (R : Requests; From : Source; Number : Commands.Ticket) return Boolean
   is (Is_Pending (R, From) and then Head (R, From).Order.Number <= Number);
   --  An order of From that has this number or a lower one waits, too

   function Is_In_Turn (R : Requests; From : Source) return Boolean is
     (case From is
         when Movement    =>
           not Waits_For (R, Other_Order, Head (R, From).Order.After),
         when Mission     =>
           not Waits_For (R, Movement, Head (R, From).Order.Number)
           and then not
             Waits_For (R, Other_Order, Head (R, From).Order.Number),
         when Other_Order =>
           not (Session.Changes_Session (Head (R, From).Request.Kind)
                and then
                  Waits_For (R, Movement, Head (R, From).Order.Number)),
         when others      => True)
   with Pre => Is_Pending (R, From);
   --  An order that changes the session waits for all orders before it, and so
   --  does a mission; a movement for the last change before it

   function Waits_For_Quiet (R : Requests; From : Source) return Boolean is
     (From in Battery .. Keep_Alive
      or else
        (From = Mission
         and then Head (R, From).Request.Kind /= Commands.Stop))
   with Pre => Is_Pending (R, From);
   --  Not started shortly before a reload of the watchdog is due

   function May_Go (R : Requests; From : Source) return Boolean is
     (Is_Pending (R, From)
      and then Is_In_Turn (R, From)
      and then
        (if From = Stop_Order and then R.Was_Stop then
            not Is_Pending (R, Reload))
      and then (if R.Quiet then not Waits_For_Quiet (R, From)));
   --  Between two stops a reload that is due has priority: an endless sequence
   --  of stops does not block the reloads

   type Verdict_Kind is
     (Carry_Out,
      Overtaken,    --  a movement cancelled by a later stop or mission; an
      --  order of a mission that a later order by hand has ended
      Out_Of_Date,  --  its session has ended
      Late);        --  an order of a mission that has waited too long

   function Verdict_On (R : Requests; Item : Job; Is_Late : Boolean)
     return Verdict_Kind
   is (if Item.From = Stop_Order
         or else (Item.Order.Number = 0 and then Item.From /= Mission)
       then Carry_Out
       elsif Item.Order.Number < R.First_Order then Out_Of_Date
       elsif Item.From = Movement
         and then
           (Item.Order.Number < R.Last_Stop
            or else Item.Order.Number < R.Last_Mission)
       then Overtaken
       elsif Item.From = Mission and then Item.Order.Number < R.Last_Hand
       then Overtaken
       elsif Item.From = Mission
         and then Is_Late
         and then Item.Request.Kind /= Commands.Stop
       then Late
       else Carry_Out)
   with
     Post =>
       (if Item.From = Mission and then Verdict_On'Result = Carry_Out then
           Item.Order.Number >= R.First_Order
           and then Item.Order.Number >= R.Last_Hand
           and then
             (if Is_Late then Item.Request.Kind = Commands.Stop));
   --  Is_Late: the request of Mission has waited for too long. A stop is never
   --  late

   function Is_Same_But (R, Before : Requests; From : Source) return Boolean is
     (for all S in Source =>
        (if S /= From then
            Job_Queues.Is_Same (R.Waiting (S), Before.Waiting (S))))
   with Ghost;

   procedure Begin_Session (R : in out Requests; First : Commands.Ticket);
   --  Orders with a number below First are now out of date

   procedure Put (R : in out Requests; Item : Job)
   with Post => Is_Same_But (R, R'Old, Item.From);
   --  Appends a request. A stop cancels older movements that still wait, and
   --  an order by hand what an older mission has asked for, or will ask for

   function Is_First (R : Requests; From : Source) return Boolean is
     (May_Go (R, From)
      and then (for all S in Source => (if May_Go (R, S) then From <= S)))
   with Ghost;

   function May_Start (R : Requests) return Boolean is
     (not R.In_Use and then (for some S in Source => May_Go (R, S)));
   --  The line is free, and a request waits that may start

   function Next (R : Requests) return Source
   with
     Pre  => May_Start (R),
     Post => Is_First (R, Next'Result)
       and then
         (if Is_Pending (R, Stop_Order) then
             Next'Result in Safe_State | Stop_Order
             or else (Next'Result = Reload and then R.Was_Stop));
   --  The most urgent request that may start. A stop precedes every other
   --  request, with two exceptions: the end of the session, and a reload after
   --  another stop

   procedure Take
     (R     : in out Requests;
      Who   : Schedule.Task_Name;
      Item  : in out Job;
      Found : out Boolean)
   with
     Post => Found =
         (May_Start (R'Old)
          and then User_Of (Head (R'Old, Next (R'Old))) = Who)
       and then
         (if Found then
             R.In_Use and then not R'Old.In_Use
             and then Item = Head (R'Old, Next (R'Old))
             and then R.Was_Stop = (Next (R'Old) = Stop_Order)
             and then Is_Same_But (R, R'Old, Next (R'Old))
          else R = R'Old and then Item = Item'Old);
   --  Found: the next request is one for Who, who has the line from now on

end Robot.Requests;
