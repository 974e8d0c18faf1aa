--  SPDX-License-Identifier: GPL-3.0-or-later
--  The emulated robot's position and its motion: integers only, a pose as a
--  function of the time since the last order.

package Robot_Motion with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Robot_Motion);
   --  A claim that GNATprove checks: every subprogram ends

   type Micro is range -2 ** 62 .. 2 ** 62;
   --  Micrometres, microdegrees and microseconds

   subtype Time_Point is Micro range 0 .. 2 ** 60;
   --  Microseconds since the emulator started (36,000 years of them)

   Wheel_Speed : constant := 200;
   --  Straight ahead, mm/s. The firmware's controller uses one set point for
   --  both wheels whatever the distance, so there is one speed.

   Turn_Rate : constant := 90;
   --  On the spot, degrees/s. Neither rate is documented for the robot;
   --  these are plausible for wheels of its size.

   Arena_Width  : constant := 800_000;  --  inner edges, micrometres
   Arena_Height : constant := 600_000;

   Body_Radius : constant := 62_000;
   --  The robot's radius, micrometres, as drawn by tests/scene: its centre
   --  stays this far from a wall

   Full_Turn : constant := 360_000_000;

   subtype X_Position is Micro
     range Body_Radius .. Arena_Width - Body_Radius;
   --  From the left inner edge of the arena
   subtype Y_Position is Micro
     range Body_Radius .. Arena_Height - Body_Radius;
   --  From the bottom inner edge
   subtype Heading is Micro range 0 .. Full_Turn - 1;
   --  Counter-clockwise, 0 looks along x

   type Pose is record
      X     : X_Position := Arena_Width / 2;
      Y     : Y_Position := Arena_Height / 2;
      Angle : Heading    := 0;
   end record;

   subtype Amount is Integer range -32_768 .. 32_767;
   --  Of an order: millimetres or degrees

   Endless_Forward  : constant Amount := 32_767;
   Endless_Backward : constant Amount := -32_768;
   --  A movement by one of these never ends by itself. A positive turn is to
   --  the left (counter-clockwise).

   --  What is not ideal about a robot

   subtype Speed_Percent is Integer range 3 .. 200;
   subtype Overshoot_Percent is Integer range 0 .. 20;
   subtype Pull_Angle is Integer range -30 .. 30;

   type Wheel_Errors is record
      Speed      : Speed_Percent     := 100;
      --  Straight on, of Wheel_Speed
      Turn_Speed : Speed_Percent     := 100;
      --  Of Turn_Rate
      Overshoot  : Overshoot_Percent := 0;
      --  A finite turn goes on by this part of its angle
      Pull       : Pull_Angle        := 0;
      --  Degrees of heading per metre forward, to the left if positive
   end record;
   --  The robot does not know of them. An order takes the time of an ideal
   --  robot, so it goes that much less or further; only the overshoot makes
   --  its time longer, by the same part. A turn by A therefore ends at
   --  exactly A * Turn_Speed * (1 + Overshoot). A pull makes an arc of the
   --  way; backward, the robot returns along the same arc.

   Ideal : constant Wheel_Errors := (others => <>);

   type Motion is private;
   --  A robot's pose and what its wheels are doing; at rest in the middle
   --  of the arena by default

   function Is_Moving (M : Motion) return Boolean;
   --  The wheels are turning. Against a wall they slip, for as long as the
   --  order would have taken.

   function Start_Of (M : Motion) return Pose;
   --  Where the current order began, or where the robot rests

   function Pose_Of (M : Motion) return Pose
     with Post => (if not Is_Moving (M) then Pose_Of'Result = Start_Of (M));
   --  Of each order a function of the time since it began: rounding does not
   --  add up. On free ground an order ends at most 40 micrometres from where
   --  it should, in x and in y, mostly by the error of Sine; its angle is
   --  exact. At a wall the robot stays where it touched it, also on an arc.

   procedure Place (M : out Motion; At_Pose : Pose)
     with Post => Pose_Of (M) = At_Pose and then not Is_Moving (M);
   --  Moves the robot by hand; it is then at rest

   procedure Halt (M : in out Motion)
     with Post => not Is_Moving (M);
   --  Stops at once where it is

   procedure Go
     (M           : in out Motion;
      Millimetres : Amount;
      Errors      : Wheel_Errors := Ideal)
   with Post => Is_Moving (M) = (Millimetres /= 0);
   --  Straight ahead, backward if negative; replaces the current order

   procedure Turn
     (M       : in out Motion;
      Degrees : Amount;
      Errors  : Wheel_Errors := Ideal)
   with Post => Is_Moving (M) = (Degrees /= 0);
   --  On the spot, to the left if positive; also replaces the order

   subtype Step is Micro range 0 .. 1_000_000;

   procedure Advance (M : in out Motion; Elapsed : Step)
     with Post => (if not Is_Moving (M'Old) then not Is_Moving (M));
   --  Advances by Elapsed microseconds; at rest once the order is done

   function Sine (Angle : Heading) return Micro
     with Post => Sine'Result in -1_000_000 .. 1_000_000;
   --  In millionths, with an error of at most 40

   function Cosine (Angle : Heading) return Micro
     with Post => Cosine'Result in -1_000_000 .. 1_000_000;

private

   type Order_Kind is (None, Straight, Rotation);

   Longest_Run : constant := 440_000_000;
   --  Microseconds: the longest finite order is a turn by 32,767 degrees that
   --  overshoots, 437 s

   subtype Run_Time is Micro range 0 .. Longest_Run;

   subtype Travel is Micro
     range 0 .. Longest_Run * Turn_Rate * Micro (Speed_Percent'Last) / 100;
   --  Micrometres or microdegrees

   type Motion is record
      From     : Pose;                  --  where the order began
      Order    : Order_Kind := None;
      Errors   : Wheel_Errors;          --  in the order
      Endless  : Boolean    := False;
      Positive : Boolean    := True;    --  forward, or to the left
      Duration : Run_Time   := 0;       --  of a finite order
      Limit    : Travel     := 0;       --  to a wall, or a turn's end
      Done     : Run_Time   := 0;       --  time since it began
   end record;

   function Is_Moving (M : Motion) return Boolean is (M.Order /= None);

   function Start_Of (M : Motion) return Pose is (M.From);

end Robot_Motion;
