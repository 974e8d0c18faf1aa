--  SPDX-License-Identifier: GPL-3.0-or-later

with Missions.Angles;

package body Missions.Arenas with SPARK_Mode is

   use Vision;

   --  What the rounding of the corners costs. The map is x = Width * u,
   --  y = Height * v. The gradient of u is
   --
   --     (1 - u) * tB tC grad DAP / w - u * tA tD grad BCP / w
   --
   --  In the arena 0 <= u <= 1, and w is not less than Least, its lowest value
   --  at a corner. So a shift of half a sixteenth in both coordinates changes
   --  u by at most
   --
   --     p = max (tB tC |DA|, tA tD |BC|) / Least / 2
   --
   --  with |DA| for the sum of both differences of coordinates, and v by at
   --  most q, likewise. Such shifts of the corners change u, to the first
   --  order, by what is at most p at the corners and bilinear between them,
   --  and by g * u (1 - u), where g is the sum of the changes of v at the
   --  corners, with alternating signs: at most 4 q. In all p + q, and so it is
   --  for v. A place moves by no more than Longest * (p + q) * 1.42: 0.57 mm.
   --  The second order is smaller by the ratio of a thirty-second of a pixel
   --  to a side.

   Loss_Limit : constant := 800;
   --  Micrometres: of 2 * Longest * (p + q)

   function Rounded (Value : Micro_Pixels) return Wide is
     ((if Value >= 0 then Wide (Value) + Unit_Size / 2
       else Wide (Value) - Unit_Size / 2) / Unit_Size);
   --  In sixteenths

   function Rounded (Value : Millionths) return Wide is
     ((if Value >= 0 then Wide (Value) + 50 else Wide (Value) - 50) / 100);
   --  Millionths of a centimetre, in micrometres

   subtype Length is Wide range 0 .. 2 ** 33;

   function Way (P, Q : Grid_Point) return Length is
     (Unit_Size * (abs (P.X - Q.X) + abs (P.Y - Q.Y)));
   --  In millionths

   function Is_Long (P, Q : Grid_Point) return Boolean is
     (Times (P.X - Q.X, P.X - Q.X) + Times (P.Y - Q.Y, P.Y - Q.Y)
      >= Min_Side * Min_Side);

   subtype Steepness is Wide range 0 .. 2 ** 97;

   function Steep (By : Weight; Side : Length) return Steepness is
     (By * Side);

   function Steeper (P, Q : Steepness) return Steepness is
     (if P < Q then Q else P);

   subtype Scaled_Steepness is Wide range 0 .. 2 ** 121;

   function Scaled (Side : Micrometres; By : Steepness)
     return Scaled_Steepness is (Wide (Side) * By)
   with Pre => Side in 300_000 .. Largest_Side;

   subtype Corner_Area is Twice_Area range 1 .. 2 ** 32;
   --  Of a triangle in the image, clockwise: not more than the image

   function Product_Of (A, B : Corner_Area) return Weight is (A * B);

   function To_Point (P : Grid_Point) return Vision.Point is
     ((Micro_Pixels (P.X * Unit_Size), Micro_Pixels (P.Y * Unit_Size)))
   with Post => Is_In_Image (To_Point'Result);

   function Divided (N : Wide; D : Divisor) return Wide
   with
     Post => (if N >= 0 then Divided'Result in 0 .. N
                and then N - Divided'Result * D in 0 .. D - 1
              else Divided'Result in N .. 0
                and then N - Divided'Result * D in -D + 1 .. 0)
   is
      Q : constant Wide := N / D;
      R : constant Wide := N rem D;
   begin
      pragma Assert (N = Q * D + R);
      return Q;
   end Divided;

   procedure Find
     (Side : Micrometres; N : Numerator; D : Divisor;
      Q : out Micrometres; Near : out Boolean)
   with
     Pre  => Side in 300_000 .. Largest_Side and then Side rem 10_000 = 0,
     Post => (if Near then
                Q in -Side .. 2 * Side
                and then Is_Quotient (Q, Side, N, D))
   is
      --  Side * N / D
      Product     : constant Wide := Wide (Side / 10_000) * N;
      Centimetres : constant Wide := Divided (Product, D);
      Part        : constant Wide :=
        Divided (10_000 * (Product - Centimetres * D), D);
   begin
      pragma Assert (Part in -9_999 .. 9_999);
      Q := 0;
      Near := Centimetres in -2_000 .. 2_000
        and then 10_000 * Centimetres + Part in
          Wide (-Side) .. Wide (2 * Side);
      if Near then
         Q := Micrometres (10_000 * Centimetres + Part);
         pragma Assert (Wide (Q / 10_000) = Centimetres);
         pragma Assert (Wide (Q rem 10_000) = Part);
      end if;
   end Find;

   function Is_Fine (M : Map) return Boolean is
      --  Its sides are long enough, for the rounding of the corners too
      A : Grid_Point renames M.Corners (Top_Left);
      B : Grid_Point renames M.Corners (Top_Right);
      C : Grid_Point renames M.Corners (Bottom_Right);
      D : Grid_Point renames M.Corners (Bottom_Left);

      Longest : constant Micrometres :=
        Micrometres'Max (Width (M), Height (M));
      Least   : constant Denominator :=
        Wide'Min (Wide'Min (Whole (M, To_Point (A)), Whole (M, To_Point (B))),
                  Wide'Min (Whole (M, To_Point (C)), Whole (M, To_Point (D))));
      P       : constant Steepness := Steeper
        (Steep (M.Left, Way (D, A)), Steep (M.Right, Way (B, C)));
      Q       : constant Steepness := Steeper
        (Steep (M.Below, Way (C, D)), Steep (M.Above, Way (A, B)));
   begin
      return Is_Long (A, B) and then Is_Long (B, C)
        and then Is_Long (C, D) and then Is_Long (D, A)
        and then Scaled (Longest, P) + Scaled (Longest, Q)
          <= Loss_Limit * Least;
   end Is_Fine;

   procedure Locate
     (M     : Map;
      P     : Vision.Point;
      Where : out Place;
      Known : out Boolean)
   is
      W    : Denominator;
      X, Y : Micrometres;
   begin
      Where := (0, 0);
      Known := False;
      if Is_In_Image (P) then
         W := Whole (M, P);
         if W in Divisor then
            Find (Width (M), X_Part (M, P), W, X, Known);
            if Known then
               Find (Height (M), Y_Part (M, P), W, Y, Known);
               if Known then
                  Where := (X, Y);
               end if;
            end if;
         end if;
      end if;
   end Locate;

   procedure Locate
     (M     : Map;
      R     : Vision.Robot;
      Where : out Pose;
      Known : out Boolean)
   is
      Ahead : Place;
   begin
      Where := (others => <>);
      Locate (M, R.Centre, Where.At_Place, Known);
      if Known then
         Locate (M, R.Direction, Ahead, Known);
         Known := Known and then Ahead /= Where.At_Place;
         if Known then
            Where.Heading :=
              Angles.Direction
                (Ahead.X - Where.At_Place.X, Ahead.Y - Where.At_Place.Y);
         end if;
      end if;
   end Locate;

   procedure Make
     (Corners : Vision.Arena_Corners;
      Size    : Arena_Size;
      M       : out Map;
      Usable  : out Boolean)
   is
      A, B, C, D         : Grid_Point;
      T_A, T_B, T_C, T_D : Twice_Area;
   begin
      M := (Size => Size, others => <>);
      if (for all P of Corners => Is_In_Image (P)) then
         A := To_Grid (Corners (Top_Left));
         B := To_Grid (Corners (Top_Right));
         C := To_Grid (Corners (Bottom_Right));
         D := To_Grid (Corners (Bottom_Left));
         T_A := Twice (D, A, B);
         T_B := Twice (A, B, C);
         T_C := Twice (B, C, D);
         T_D := Twice (C, D, A);
         if T_A in Corner_Area and then T_B in Corner_Area
           and then T_C in Corner_Area and then T_D in Corner_Area
         then
            M.Corners := (A, B, C, D);
            M.Left := Product_Of (T_B, T_C);
            M.Right := Product_Of (T_A, T_D);
            M.Below := Product_Of (T_A, T_B);
            M.Above := Product_Of (T_C, T_D);
            M.Usable := Is_Fine (M);
         end if;
      end if;
      Usable := M.Usable;
   end Make;

   procedure Targets
     (P      : Path;
      M      : Map;
      Size   : Arena_Size;
      Places : out Place_Array;
      Inside : out Boolean)
   is
      X, Y : Wide;
   begin
      Places := (others => <>);
      Inside := True;
      for K in 1 .. P.Count loop
         pragma Loop_Invariant
           (for all L in 1 .. K - 1 => Driving.Is_Target (Places (L), Size));
         if P.Measure = Pixels then
            Locate
              (M,
               (Vision.Micro_Pixels (P.Points (K).X),
                Vision.Micro_Pixels (P.Points (K).Y)),
               Places (K), Inside);
         else
            X := Rounded (P.Points (K).X);
            Y := Rounded (P.Points (K).Y);
            Inside := X in 0 .. Largest_Side and then Y in 0 .. Largest_Side;
            if Inside then
               Places (K) := (Micrometres (X), Micrometres (Y));
            end if;
         end if;
         Inside := Inside and then Driving.Is_Target (Places (K), Size);
         exit when not Inside;
      end loop;
   end Targets;

   function To_Grid (P : Vision.Point) return Grid_Point is
     (X => Rounded (P.X), Y => Rounded (P.Y));

end Missions.Arenas;
