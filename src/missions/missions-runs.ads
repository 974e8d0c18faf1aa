--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a mission: decides the next order from the images and from the
--  answers to earlier orders.

with Commands;
with Missions.Angles;  use Missions.Angles;
with Missions.Driving; use Missions.Driving;

package Missions.Runs with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Missions.Runs);  --  proved

   use type Commands.Movement_Kind;
   use type Commands.Outcome_Kind;
   use type Commands.Request_Kind;

   Max_Missing : constant := 3;
   --  images in a row without the robot
   Max_Orders  : constant := 40;
   --  in a leg

   type Sighting is record
      Number : Natural      := 0;
      --  of the image: each has another
      Taken  : Microseconds := 0;
      --  when it came from the camera: it was exposed earlier
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
   --  For Turns_Amiss and Drives_Amiss: the robot's movement, of the ordered
   --  one

   function Leg (R : Run) return Point_Number;
   --  The target that is driven to

   function Legs (R : Run) return Point_Number;

   function Distance (R : Run) return Micrometres;
   --  To it, as last seen

   --  Used in the contracts

   function Orders_Left (R : Run) return Natural with Ghost;
   --  In the whole mission

   function Is_Permitted
     (R : Run; Request : Commands.Request; Now : Microseconds) return Boolean
   with Ghost;
   --  A stop while the leg has time left; a turn if also the newest position
   --  is at most Max_Age old; a drive if also the guard permits it from where
   --  the robot is believed to rest

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
       and then Has_Ended (R) = (Next.Kind in Stop | Leave)
       and then
         (case Next.Kind is
             when Ask             => Next.Request.Kind = Commands.Get_Moving,
             when Stop            => Next.Request.Kind = Commands.Stop,
             when Order           =>
               Orders_Left (R) < Orders_Left (R'Old)
               and then Is_Permitted (R, Next.Request, Now),
             when Nothing | Leave => True);
   --  What is to be done now

   procedure Tell
     (R : in out Run; Result : Commands.Outcome; Now : Microseconds)
   with Post => Is_Kept (R, R'Old);
   --  The result of the last action (Ask, Order, Stop)

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

   --  Microseconds, micrometres, microdegrees

   --  The nominal robot

   Time_Per_Millimetre : constant := 5_000;   --  200 mm/s
   Time_Per_Degree     : constant := 11_112;  --  90 degrees/s

   --  Limits

   Slowest    : constant := 4;
   --  An order may take its duration times this, and Still_Time

   Still_Time : constant := 2_000_000;
   --  A mission ends when it has made no progress for this time. Progress is
   --  a way or a turn longer than:
   Progress_Way  : constant := 10_000;
   Progress_Turn : constant := 5_000_000;

   Leg_Time                : constant := 15_000_000;
   Leg_Time_Per_Millimetre : constant := Slowest * Time_Per_Millimetre;
   --  A leg may take Leg_Time for its turns and looks, and the time of the
   --  slowest drive

   Ask_Period : constant := 20_000;
   --  Between two questions whether the robot moves

   --  What images show

   Good_Part     : constant := 20_000_000;
   --  The camera's latency is learnt from an image within a turn, after the
   --  robot has turned by this, and four times this at most

   Enough_Images : constant := 2;
   Many_Images   : constant := 4;

   Unsure_Way    : constant := 3_000;
   --  If the distance to the target differs from the limit by less, more
   --  images are waited for

   function There (Images : Image_Count) return Micrometres is
     (case Images is
         when 0 .. 1          => 6_000,
         when 2               => 8_000,
         when 3 .. Max_Images => 9_000);
   --  A target is reached at this distance. More images give a better mean

   type Phase_Kind is
     (Looking,  --  the robot rests, or will within an image: wait for images
      Aiming,   --  the robot rests where it is believed to be
      Moving);  --  an order is under way

   subtype Awaited_Kind is Action_Kind
   with Static_Predicate => Awaited_Kind in Nothing .. Stop;

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
      --  that the leg has left
      Refusals    : Natural range 0 .. Refusal_Limit := 0;
      --  in a row
      Missing     : Natural range 0 .. Max_Missing := 0;
      Anchor      : Near_Pose;
      Anchored    : Microseconds := 0;
      --  where and when the robot last made progress

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
      --  the robot has taken the order
      Given       : Microseconds := 0;
      Ask_At      : Microseconds := 0;

      --  Where the robot rests
      Rest_From   : Microseconds := 0;
      Rest        : Resting;
      Upset       : Boolean := False;
      --  in a turn, an image showed that it was moved

      Part        : Turn_Part;
      --  of the last turn

      --  Since the last look
      Made        : Movements;
      Learnable   : Boolean := False;
      Turns_Made  : Turn_Count := 0;

      Amiss       : Movement_Kind := Halt;
      --  Turn, Drive: no Gain explained the last one that was looked at
      Measured    : Percent := 0;
      --  the robot's movement, of what was ordered then

      Known       : Knowledge;
   end record;

   function Has_Ended (R : Run) return Boolean is (R.Ended);

   function Ended_By (R : Run) return Ending is (R.Why);

   function Measured (R : Run) return Percent is (R.Measured);

   function Leg (R : Run) return Point_Number is (R.Leg);

   function Legs (R : Run) return Point_Number is (R.Legs);

   function Has_Position (R : Run; Now : Microseconds) return Boolean is
     (R.Seen_At <= Now and then Now - R.Seen_At <= Max_Age);
   --  New enough for an order

   function Is_Permitted
     (R : Run; Request : Commands.Request; Now : Microseconds) return Boolean
   is (Now < R.Leg_End
       and then
         (Request.Kind = Commands.Stop
          or else
            (Request.Kind = Commands.Drive
             and then Has_Position (R, Now)
             and then
               (if Request.Command.Kind = Commands.Move then
                   Request.Command.Value in Drive_Length
                   and then Is_Permitted
                     (Pose_Of (R.Rest.Mean), Request.Command.Value,
                      Doubts_Of (R.Known, R.Made.Turned), R.Size)))));

   function Orders_Left (R : Run) return Natural is
     (R.Orders + (Max_Points - R.Leg) * Max_Orders);

end Missions.Runs;
