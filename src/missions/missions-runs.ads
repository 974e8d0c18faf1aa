--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a mission: from what the camera has seen and what the robot has
--  been told, the next order or none.

with Commands;
with Missions.Angles;   use Missions.Angles;
with Missions.Guards;   use Missions.Guards;
with Missions.Learning; use Missions.Learning;

package Missions.Runs with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Missions.Runs);

   use type Commands.Movement_Kind;
   use type Commands.Outcome_Kind;
   use type Commands.Request_Kind;

   Max_Missing : constant := 3;
   --  images in a row without the robot
   Max_Orders  : constant := 40;
   --  in a leg

   type Sighting is record
      Number : Natural      := 0;
      --  of the image: another one for each
      Taken  : Microseconds := 0;
      --  when it came from the camera. What it shows may be older
      Seen   : Boolean      := False;
      --  exactly one robot is in it
      Where  : Pose;
   end record;

   type Action_Kind is
     (Nothing,       --  wait for the next image, or Next_Look
      Ask,           --  ask the robot whether it moves
      Order,         --  a movement or, before the first one, a stop
      Stop,          --  the mission has ended: the robot must stop
      Leave);        --  the mission has ended, nothing more is to be done

   type Action is record
      Kind    : Action_Kind := Nothing;
      Request : Commands.Request;
      --  of Ask, Order and Stop
   end record;

   type Run is private;
   --  Times are those of one clock, whose zero may be any moment

   function Has_Ended (R : Run) return Boolean;

   function Ended_By (R : Run) return Ending
   with Pre => Has_Ended (R);

   function Measured (R : Run) return Percent;
   --  Turns_Amiss, Drives_Amiss: what the robot did of what was ordered

   function Leg (R : Run) return Point_Number;
   --  The target that is driven to

   function Legs (R : Run) return Point_Number;

   function Distance (R : Run) return Micrometres;
   --  To it, as last seen

   --  Used in the contracts

   function Size (R : Run) return Arena_Size with Ghost;

   function Position_Time (R : Run) return Microseconds with Ghost;
   --  When the newest image that shows the robot came

   function Position (R : Run) return Pose with Ghost;
   --  Where the robot is believed to be while it rests

   function Doubts (R : Run) return Missions.Guards.Doubts;
   --  What is not known of its next drive

   function Leg_End (R : Run) return Microseconds with Ghost;
   --  When the leg's time is over

   function Orders_Left (R : Run) return Natural with Ghost;
   --  Of the whole mission

   function Is_Permitted (R : Run; Request : Commands.Request)
     return Boolean
   is (Request.Kind = Commands.Stop
       or else
         (Request.Kind = Commands.Drive
          and then
            (if Request.Command.Kind = Commands.Move then
                Request.Command.Value in Drive_Length
                and then Is_Permitted
                  (Position (R), Request.Command.Value, Doubts (R),
                   Size (R)))))
   with Ghost;
   --  A turn, whose place is that of the robot, or a drive that the guards
   --  permit

   function Is_Kept (R, Before : Run) return Boolean is
     (Orders_Left (R) <= Orders_Left (Before)
      and then
        (if Has_Ended (Before) then
            Has_Ended (R) and then Ended_By (R) = Ended_By (Before)))
   with Ghost;
   --  No operation gives more orders, or goes on after the end

   procedure Start
     (R       : out Run;
      Size    : Arena_Size;
      Targets : Place_Array;
      Count   : Point_Number;
      Now     : Microseconds)
   with Post => not Has_Ended (R);

   procedure See (R : in out Run; What : Sighting)
   with Post => Is_Kept (R, R'Old);
   --  The newest image; the same one again has no effect

   procedure Step (R : in out Run; Now : Microseconds; Next : out Action)
   with
     Post => Is_Kept (R, R'Old)
       and then (if Has_Ended (R) then Next.Kind in Stop | Leave
                 else Next.Kind not in Stop | Leave)
       and then
         (case Next.Kind is
             when Ask             =>
               Next.Request.Kind = Commands.Get_Moving,
             when Stop            =>
               Next.Request.Kind = Commands.Stop,
             when Order           =>
               Orders_Left (R) < Orders_Left (R'Old)
               and then Now < Leg_End (R)
               and then Is_Permitted (R, Next.Request)
               and then
                 (if Next.Request.Kind = Commands.Drive then
                     Position_Time (R) <= Now
                     and then Now - Position_Time (R) <= Max_Age),
             when Nothing | Leave => True);
   --  What is to be done now

   procedure Tell
     (R : in out Run; Result : Commands.Outcome; Now : Microseconds)
   with Post => Is_Kept (R, R'Old);
   --  What has become of the last action (Ask, Order, Stop)

   procedure End_By (R : in out Run; Why : Abort_Reason)
   with
     Post => Is_Kept (R, R'Old)
       and then Has_Ended (R)
       and then (if not Has_Ended (R'Old) then Ended_By (R) = Why);
   --  From outside. No effect once it has ended. By_Hand and Session_Over:
   --  the next step is Leave, others: Stop, then Leave

   function Next_Look (R : Run; Now : Microseconds) return Microseconds;
   --  Step is due then even if no image comes

private

   Enough_Images : constant := 2;
   Max_Images    : constant := 8;
   subtype Image_Count is Natural range 0 .. Max_Images;

   type Phase_Kind is
     (Looking,  --  the robot rests, or will within an image: wait for images
      Aiming,   --  the robot rests where it is believed to be
      Moving);  --  an order is under way

   subtype Awaited_Kind is Action_Kind
   with Static_Predicate => Awaited_Kind in Nothing .. Stop;

   type Movement_Kind is (Halt, Turn, Drive);

   subtype Turn_Count is Natural range 0 .. 2;
   --  Turns since the last drive; 2: or more

   Upset_Way : constant := 15_000;
   --  Micrometres from the mean place: more in a turn means that the robot was
   --  moved

   Stop_Tries    : constant := 3;
   Refusal_Limit : constant := 3;

   type Run is record
      Size        : Arena_Size;
      Targets     : Place_Array;
      Legs        : Point_Number := 1;
      Leg         : Point_Number := 1;

      Ended       : Boolean := False;
      Why         : Ending  := Completed;
      Stops       : Natural range 0 .. Stop_Tries := 0;
      --  still to be asked for, once it has ended

      --  Limits
      Leg_End     : Microseconds := 0;
      Orders      : Natural range 0 .. Max_Orders := Max_Orders;
      --  left in the leg
      Refusals    : Natural range 0 .. Refusal_Limit := 0;
      --  in a row
      Missing     : Natural range 0 .. Max_Missing := 0;
      Anchor      : Near_Pose;
      Anchored    : Microseconds := 0;
      --  where and when it was far from where it had been

      --  The newest image, and the newest with the robot
      Number      : Natural := 0;
      Some_Image  : Boolean := False;
      Came        : Microseconds := 0;
      Seen_At     : Microseconds := 0;
      Newest      : Near_Pose;

      --  What is done
      Halted      : Boolean       := False;
      --  the robot has been stopped before the first order
      Phase       : Phase_Kind    := Looking;
      Awaited     : Awaited_Kind  := Nothing;
      Movement    : Movement_Kind := Halt;
      Amount      : Integer range -5_000 .. 5_000 := 0;
      --  degrees or millimetres of the last order
      Sure        : Boolean := False;
      --  it was taken
      Given       : Microseconds := 0;
      Ask_At      : Microseconds := 0;

      --  Where the robot rests: the mean of Count images
      Rest_From   : Microseconds := 0;
      Count       : Image_Count := 0;
      Mean        : Near_Pose;
      Expected    : Boolean := False;
      --  Count = 0: the mean is where it should be
      Confirmed   : Boolean := False;
      --  and the first image showed it there
      Upset       : Boolean := False;
      --  in a turn, an image showed it elsewhere

      Part        : Turn_Part;
      --  of the last turn

      --  Since the last look
      Made        : Movements;
      Learnable   : Boolean := False;
      Turns_Made  : Turn_Count := 0;

      Amiss       : Movement_Kind := Halt;
      --  Turn, Drive: the last look at one showed no Gain,
      Measured    : Percent := 0;
      --  but this

      Known       : Knowledge;
   end record;

   --  For Missions.Runs.Aims too

   function Is_As_Far (R, Before : Run) return Boolean is
     (R.Leg = Before.Leg
      and then R.Orders = Before.Orders
      and then R.Seen_At = Before.Seen_At)
   with Ghost;

   function Is_Same (R, Before : Run) return Boolean is
     (Is_As_Far (R, Before)
      and then R.Ended = Before.Ended
      and then R.Why = Before.Why
      and then R.Leg_End = Before.Leg_End
      and then R.Size = Before.Size)
   with Ghost;
   --  Neither further nor ended

   procedure Finish (R : in out Run; Why : Ending)
   with
     Pre  => not R.Ended,
     Post => R.Ended and then R.Why = Why and then Is_As_Far (R, R'Old);

   procedure Finish_Amiss (R : in out Run; What : Movement_Kind)
   with
     Pre  => not R.Ended,
     Post => R.Ended and then Is_As_Far (R, R'Old);
   --  It goes so far amiss, as measured; Halt, or none measured: it does not
   --  go on

   function Target (R : Run) return Near_Pose is
     ((X       => Near_Of (R.Targets (R.Leg).X),
       Y       => Near_Of (R.Targets (R.Leg).Y),
       Heading => 0));

   procedure Limit_Leg (R : in out Run; Now : Microseconds)
   with
     Post => R.Orders = Max_Orders
       and then R.Ended = R.Ended'Old
       and then R.Leg = R.Leg'Old
       and then R.Legs = R.Legs'Old
       and then R.Size = R.Size'Old
       and then R.Seen_At = R.Seen_At'Old;
   --  The leg begins now

   function Has_Ended (R : Run) return Boolean is (R.Ended);

   function Ended_By (R : Run) return Ending is (R.Why);

   function Measured (R : Run) return Percent is (R.Measured);

   function Leg (R : Run) return Point_Number is (R.Leg);

   function Legs (R : Run) return Point_Number is (R.Legs);

   function Distance (R : Run) return Micrometres is
     (Way (R.Newest, Target (R)));

   function Size (R : Run) return Arena_Size is (R.Size);

   function Position_Time (R : Run) return Microseconds is (R.Seen_At);

   function Position (R : Run) return Pose is (Pose_Of (R.Mean));

   function Doubts (R : Run) return Missions.Guards.Doubts is
     (Doubts_Of (R.Known, R.Made.Turned));

   function Leg_End (R : Run) return Microseconds is (R.Leg_End);

   function Orders_Left (R : Run) return Natural is
     (R.Orders + (Max_Points - R.Leg) * Max_Orders);

end Missions.Runs;
