--  SPDX-License-Identifier: GPL-3.0-or-later
--  From the image to the arena: the projective map (homography) that takes the
--  four corners confirmed by the user to those of a rectangle, in integers.

with Missions.Driving;
with Vision;

package Missions.Arenas with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Arenas);  --  proved

   --  The corners are rounded to sixteenths of a pixel when the map is made.
   --  Nothing else is: a place is a quotient of integers, in micrometres.

   type Wide is range -(2 ** 127 - 1) .. 2 ** 127 - 1;
   --  For the products: GNAT has 128 bits on processors with 64

   subtype Sixteenths is Wide range -8 .. 65_527;
   --  Of a pixel: all of an image of 4,096 pixels a side

   type Grid_Point is record
      X, Y : Sixteenths := 0;
   end record;

   Largest_Side : constant := Arena_Side'Last * 10_000;
   --  Micrometres

   subtype Weight is Wide range 0 .. 2 ** 64;
   subtype Numerator is Wide range -2 ** 113 .. 2 ** 113;
   subtype Denominator is Wide range -2 ** 114 .. 2 ** 114;

   subtype Divisor is Denominator range 1 .. 2 ** 112;
   --  In an arena, no denominator is outside: they are linear, and those of
   --  its corners are Unit_Size times three areas of at most 2 ** 32

   Unit_Size : constant := 62_500;
   --  A sixteenth, in millionths

   function Is_In_Image (P : Vision.Point) return Boolean is
     (Wide (P.X) in
        Sixteenths'First * Unit_Size .. Sixteenths'Last * Unit_Size
      and then Wide (P.Y) in
        Sixteenths'First * Unit_Size .. Sixteenths'Last * Unit_Size);

   function To_Grid (P : Vision.Point) return Grid_Point
   with
     Pre  => Is_In_Image (P),
     Post => 2 * abs (To_Grid'Result.X * Unit_Size - Wide (P.X)) <= Unit_Size
       and then
         2 * abs (To_Grid'Result.Y * Unit_Size - Wide (P.Y)) <= Unit_Size;
   --  Wrong by at most a thirty-second of a pixel

   type Map is private;

   function Corner_Of (M : Map; C : Vision.Corner) return Grid_Point;

   function Is_Usable (M : Map) return Boolean;
   --  The corners form a convex quadrilateral, not mirrored, with sides of at
   --  least Min_Side, and the rounding of the corners moves no place in the
   --  arena by more than 0.6 mm

   Min_Side : constant := 100 * 16;

   --  With the corners A (top left), B, C, D clockwise, and with tA, tB, tC,
   --  tD for twice the area of the triangle of a corner and its neighbours,
   --  and DAP for twice that of D, A and P, positive for P inside:
   --
   --     x = Width  * tB tC DAP / w        w = tB tC DAP + tA tD BCP
   --     y = Height * tA tB CDP / w          = tA tB CDP + tC tD ABP
   --
   --  x is 0 on the left side, DA, where DAP is, and Width on the right one;
   --  y likewise. Both forms of w are linear, and equal because they are at
   --  the corners. So it is a projective map, and there is only one.

   function X_Part (M : Map; P : Vision.Point) return Numerator
   with Pre => Is_In_Image (P);
   --  tB tC DAP
   function Y_Part (M : Map; P : Vision.Point) return Numerator
   with Pre => Is_In_Image (P);
   --  tA tB CDP
   function Whole (M : Map; P : Vision.Point) return Denominator
   with Pre => Is_In_Image (P);
   --  w

   function Width (M : Map) return Micrometres
   with Post => Width'Result in 300_000 .. Largest_Side;
   function Height (M : Map) return Micrometres
   with Post => Height'Result in 300_000 .. Largest_Side;

   function Is_Near (M : Map; Where : Place) return Boolean is
     (Where.X in -Width (M) .. 2 * Width (M)
      and then Where.Y in -Height (M) .. 2 * Height (M));

   subtype Quotient is Micrometres range -Largest_Side .. 2 * Largest_Side;

   function Rest
     (Q : Quotient; Side : Micrometres; N : Numerator; D : Divisor)
      return Wide
   is (Wide (Side / 10_000) * N - Wide (Q / 10_000) * D)
   with Pre => Side in 0 .. Largest_Side;
   --  What whole centimetres leave

   function Is_Quotient
     (Q : Quotient; Side : Micrometres; N : Numerator; D : Divisor)
      return Boolean
   is (abs Rest (Q, Side, N, D) < D
       and then
         abs (10_000 * Rest (Q, Side, N, D) - Wide (Q rem 10_000) * D) < D)
   with Pre => Side in 0 .. Largest_Side;
   --  With Side in whole centimetres: abs (Side * N - Q * D) < D, in two steps
   --  for 128 bits. So Q is less than a micrometre from Side * N / D

   procedure Make
     (Corners : Vision.Arena_Corners;
      Size    : Arena_Size;
      M       : out Map;
      Usable  : out Boolean)
   with
     Post => Usable = Is_Usable (M)
       and then
         (if Usable then
            (for all C in Vision.Corner =>
               Is_In_Image (Corners (C))
               and then Corner_Of (M, C) = To_Grid (Corners (C))))
       and then Width (M) = Micrometres (Size.Width) * 10_000
       and then Height (M) = Micrometres (Size.Height) * 10_000;

   function Is_Place (M : Map; P : Vision.Point; Where : Place) return Boolean
   is (Is_In_Image (P)
       and then Whole (M, P) in Divisor
       and then Is_Near (M, Where)
       and then Is_Quotient (Where.X, Width (M), X_Part (M, P), Whole (M, P))
       and then
         Is_Quotient (Where.Y, Height (M), Y_Part (M, P), Whole (M, P)))
   with Pre => Is_Usable (M);
   --  The place of P, less than a micrometre of each coordinate lost

   procedure Locate
     (M     : Map;
      P     : Vision.Point;
      Where : out Place;
      Known : out Boolean)
   with
     Pre  => Is_Usable (M),
     Post => (if Known then Is_Place (M, P, Where));
   --  Known: in the arena or around it, at most its own size away. Proved:
   --  nothing overflows, and less than a micrometre is lost. What the corners
   --  lost by their rounding is derived in the body (Loss_Limit), and tested
   --  against a map in floating point

   procedure Locate
     (M     : Map;
      R     : Vision.Robot;
      Where : out Pose;
      Known : out Boolean)
   with
     Pre  => Is_Usable (M),
     Post => (if Known then Is_Near (M, Where.At_Place));
   --  Its centre; it heads for the point in its direction

   procedure Targets
     (P      : Path;
      M      : Map;
      Size   : Arena_Size;
      Places : out Place_Array;
      Inside : out Boolean)
   with
     Pre  => P.Measure = Centimetres or else Is_Usable (M),
     Post =>
       (if Inside then
          (for all K in 1 .. P.Count =>
             Driving.Is_Target (Places (K), Size)));
   --  Not Inside: a point is outside the arena less its margin. Centimetres
   --  need no map

private

   type Grid_Corners is array (Vision.Corner) of Grid_Point;

   type Map is record
      Corners                   : Grid_Corners;
      Left, Right, Below, Above : Weight  := 0;
      --  tB tC, tA tD, tA tB, tC tD
      Size                      : Arena_Size;
      Usable                    : Boolean := False;
   end record;

   function Corner_Of (M : Map; C : Vision.Corner) return Grid_Point is
     (M.Corners (C));

   function Is_Usable (M : Map) return Boolean is (M.Usable);

   function Width (M : Map) return Micrometres is
     (Micrometres (M.Size.Width) * 10_000);

   function Height (M : Map) return Micrometres is
     (Micrometres (M.Size.Height) * 10_000);

   subtype Twice_Area is Wide range -2 ** 33 .. 2 ** 33;
   subtype Fine_Area is Wide range -2 ** 49 .. 2 ** 49;
   --  Sixteenths by millionths

   subtype Product is Wide range -2 ** 32 .. 2 ** 32;

   function Times (A, B : Wide) return Product is (A * B)
   with Pre => A in -2 ** 16 .. 2 ** 16 and then B in -2 ** 16 .. 2 ** 16;

   subtype Fine_Product is Wide range -2 ** 48 .. 2 ** 48;

   function Times_Fine (A, B : Wide) return Fine_Product is (A * B)
   with Pre => A in -2 ** 16 .. 2 ** 16 and then B in -2 ** 32 .. 2 ** 32;

   function Twice (P, Q, R : Grid_Point) return Twice_Area is
     (Times (Q.X - P.X, R.Y - P.Y) - Times (Q.Y - P.Y, R.X - P.X));
   --  The area of the triangle, positive if it is clockwise in the image

   function Twice (P, Q : Grid_Point; R : Vision.Point)
     return Fine_Area
   is (Times_Fine (Q.X - P.X, Wide (R.Y) - P.Y * Unit_Size)
       - Times_Fine (Q.Y - P.Y, Wide (R.X) - P.X * Unit_Size))
   with Pre => Is_In_Image (R);

   function Weighted (By : Weight; Area : Fine_Area) return Numerator is
     (By * Area);

   function X_Part (M : Map; P : Vision.Point) return Numerator is
     (Weighted
        (M.Left,
         Twice (M.Corners (Vision.Bottom_Left),
                M.Corners (Vision.Top_Left), P)));

   function Y_Part (M : Map; P : Vision.Point) return Numerator is
     (Weighted
        (M.Below,
         Twice (M.Corners (Vision.Bottom_Right),
                M.Corners (Vision.Bottom_Left), P)));

   function Whole (M : Map; P : Vision.Point) return Denominator is
     (X_Part (M, P)
      + Weighted
          (M.Right,
           Twice (M.Corners (Vision.Top_Right),
                  M.Corners (Vision.Bottom_Right), P)));

end Missions.Arenas;
