--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as the analysis sees it: which activity runs where, what
--  sets it off, what it calls; and the bounds that the features demand.

with Budgets;        use Budgets;
with Response_Times; use Response_Times;
with Schedule;

package Supervisor_Model with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Supervisor_Model);
   --  A claim that GNATprove checks: every subprogram ends

   type Priority_Choice is
     (Of_The_Table,        --  src/common/schedule.ads
      Of_The_Report);
   --  The report's threads with their own; what it has not takes the number
   --  of the threads that did the work there

   type Placement is
     (Real_Time_Apart,     --  --cpu: all tasks but the image work and the
                           --  console on one processor
      One_Processor);      --  everything on one

   type Machine is record
      Percent       : Positive_Span := 100;
      --  of the budgets: what they are multiplied by
      Second        : Boolean := False;
      --  the budgets are the second machine's; else of each the longer one
      Many          : Boolean := False;
      --  a processor for each of the three image tasks; else one for all
   end record
   with Predicate => Percent <= 100_000;

   type Load is record
      Turnaround : Span := Robot_Turnaround;
      Latency    : Span := Wake_Latency;
      Commands   : Positive_Span := Command_Interval;
      --  of the monitor, from one to the next; Question_Interval if Mission
      Silent     : Boolean := False;
      --  one exchange stays without an answer, until its time-out
      Time_Out   : Span := 1_000 * Schedule.Answer_Timeout_Ms;
      --  --answer-timeout
      Flood      : Boolean := False;
      --  newcomers all the time, as many as th_server sees to
      Mission    : Boolean := False;
      --  missions are under way: the monitor's commands are questions,
      --  Question_Interval apart, and once a second an order by hand, which
      --  ends the mission
   end record
   with Predicate => Turnaround <= 1_000_000 and then Latency <= 1_000_000
     and then Time_Out <= 1_000_000;

   type Line_Client is
     (Safe_State, Stop_Order, Reload, Movement, Mission, Battery, Other_Order,
      Ping, Unanswered);
   --  Of the robot's line, by falling urgency; then an exchange that is not
   --  answered, with the probe that brings the line into step again

   type Requirement_Name is
     (F2_Admitted,
      F4_Own_Answer,
      F4_Robot_Answer,
      F4_Unsolicited,
      F6_Stop,
      F11_Reload,
      F12_First_Byte,
      F12_At_Robot,
      F13_Level,
      F13_Processor,
      F15_Image,
      F15_Jitter,
      Mission_Order,
      Mission_At_Robot);

   type Requirement is record
      Bound : Microseconds := 0;
      Limit : Microseconds := 0;
      --  0: nothing is demanded under this load
      Known : Boolean := False;
      --  a bound exists
   end record;

   function Always (Name : Requirement_Name) return Boolean is
     (Name in F2_Admitted | F6_Stop | F11_Reload | F12_At_Robot | F13_Level
        | F15_Image);
   --  Demanded of every single one. The others are demanded of 99 or 99.9
   --  in 100: a bound for the worst case is more than that

   function Met (Item : Requirement) return Boolean is
     (Item.Known and then Item.Bound <= Item.Limit);

   subtype Row_Index is Activity_Index range
     1 .. Activity_Name'Pos (Activity_Name'Last) + 4;
   --  All activities, then the kernel on three other processors

   function Row (Name : Activity_Name) return Row_Index is
     (Activity_Name'Pos (Name) + 1);

   subtype Activity_Set is Activity_Array (Row_Index);

   type Row_Bounds is array (Activity_Name) of Bound;
   type Owner_Bounds is record
      Request : Bound;
      Answer  : Bound;
      Outcome : Bound;
      --  Answer, and what comes of an order after it
   end record;
   --  Of the task that has the line, within one transaction: its activities do
   --  not delay each other

   type Owner_Array is array (Line_Client) of Owner_Bounds;
   --  By the priority of the task that carries out such a request

   type Line_Bounds is array (Line_Client) of Bound;
   type Line_Times is array (Line_Client) of Span;
   type Deadline_Times is array (Activity_Name) of Span;
   type Requirement_Array is array (Requirement_Name) of Requirement;

   type Analysis is record
      Set          : Activity_Set;
      Bounds       : Row_Bounds;
      Owner        : Owner_Array;
      Deadlines    : Deadline_Times := (others => 0);
      --  of one activity, from its arrival; 0: none of its own
      Settled      : Boolean := False;
      --  jitters and bounds agree
      Line_Length  : Line_Times  := (others => 0);
      Line         : Line_Bounds;
      Requirements : Requirement_Array;
   end record;

   Reload_Limit : constant Microseconds;
   --  A reload that is not later than this misses one window at most; the
   --  robot stops at the third

   procedure Analyse
     (Choice : Priority_Choice;
      Where  : Placement;
      On     : Machine;
      Under  : Load;
      Result : out Analysis);

   subtype Task_Activity is Activity_Name range
     Activity_Name'Succ (Kernel) .. Activity_Name'Pred (Environment);

   function Task_Name (Name : Activity_Name) return String;

   function Calls (Name : Activity_Name; Which : Operation_Name)
     return Natural
   with Post => Calls'Result <= 20;
   --  How often one release calls such an operation, at most

   function Stays_Here (Name : Activity_Name) return Boolean;
   --  The image work and the log touch none of its objects: these are those
   --  of Robot

   function Ceilings_Hold (Choice : Priority_Choice) return Boolean;
   --  No activity calls an operation whose ceiling is below its priority

   function Priority_Of
     (Name : Activity_Name; Choice : Priority_Choice) return Urgency;

   function Promises_Kept (Result : Analysis) return Boolean;
   --  Every requirement of every single one

   function Deadlines_Met (Result : Analysis) return Boolean;
   --  And every deadline of an activity

   function All_Met (Result : Analysis) return Boolean;
   --  And in the worst case even what is demanded of most

   function Load_Of
     (Result : Analysis; Processor : Processor_Number) return Microseconds;
   --  Utilisation in parts per 10_000

private

   Reload_Limit : constant Microseconds := 1_000_000;

end Supervisor_Model;
