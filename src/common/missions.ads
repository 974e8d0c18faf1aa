--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions: the robot drives by itself through points of the arena, by what
--  the camera sees. What all know of them; their parts are in src/missions.

package Missions with SPARK_Mode, Pure is

   --  Places in the arena

   type Micrometres is range -10 ** 9 .. 10 ** 9;
   --  The origin is the lower left inner corner of the arena, x to the right
   --  and y up

   type Place is record
      X, Y : Micrometres := 0;
   end record;

   type Microdegrees is range -10 ** 10 .. 10 ** 10;

   Half_Turn : constant Microdegrees := 180_000_000;
   Full_Turn : constant Microdegrees := 360_000_000;

   subtype Bearing is Microdegrees range -Half_Turn .. Half_Turn;
   --  Counter-clockwise from x

   type Pose is record
      At_Place : Place;
      Heading  : Bearing := 0;
   end record;

   type Microseconds is range 0 .. 2 ** 60;
   --  Since the mission began

   Max_Age : constant Microseconds := 300_000;
   --  Of the position behind an order, and of the newest image

   --  The arena

   subtype Arena_Side is Positive range 30 .. 1_000;
   --  Centimetres

   type Arena_Size is record
      Width  : Arena_Side := 80;
      Height : Arena_Side := 60;
   end record;

   --  What the monitor asks for

   Max_Points : constant := 64;

   subtype Point_Count is Natural range 0 .. Max_Points;
   subtype Point_Number is Point_Count range 1 .. Max_Points;

   type Unit is (Pixels, Centimetres);

   type Millionths is range -10 ** 13 .. 10 ** 13;
   --  Of a pixel or of a centimetre

   type Point is record
      X, Y : Millionths := 0;
   end record;

   type Point_Array is array (Point_Number) of Point;

   type Path is record
      Measure : Unit        := Pixels;
      Count   : Point_Count := 0;
      Points  : Point_Array;
   end record;
   --  Pixels of the whole image, x to the right and y down; or centimetres of
   --  the confirmed arena, its origin in the lower left corner

   type Place_Array is array (Point_Number) of Place;

   --  Why a mission cannot begin

   type Refusal is
     (Robot_Not_Started,
      Camera_Closed,
      Positions_Off,
      Arena_Not_Confirmed,
      Arena_Too_Small,    --  in the image: its sides are shorter than needed
      Robot_Not_Seen,     --  or more than one
      Point_Outside);     --  of the arena less the margin

   --  How a mission ends

   type Ending is
     (Completed,
      By_Hand,            --  a movement, stop or other order of the user
      Session_Over,       --  the monitor is lost: nobody is told
      Robot_Stopped,      --  the robot is lost, or no longer started
      Camera_Ended,       --  closed, or positions off, or arena given up
      No_Position,        --  three images without the robot
      No_Image,           --  for 300 ms
      No_Progress,        --  for 2 s
      Leg_Too_Long,       --  a leg takes longer than its time
      Orders_Refused,     --  by the robot
      Turns_Amiss,        --  the robot turns too little of what is ordered,
      Drives_Amiss,       --  or drives so, or does too much of it
      No_Way);            --  no permitted order leads on

   subtype Abort_Reason is Ending range By_Hand .. No_Way;

   subtype Percent is Natural range 0 .. 999;

end Missions;
