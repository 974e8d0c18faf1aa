--  SPDX-License-Identifier: GPL-3.0-or-later
--  Places in the arena, against a projective map in floating point.

with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Numerics.Generic_Real_Arrays;
with Ada.Numerics.Long_Long_Elementary_Functions;

with Missions.Angles;
with Missions.Arenas;           use Missions.Arenas;
with Missions.Driving;
with Vision; use Vision;
with Unit_Runs; use Unit_Runs;

procedure Mission_Arenas_Tests is

   use Missions;
   use Ada.Numerics.Long_Long_Elementary_Functions;

   subtype Real is Long_Long_Float;

   --  The reference: x = (h1 X + h2 Y + h3) / (h7 X + h8 Y + 1) and y
   --  likewise, the eight numbers from as many linear equations

   package Arrays is new Ada.Numerics.Generic_Real_Arrays (Real);
   use Arrays;

   subtype Vector is Real_Vector (1 .. 8);

   function X_Of (H : Vector; P : Vision.Point) return Real is
     ((H (1) * Real (P.X) + H (2) * Real (P.Y) + H (3))
      / (H (7) * Real (P.X) + H (8) * Real (P.Y) + 1.0));

   function Y_Of (H : Vector; P : Vision.Point) return Real is
     ((H (4) * Real (P.X) + H (5) * Real (P.Y) + H (6))
      / (H (7) * Real (P.X) + H (8) * Real (P.Y) + 1.0));

   function Pixels (X, Y : Real) return Vision.Point is
     ((Micro_Pixels (X * 1.0E6), Micro_Pixels (Y * 1.0E6)));

   function On_Grid (P : Vision.Point) return Vision.Point is
     ((Micro_Pixels (To_Grid (P).X * Unit_Size),
       Micro_Pixels (To_Grid (P).Y * Unit_Size)));

   function On_Grid (Corners : Arena_Corners) return Arena_Corners is
     (On_Grid (Corners (Top_Left)), On_Grid (Corners (Top_Right)),
      On_Grid (Corners (Bottom_Right)), On_Grid (Corners (Bottom_Left)));
   --  As the map has them

   function Rectangle (Left, Top, Right, Bottom : Real)
     return Arena_Corners
   is (Pixels (Left, Top), Pixels (Right, Top), Pixels (Right, Bottom),
       Pixels (Left, Bottom));
   --  As all arenas: clockwise from the upper left corner

   Usual : constant Arena_Corners :=
     (Top_Left     => Pixels (71.3, 40.9),
      Top_Right    => Pixels (561.7, 33.2),
      Bottom_Right => Pixels (611.1, 452.6),
      Bottom_Left  => Pixels (20.4, 441.0));
   --  Of an image of 640 x 480 pixels

   function Map_Of
     (Corners : Arena_Corners := Usual; Size : Arena_Size := (80, 60))
      return Map
   is
      M      : Map;
      Usable : Boolean;
   begin
      Make (Corners, Size, M, Usable);
      Assert (Usable, "usable");
      return M;
   end Map_Of;

   procedure Check_Corners (Corners : Arena_Corners; Size : Arena_Size) is
      --  As rounded, they are those of the rectangle, exactly
      M     : constant Map := Map_Of (Corners, Size);
      Known : Boolean;
      Where : Place;
   begin
      for C in Corner loop
         Locate (M, On_Grid (Corners (C)), Where, Known);
         Assert (Known, C'Image & " is known");
         Assert
           (Where =
              (X => (if C in Top_Left | Bottom_Left then 0 else Width (M)),
               Y => (if C in Bottom_Left | Bottom_Right then 0
                     else Height (M))),
            C'Image & Where.X'Image & Where.Y'Image);
      end loop;
   end Check_Corners;

   function Fitted
     (Corners : Arena_Corners; Size : Arena_Size) return Vector
   is
      --  From millionths of a pixel; in micrometres
      E      : Real_Matrix (1 .. 8, 1 .. 8) := (others => (others => 0.0));
      Values : Vector;
      Row    : Positive := 1;
   begin
      for C in Corner loop
         declare
            Px : constant Real := Real (Corners (C).X);
            Py : constant Real := Real (Corners (C).Y);
            X  : constant Real :=
              (if C in Top_Left | Bottom_Left then 0.0
               else Real (Size.Width) * 1.0E4);
            Y  : constant Real :=
              (if C in Bottom_Left | Bottom_Right then 0.0
               else Real (Size.Height) * 1.0E4);
            procedure Fill (First : Positive; Value : Real) is
            begin
               E (Row, First) := Px;
               E (Row, First + 1) := Py;
               E (Row, First + 2) := 1.0;
               E (Row, 7) := -Px * Value;
               E (Row, 8) := -Py * Value;
               Values (Row) := Value;
               Row := Row + 1;
            end Fill;
         begin
            Fill (1, X);
            Fill (4, Y);
         end;
      end loop;
      return Solve (E, Values);
   end Fitted;

   procedure Expect
     (Usable  : Boolean;
      What    : String;
      Corners : Arena_Corners;
      Size    : Arena_Size := (80, 60))
   is
      M     : Map;
      Found : Boolean;
   begin
      Make (Corners, Size, M, Found);
      Assert (Found = Usable, What & ": " & Found'Image);
   end Expect;

   function Seen
     (Corners : Arena_Corners; Size : Arena_Size; X, Y : Real)
      return Vision.Point
   is
      --  Where a place (micrometres) is in the image
      H : constant Vector := Fitted (Corners, Size);

      --  x (h7 X + h8 Y + 1) = h1 X + h2 Y + h3, and y likewise

      A : constant Real := H (1) - X * H (7);
      B : constant Real := H (2) - X * H (8);
      C : constant Real := H (4) - Y * H (7);
      D : constant Real := H (5) - Y * H (8);
      E : constant Real := X - H (3);
      F : constant Real := Y - H (6);
      W : constant Real := A * D - B * C;
   begin
      return
        (Micro_Pixels ((E * D - B * F) / W),
         Micro_Pixels ((A * F - E * C) / W));
   end Seen;

   procedure Test_Corners is
   begin
      Check_Corners (Usual, (80, 60));
      Check_Corners (Rectangle (0.0, 0.0, 4_095.0, 4_095.0), (1_000, 1_000));
      Check_Corners (Rectangle (-0.5, -0.5, 4_095.4, 4_095.4), (1_000, 30));
   end Test_Corners;

   --  X_Part and Y_Part of an arena turned by half are what is left of the
   --  divisor

   procedure Test_Forms is
      M      : constant Map := Map_Of;
      Turned : constant Map :=
        Map_Of ((Usual (Bottom_Right), Usual (Bottom_Left),
                 Usual (Top_Left), Usual (Top_Right)));
   begin
      for X in Wide range 0 .. 64 loop
         for Y in Wide range 0 .. 48 loop
            declare
               P : constant Vision.Point :=
                 (Micro_Pixels (X) * 9_999_999, Micro_Pixels (Y) * 9_999_999);
            begin
               Assert (Whole (M, P) = Y_Part (M, P) + Y_Part (Turned, P),
                       "by y");
               Assert (Whole (M, P) = X_Part (M, P) + X_Part (Turned, P),
                       "by x");
            end;
         end loop;
      end loop;
   end Test_Forms;

   procedure Test_Loss is
      Arenas : constant := 3_000;

      Chance   : Generator;
      Tried    : Natural := 0;
      Used     : Natural := 0;
      Greatest : Real    := 0.0;
      Inexact  : Real    := 0.0;

      function Between (Low, High : Real) return Real is
        (Low + (High - Low) * Real (Random (Chance)));
   begin
      Reset (Chance, 19);
      while Used < Arenas loop
         Tried := Tried + 1;
         declare
            --  From tiny and distorted ones, of which most are refused, to
            --  those that fill large images

            Scale   : constant Real := 2.0 ** Integer (Between (-1.4, 3.4));
            Spread  : constant Real := Scale * Between (0.0, 200.0);
            Corners : constant Arena_Corners :=
              (Top_Left     => Pixels (Between (0.0, Spread),
                                       Between (0.0, Spread)),
               Top_Right    => Pixels (Scale * 500.0 - Between (0.0, Spread),
                                       Between (0.0, Spread)),
               Bottom_Right => Pixels (Scale * 500.0 - Between (0.0, Spread),
                                       Scale * 400.0 - Between (0.0, Spread)),
               Bottom_Left  => Pixels (Between (0.0, Spread),
                                       Scale * 400.0 - Between (0.0, Spread)));
            Size    : constant Arena_Size :=
              (Integer (Between (30.0, 60.0 + 60.0 * Scale)),
               Integer (Between (30.0, 60.0 + 60.0 * Scale)));
            H       : constant Vector := Fitted (Corners, Size);
            Exact   : Vector;
            --  Of the corners as rounded

            M             : Map;
            Usable, Known : Boolean;
            Where         : Place;
            P             : Vision.Point;
            X, Y, Loss    : Real;
         begin
            Make (Corners, Size, M, Usable);
            if Usable then
               Used := Used + 1;
               Exact := Fitted (On_Grid (Corners), Size);
               for Point in 1 .. 20 loop
                  P := Seen (Corners, Size,
                             Between (0.0, Real (Width (M))),
                             Between (0.0, Real (Height (M))));
                  X := X_Of (H, P);
                  Y := Y_Of (H, P);
                  Locate (M, P, Where, Known);
                  Assert (Known, "known");
                  Loss := Sqrt ((X - Real (Where.X)) ** 2
                                + (Y - Real (Where.Y)) ** 2);
                  Greatest := Real'Max (Greatest, Loss);
                  Inexact := Real'Max
                    (Inexact,
                     Real'Max (abs (X_Of (Exact, P) - Real (Where.X)),
                               abs (Y_Of (Exact, P) - Real (Where.Y))));
               end loop;
            end if;
         end;
      end loop;
      Assert (Greatest < 600.0, "less than 0.6 mm, not" & Greatest'Image);
      Assert (Inexact < 1.01, "less than 1 micrometre by rounding places, not"
              & Inexact'Image);
      Assert (Greatest > 100.0, "arenas near the limit are among them, not"
              & Greatest'Image);
      Assert (Tried > Arenas + Arenas / 10, "and some were refused");
   end Test_Loss;

   procedure Test_Outside is
      M     : Map := Map_Of (Rectangle (200.0, 150.0, 440.0, 330.0));
      Where : Place;

      procedure Expect (X, Y : Real; Known : Boolean; What : String) is
         Found : Boolean;
      begin
         Locate (M, Pixels (X, Y), Where, Found);
         Assert (Found = Known, What & X'Image & Y'Image);
      end Expect;

   begin
      Expect (197.0, 336.0, True, "left and below");
      Assert (Where = (-10_000, -20_000), "left and below");
      Expect (455.0, 144.0, True, "right and above");
      Assert (Where = (850_000, 620_000), "right and above");
      Expect (-0.5, 200.0, True, "less than its width away");
      Expect (690.0, 200.0, False, "more than its width away");
      for Far of Vector'(-0.51, 4_095.5, -1.0, 4_096.0, 1.0E6, -1.0E6,
                         1.0E7, -1.0E7)
      loop
         Expect (Far, 200.0, False, "far in x");
         Expect (200.0, Far, False, "far in y");
      end loop;

      --  Beyond the horizon of a steep view

      M := Map_Of ((Top_Left     => Pixels (600.0, 600.0),
                    Top_Right    => Pixels (1_000.0, 600.0),
                    Bottom_Right => Pixels (1_280.0, 940.0),
                    Bottom_Left  => Pixels (320.0, 940.0)));
      for Y in 0 .. 400 loop
         Expect (800.0, Real (Y), False, "beyond the horizon, and near it");
      end loop;
      Expect (800.0, 599.0, True, "just outside");
      Assert (Where.X = 400_000 and then Where.Y in 600_001 .. 620_000,
              "just outside");
   end Test_Outside;

   procedure Test_Poses is
      Size   : constant Arena_Size := (80, 60);
      M      : constant Map := Map_Of;
      Far    : constant Vision.Point := Pixels (5_000.0, 0.0);
      Known  : Boolean;
      Where  : Pose;
      R      : Vision.Robot;

      procedure Refuse (Centre, Direction : Vision.Point; What : String) is
      begin
         Locate (M, (0, Centre, Direction, 0), Where, Known);
         Assert (not Known, What);
      end Refuse;

   begin
      for Degree in -179 .. 180 loop
         for At_X in 1 .. 7 loop
            --  The points are 17 pixels apart

            declare
               X     : constant Real := Real (At_X) * 100_000.0;
               Y     : constant Real := 50_000.0 + X * 0.7;
               Angle : constant Real := Real (Degree) + 0.37 * Real (At_X);
            begin
               R.Centre := Seen (Usual, Size, X, Y);
               R.Direction :=
                 Seen (Usual, Size,
                       X + 30_000.0 * Cos (Angle, 360.0),
                       Y + 30_000.0 * Sin (Angle, 360.0));
               Locate (M, R, Where, Known);
               Assert (Known, "known");
               Assert (abs (Real (Where.At_Place.X) - X) < 1_000.0
                       and then abs (Real (Where.At_Place.Y) - Y) < 1_000.0,
                       "its centre");
               Assert (abs Angles.Normal
                         (Where.Heading
                          - Microdegrees (Angle * 1.0E6)) < 30_000,
                       "the heading" & Degree'Image & " is"
                       & Where.Heading'Image);
            end;
         end loop;
      end loop;

      Refuse (R.Centre, R.Centre, "no direction");
      Refuse (R.Centre, Far, "a direction far outside");
      Refuse (Far, R.Centre, "a centre far outside");
   end Test_Poses;

   procedure Test_Refused is

      function Square (Right, Below : Real) return Arena_Corners is
        (Rectangle (10.0, 10.0, Right, Below));

      function Mixed (A, B, C, D : Corner) return Arena_Corners is
        (Usual (A), Usual (B), Usual (C), Usual (D));

      Changed : Arena_Corners;
   begin
      Expect (True, "the usual one", Usual);
      Expect (False, "none", No_Arena);
      Expect (False, "mirrored",
              Mixed (Top_Right, Top_Left, Bottom_Left, Bottom_Right));
      Expect (False, "crossed",
              Mixed (Top_Left, Bottom_Right, Top_Right, Bottom_Left));
      for C in Corner loop
         Changed := Rectangle (0.0, 0.0, 600.0, 450.0);
         Changed (C) := Pixels (300.0, 225.0);
         Expect (False, "on the diagonal", Changed);
         Changed := Usual;
         Changed (C) := Changed (Corner'Val ((Corner'Pos (C) + 1) mod 4));
         Expect (False, "two corners are one", Changed);
         Changed (C) := Pixels (300.0, -0.6);
         Expect (False, "outside the image, up", Changed);
         Changed (C) := Pixels (9.9E6, 300.0);
         Expect (False, "outside the image, far", Changed);
      end loop;

      --  Sides of 100 pixels, if they are not too coarse for 1 mm

      Expect (True, "100 pixels of 60 cm", Square (110.0, 110.0), (60, 60));
      Expect (False, "less, x", Square (109.9, 110.0), (30, 60));
      Expect (False, "less, y", Square (110.0, 109.9), (60, 30));
      Expect (False, "100 pixels of 80 cm", Square (110.0, 110.0), (80, 60));
      Expect (False, "8 m in a small image", Usual, (800, 600));
      Expect (True, "8 m in a large image",
              Rectangle (0.0, 0.0, 3_000.0, 2_250.0), (800, 600));
   end Test_Refused;

   procedure Test_Targets is
      Size   : constant Arena_Size := (80, 60);
      M      : Map;
      Places : Place_Array;
      P      : Path;
      Inside : Boolean;

      procedure Check (X, Y : Millionths; Expected : Boolean; What : String) is
         --  As the second of two points
      begin
         P.Points (2) := (X, Y);
         Targets (P, M, Size, Places, Inside);
         Assert (Inside = Expected, What);
      end Check;
   begin
      --  No map yet: only centimetres

      P.Measure := Centimetres;
      P.Count := 2;
      P.Points (1) := (8_000_000, 8_000_000);
      Check (72_000_000, 52_000_000, True, "the corners less the margin");
      Assert (Places (1) = (80_000, 80_000)
              and then Places (2) = (720_000, 520_000), "where they are");
      Check (12_345_678, 23_456_749, True, "parts of a micrometre");
      Assert (Places (2) = (123_457, 234_567), "rounded");
      Check (72_000_050, 52_000_000, False, "too far right");
      Check (72_000_000, 52_000_050, False, "too far up");
      Check (7_999_949, 52_000_000, False, "too far left");
      Check (72_000_000, 7_999_949, False, "too far down");
      Check (-8_000_000, 52_000_000, False, "negative");
      Check (Millionths'Last, Millionths'First, False, "furthest");
      Check (Millionths'First, Millionths'Last, False, "furthest, the others");

      M := Map_Of;
      P.Measure := Pixels;
      P.Points (1) := (320_000_000, 240_000_000);
      Check (400_000_000, 300_000_000, True, "pixels inside");
      for K in 1 .. 2 loop
         declare
            Where : Place;
            Known : Boolean;
         begin
            Locate (M, (Micro_Pixels (P.Points (K).X),
                        Micro_Pixels (P.Points (K).Y)), Where, Known);
            Assert (Known and then Places (K) = Where
                    and then Driving.Is_Target (Where, Size), "where it is");
         end;
      end loop;
      Check (71_300_000, 40_900_000, False, "at the border");
      Check (0, 0, False, "outside the arena");
      Check (Millionths'Last, Millionths'First, False, "outside the image");
      P.Points (1) := (71_300_000, 40_900_000);
      Check (400_000_000, 300_000_000, False, "the first is outside");
      P.Points (1) := (320_000_000, 240_000_000);
      P.Count := 1;
      Check (0, 0, True, "the second is not counted");

      P.Count := 64;
      P.Points := (others => (320_000_000, 240_000_000));
      Targets (P, M, Size, Places, Inside);
      Assert (Inside and then (for all W of Places => W = Places (1)),
              "64 points");
      P.Points (64) := (0, 0);
      Targets (P, M, Size, Places, Inside);
      Assert (not Inside, "the last of 64");
   end Test_Targets;

begin
   Run_Test ("the corners, exactly", Test_Corners'Access);
   Run_Test ("both forms of the divisor", Test_Forms'Access);
   Run_Test ("less than 0.6 mm from a map in floating point",
             Test_Loss'Access);
   Run_Test ("points outside the arena", Test_Outside'Access);
   Run_Test ("headings", Test_Poses'Access);
   Run_Test ("arenas that are refused", Test_Refused'Access);
   Run_Test ("the points of a path", Test_Targets'Access);
end Mission_Arenas_Tests;
