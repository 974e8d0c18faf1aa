--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions in simulated time: the supervisor's run drives the emulator's
--  robot over a line at 9600 baud, and sees it by a camera of 10 images a
--  second.

with GNAT.Random_Numbers;

with Missions;
with Robot_Motion;

package Simulated_Missions is

   type Milliseconds is delta 0.001 digits 12;
   type Millimetres is delta 0.001 digits 12;

   type Faults is record
      Wheels        : Robot_Motion.Wheel_Errors;
      Changing      : Natural range 0 .. 30 := 0;
      --  percent by which the speeds change from order to order, either way
      Image_Delay   : Milliseconds := 0.0;
      --  what an image shows is so much older than the image
      Place_Noise   : Float := 0.0;
      --  millimetres in x and in y, standard deviation
      Heading_Noise : Float := 0.0;
      --  degrees
      Lose_Every    : Natural := 0;
      --  of so many answers, one is lost; 0: none
   end record;

   Ideal : constant Faults := (others => <>);

   Start_Time    : constant Robot_Motion.Time_Point := 1_000_000;
   --  of each mission
   After_The_End : constant Robot_Motion.Time_Point := 300_000;

   type Mission is record
      Start   : Robot_Motion.Pose;
      Count   : Missions.Point_Number := 1;
      Targets : Missions.Place_Array;
   end record;

   type Result is record
      Ended      : Missions.Ending := Missions.No_Way;
      Measured   : Missions.Percent := 0;
      Worst_Pass : Millimetres  := 0.0;
      --  of all points the farthest that the robot's way was from the point
      --  during its leg
      Room       : Millimetres  := 0.0;
      --  least, between the robot and the border
      Blind      : Milliseconds := 0.0;
      --  longest time in which it moved and no image came
      Time       : Milliseconds := 0.0;
      Exact      : Milliseconds := 0.0;
      --  of a robot with the same speeds that turns and drives exactly
      Orders     : Natural := 0;
   end record;

   function Ratio (R : Result) return Float is
     (Float (R.Time) / Float'Max (1.0, Float (R.Exact)));

   procedure Make_Faults
     (Source : GNAT.Random_Numbers.Generator; F : out Faults);
   --  All of them: speeds 70 to 130 percent, overshoot to 20, pull 30 degrees
   --  a metre either way, images late by 0 to 150 ms, noise of 2.8 mm and
   --  half a degree, every tenth answer lost

   procedure Make_Mission
     (Source : GNAT.Random_Numbers.Generator;
      Count  : Missions.Point_Number;
      M      : out Mission);
   --  From anywhere through anywhere inside the targets' margin

   procedure Simulate
     (M      : Mission;
      F      : Faults;
      Seed   : Integer;
      R      : out Result;
      Traced : Boolean := False;
      Image  : access procedure (Time : Robot_Motion.Time_Point) := null;
      Place  : access procedure
        (Time   : Robot_Motion.Time_Point;
         Where  : Robot_Motion.Pose;
         Moving : Boolean) := null);
   --  Traced: prints what happens. Image: one has come; Place: where the
   --  robot is, every few milliseconds, from the beginning to After_The_End

end Simulated_Missions;
