--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random missions: where the robot stands, what is not ideal about it, and
--  the points that it has to pass.

with Robot_Motion; use type Robot_Motion.Micro;

package Mission_Plans is

   subtype Micro is Robot_Motion.Micro;

   type Place is record
      X, Y : Micro range 0 .. Robot_Motion.Arena_Width := 0;
   end record;
   --  Micrometres from the lower left inner corner of the arena

   Max_Points : constant := 64;

   subtype Point_Count is Natural range 0 .. Max_Points;
   subtype Point_Number is Point_Count range 1 .. Max_Points;
   type Place_Array is array (Point_Number) of Place;

   Margin : constant := 80_000;
   --  Least distance of a point and of the robot at the start from the walls

   type Plan is record
      Number  : Positive := 1;
      Faulty  : Boolean  := False;
      Radio   : Boolean  := False;
      --  Between the supervisor and the robot; then no answer is lost
      Start   : Robot_Motion.Pose;
      Wheels  : Robot_Motion.Wheel_Errors;
      --  Ideal unless Faulty
      Count   : Point_Count := 0;
      Points  : Place_Array;
   end record;

   --  Where Faulty

   Camera_Delay : constant := 150;  --  milliseconds
   Displacement : constant := 2;    --  pixels, standard deviation
   Drop_Every   : constant := 9;    --  answers. Of ten exchanges a second the
                                    --  tenth is the reload's each time

   function Random
     (Seed : Natural; Number : Positive; Least : Point_Number := 5) return Plan
     with Pre  => Least <= 12,
          Post => Random'Result.Number = Number
                  and then Random'Result.Count in Least .. 12
                  and then Random'Result.Faulty = (Number mod 2 = 0);
   --  Through Least to 12 points. The same for the same arguments; whole
   --  tenths of millimetres.
   --  Where Faulty: each error of the wheels is anything the emulator offers

   Bad_Plan : exception;

   function Read (Pose, Order : String) return Plan;
   --  One with ideal wheels. Pose: X,Y,HEADING as the emulator has it; Order:
   --  MPCM with its points. Raises Bad_Plan

   function Order (P : Plan) return String with Pre => P.Count > 0;
   --  MPCM with its points

   function Exact_Time (P : Plan) return Duration with Pre => P.Count > 0;
   --  What a robot with these speeds takes that turns and drives exactly

end Mission_Plans;
