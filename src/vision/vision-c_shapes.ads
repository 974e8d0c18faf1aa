--  SPDX-License-Identifier: GPL-3.0-or-later
--  The shapes as in vision_c/vision.h, in numbers with a fraction. Those from
--  there are not trusted: one is converted only if it is within its ranges.

with Interfaces.C;  use Interfaces.C;
with Vision.Shapes; use Vision.Shapes;

package Vision.C_Shapes with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.C_Shapes);

   type C_Point is record
      X, Y : double := 0.0;
   end record
   with Convention => C;
   --  In pixels

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

   function Is_Sound (P : C_Point) return Boolean;
   --  Within ten million pixels of the image's corner

   function Is_Sound (A : C_Arena) return Boolean is
     (for all P of A => Is_Sound (P));

   function Is_Sound (R : C_Robot) return Boolean;
   --  An identifier, sound points, and at most 180 degrees

   function To_Ada (P : C_Point) return Point
   with Pre => Is_Sound (P);

   function To_Ada (R : C_Robot) return Robot
   with Pre => Is_Sound (R);
   --  Rounded to millionths

   function To_C (P : Point) return C_Point;

   function To_C (A : Arena_Corners) return C_Arena is
     (To_C (A (Top_Left)), To_C (A (Top_Right)),
      To_C (A (Bottom_Right)), To_C (A (Bottom_Left)));

   function To_C (R : Robot) return C_Robot;

   function To_C (A : Area) return C_Area;

   --  What vision_c has found, as far as it is sound

   procedure Take_Arena
     (Found : C_Arena; Arena : out Arena_Corners; Usable : out Boolean)
   with
     Post => Usable = Is_Sound (Found)
       and then
         (if Usable
          then (for all C in Corner => Arena (C) = To_Ada (Found (C)))
          else Arena = No_Arena);

   procedure Take_Robots
     (Found  : C_Robots;
      Total  : Robot_Count;
      Robots : out Robot_Array;
      Count  : out Robot_Count)
   with
     Post => Count <= Total
       and then (Count > 0) =
         (for some K in 1 .. Total => Is_Sound (Found (K)))
       and then
         (if (for all K in 1 .. Total => Is_Sound (Found (K)))
          then Count = Total
            and then
              (for all K in 1 .. Total => Robots (K) = To_Ada (Found (K))));
   --  The sound ones of Found (1 .. Total), in their order

end Vision.C_Shapes;
