--  SPDX-License-Identifier: GPL-3.0-or-later
--  The shapes as in vision_c/vision.h, in numbers with a fraction. Those from
--  there are not trusted: one is converted only if it is within its ranges.

with Interfaces.C; use Interfaces.C;

package Vision.C_Shapes with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.C_Shapes);  --  proved

   type C_Point is record
      X, Y : double := 0.0;  --  in pixels
   end record
   with Convention => C;

   type C_Arena is array (Corner) of C_Point
   with Convention => C;

   type C_Robot is record
      Id        : int := 0;
      Centre    : C_Point;
      Direction : C_Point;
      Angle     : double := 0.0;  --  in degrees
   end record
   with Convention => C;

   type C_Robots is array (Robot_Array'Range) of C_Robot
   with Convention => C;

   type C_Area is record
      Centre : C_Point;
      Reach  : double := 0.0;
   end record
   with Convention => C;

   type C_Areas is array (Area_Array'Range) of C_Area
   with Convention => C;

   function Is_Sound (P : C_Point) return Boolean is
     (P.X in -1.0E7 .. 1.0E7 and then P.Y in -1.0E7 .. 1.0E7);
   --  Within ten million pixels of the image's corner

   function Is_Sound (A : C_Arena) return Boolean is
     (for all P of A => Is_Sound (P));

   function Is_Sound (R : C_Robot) return Boolean is
     (R.Id in int (Identifier'First) .. int (Identifier'Last)
      and then Is_Sound (R.Centre)
      and then Is_Sound (R.Direction)
      and then R.Angle in -180.0 .. 180.0);

   --  Rounded to millionths

   function To_Ada (P : C_Point) return Point
   with Pre => Is_Sound (P);

   function To_Ada (A : C_Arena) return Arena_Corners is
     (To_Ada (A (Top_Left)), To_Ada (A (Top_Right)),
      To_Ada (A (Bottom_Right)), To_Ada (A (Bottom_Left)))
   with Pre => Is_Sound (A);

   function To_Ada (R : C_Robot) return Robot
   with Pre => Is_Sound (R);

   procedure Take_Robots
     (Found  : C_Robots;
      Total  : Robot_Count;
      Robots : out Robot_Array;
      Count  : out Robot_Count)
   with Post => Count <= Total;
   --  The sound ones of Found (1 .. Total), in their order

   function To_C (A : Arena_Corners) return C_Arena;

   function To_C (R : Robot) return C_Robot;

   function To_C (A : Area) return C_Area;

end Vision.C_Shapes;
