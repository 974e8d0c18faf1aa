--  SPDX-License-Identifier: GPL-3.0-or-later
--  The search for robots: accuracy at every heading, number, limits. Faint,
--  glaring, blotted and narrowly framed markers: rows of tests/vision.

with Ada.Numerics.Long_Elementary_Functions;

with Interfaces.C; use Interfaces.C;

with Pictures;
with Scenes;
with Vision_C; use Vision_C;
with Unit_Runs; use Unit_Runs;

procedure Vision_Robot_Tests is

   use Ada.Numerics.Long_Elementary_Functions;

   Position_Tolerance : constant := 2.0;  --  pixels
   Angle_Tolerance    : constant := 1.0;  --  degrees

   Found : Robot_Array (0 .. 7);
   Count : aliased int;

   --  A marker whose image is changed where it lies

   type Place is record
      Scene          : Scenes.Description;
      Cx, Cy, Dx, Dy : Long_Float;  --  the truth
   end record;

   function Along (P : Place; X, Y : Long_Float) return Long_Float is
     (((X - P.Cx) * (P.Dx - P.Cx) + (Y - P.Cy) * (P.Dy - P.Cy))
      / ((P.Dx - P.Cx) ** 2 + (P.Dy - P.Cy) ** 2) * 3.0);
   function Across (P : Place; X, Y : Long_Float) return Long_Float is
     (((Y - P.Cy) * (P.Dx - P.Cx) - (X - P.Cx) * (P.Dy - P.Cy))
      / ((P.Dx - P.Cx) ** 2 + (P.Dy - P.Cy) ** 2) * 3.0);
   --  Where (X, Y) lies in the marker: modules from its centre

   function Find
     (Kind : Marker; Field : access constant Arena := null) return Status
   is (Find_Robots (0, Kind, Field, Found'Address, Found'Length,
                    Count'Access));
   --  In slot 0, into Found

   procedure Search
     (Scene : Scenes.Description; Kind : Marker; What : String)
   is
      --  Draws Scene into slot 0; there are robots, which go to Found
   begin
      Pictures.Show (Scene);
      Assert (Find (Kind) = Ok, What & ": found");
   end Search;

   function Away (P, Q : Point) return Long_Float is
     (Sqrt (Long_Float ((P.X - Q.X) ** 2 + (P.Y - Q.Y) ** 2)));

   procedure Check (Scene : Scenes.Description; N : int; What : String) is
      --  One of Found is robot N of Scene, with the accuracy asked for
      Cx, Cy, Dx, Dy : double;
      Distance       : Long_Float := Long_Float'Last;
      Nearest        : int := 0;
      Error          : Long_Float;

   begin
      Assert (Scenes.Robot_Truth (Scene, N, Cx, Cy, Dx, Dy) = 0, "truth");
      for K in 0 .. Count - 1 loop
         if Away (Found (K).Centre, (Cx, Cy)) < Distance then
            Distance := Away (Found (K).Centre, (Cx, Cy));
            Nearest := K;
         end if;
      end loop;
      Assert (Distance < Position_Tolerance,
              What & ": centre off by" & Distance'Image);
      Assert (Away (Found (Nearest).Direction, (Dx, Dy)) < Position_Tolerance,
              What & ": direction");
      Error := Long_Float (Found (Nearest).Angle)
        - Arctan (Long_Float (Cy - Dy), Long_Float (Cx - Dx), 360.0);
      Error := abs (Error - 360.0 * Long_Float'Rounding (Error / 360.0));
      Assert (Error < Angle_Tolerance, What & ": angle off by" & Error'Image);
      Assert (Found (Nearest).Angle > -180.0
              and then Found (Nearest).Angle <= 180.0, What & ": range");
      Assert
        (Found (Nearest).Id =
         (if Scene.Robot (Integer (N)).Marker = 0
          then Scene.Robot (Integer (N)).Id else 0), What & ": identifier");
   end Check;

   procedure Check_One
     (Scene : Scenes.Description; Kind : Marker; What : String) is
      --  Draws Scene into slot 0: its only robot is found
   begin
      Search (Scene, Kind, What);
      Assert (Count = 1, What & ": one");
      Check (Scene, 0, What);
   end Check_One;

   procedure Check_Headings (Scene : Scenes.Description; What : String) is
      --  Both markers in Scene at every heading
      Here : Scenes.Description := Scene;
   begin
      Here.Robots := 1;
      for Kind in Marker loop
         for Step in 0 .. 23 loop
            --  A place of its own for each, with its own fraction of a pixel
            Here.Robot (0) :=
              (Marker'Pos (Kind), int (41 * Step),
               15.0 + 2.13 * double (Step),
               12.0 + double (Step * 7 mod 24) * 1.57,
               15.0 * double (Step));
            Here.Seed := unsigned (Step + 1);
            Check_One (Here, Kind, What & ", " & Kind'Image & " at"
                       & Integer'Image (15 * Step));
         end loop;
      end loop;
   end Check_Headings;

   procedure Test_Headings is
      use Pictures;
   begin
      Check_Headings (Scenes.Default, "plain");
      Check_Headings (Disturbed (Noise => 15.0), "noise");
      Check_Headings (Disturbed (Blur => 2.0), "blur");
      Check_Headings (Disturbed (Uneven => 0.5), "uneven light");
      Check_Headings (Disturbed (Turn => 10.0), "turned");
      Check_Headings (Disturbed (-7.0, 15.0, 2.0, 0.5), "all at once");
   end Test_Headings;

   procedure Test_Upright is
   begin
      for Kind in Marker loop
         --  An upright marker is at 90, one that looks to the left at 0
         for Quarter in 0 .. 3 loop
            Search (Pictures.Scene_With
                      (Marker'Pos (Kind), 1, 40.0, 30.0,
                       90.0 * double (Quarter)), Kind, "upright");
            Assert
              ((case Quarter is
                   when 0      => abs Found (0).Angle > 179.5,
                   when 1      => abs (Found (0).Angle - 90.0) < 0.5,
                   when 2      => abs Found (0).Angle < 0.5,
                   when others => abs (Found (0).Angle + 90.0) < 0.5),
               "quarter" & Quarter'Image & " is at" & Found (0).Angle'Image);
         end loop;
      end loop;
   end Test_Upright;

   procedure Test_Resolutions is
      Scene : Scenes.Description;
      type Pair is array (1 .. 2) of int;
      type Pairs is array (Positive range <>) of Pair;
   begin
      for P of Pairs'((320, 240), (800, 600), (1_280, 720), (1_920, 1_080))
      loop
         for Kind in Marker loop
            for Step in 0 .. 5 loop
               Scene := Pictures.Scene_With
                 (Marker'Pos (Kind), 70, 20.0 + double (Step) * 8.0, 25.0,
                  double (Step) * 65.0);
               Scene.Width := P (1);
               Scene.Height := P (2);
               Scene.Noise := 4.0;
               Check_One (Scene, Kind, P (1)'Image & " wide, " & Kind'Image);
            end loop;
         end loop;
      end loop;
   end Test_Resolutions;

   procedure Test_Several is
      Scene : Scenes.Description := Scenes.Default;
   begin
      Scene.Robots := 2;
      Scene.Noise := 4.0;
      for Kind in Marker loop
         Scene.Robot (0) := (Marker'Pos (Kind), 700, 25.0, 20.0, 33.0);
         Scene.Robot (1) := (Marker'Pos (Kind), 8, 60.0, 41.0, 258.0);
         Search (Scene, Kind, "two");
         Assert (Count = 2, "two, not" & Count'Image);
         Check (Scene, 0, "first");
         Check (Scene, 1, "second");
         Assert (Found (0).Id <= Found (1).Id, "lowest first");
      end loop;

      --  More than fit

      Scene.Robots := 4;
      Scene.Noise := 0.0;
      Scene.Robot :=
        ((0, 40, 20.0, 20.0, 33.0), (0, 30, 60.0, 20.0, 1.0),
         (0, 10, 20.0, 45.0, 90.0), (0, 20, 60.0, 45.0, 200.0));
      Pictures.Show (Scene);
      for Capacity in int range 1 .. 5 loop
         Found := (others => (-1, (0.0, 0.0), (0.0, 0.0), 0.0));
         Assert (Find_Robots (0, Aruco, null, Found'Address, Capacity,
                              Count'Access) = Ok
                 and then Count = int'Min (4, Capacity), "as many as fit");
         for K in Found'Range loop
            Assert (Found (K).Id = (if K < Count then 10 * K + 10 else -1),
                    "the lowest, and none behind");
         end loop;
      end loop;
   end Test_Several;

   procedure Test_Positions_In_Arena is
      Field  : aliased Arena;
      Scene  : Scenes.Description;
      Inside : Robot_Array (0 .. 7);
      Number : aliased int;
   begin
      for Kind in Marker loop
         for Column in 0 .. 4 loop
            for Row in 0 .. 3 loop
               --  From wall to wall
               Scene := Pictures.Scene_With
                 (Marker'Pos (Kind), 123, 20.0 * double (Column),
                  20.0 * double (Row), 23.0 * double (5 * Row + Column));
               Scene.Turn := 3.0;
               Scene.Noise := 4.0;
               Check_One (Scene, Kind, "whole image");
               Assert (Find_Arena (0, Field'Access) = Ok, "arena");
               Assert (Find_Robots (0, Kind, Field'Access, Inside'Address, 8,
                                    Number'Access) = Ok
                       and then Number = 1,
                       "in the arena, " & Kind'Image & Column'Image
                       & Row'Image);
               Assert (Away (Inside (0).Centre, Found (0).Centre) < 0.1
                       and then Away (Inside (0).Direction,
                                      Found (0).Direction) < 0.2,
                       "the same pixels");
            end loop;
         end loop;
      end loop;
   end Test_Positions_In_Arena;

   procedure Test_Outside_Arena is
      Fields : constant array (1 .. 5) of Corners :=
        (((67.0, 50.0), (320.0, 50.0), (320.0, 430.0), (67.0, 430.0)),
         (others => (0.0, 0.0)),
         (others => (320.0, 240.0)),
         ((9_000.0, 9_000.0), (9_900.0, 9_000.0), (9_900.0, 9_900.0),
          (9_000.0, 9_900.0)),
         ((-900.0, -900.0), (-100.0, -900.0), (-100.0, -100.0),
          (-900.0, -100.0)));
      --  The left half, and those that have no inside there
      Scene : Scenes.Description := Scenes.Default;
      Field : aliased Arena;
   begin
      for Kind in Marker loop
         Scene.Robot (1) := (Marker'Pos (Kind), 6, 20.0, 30.0, 33.0);
         for K in reverse Fields'Range loop
            Scene.Robots := 2;
            Scene.Robot (0) := (Marker'Pos (Kind), 5,
                                (if K = 1 then 44.0 else 40.0), 30.0, 33.0);
            Field.Corner := Fields (K);
            Pictures.Show (Scene);
            Assert (Find (Kind, Field'Access)
                    = (if K = 1 then Ok else Not_Found)
                    and then Count = Boolean'Pos (K = 1),
                    Kind'Image & Count'Image & " inside of" & K'Image);
         end loop;
         Check (Scene, 1, "the one inside");
         Scene.Robots := 1;
         Pictures.Show (Scene);
         Assert (Find (Kind, Field'Access) = Not_Found
                 and then Count = 0, "none inside of the left half");
      end loop;
      Field.Corner := ((-9.0E5, -9.0E5), (9.0E5, -9.0E5), (9.0E5, 9.0E5),
                       (-9.0E5, 9.0E5));
      Pictures.Show (Pictures.Scene_With (0, 5, 40.0, 30.0, 10.0));
      Assert (Find (Aruco, Field'Access) = Ok, "a huge arena");
   end Test_Outside_Arena;

   procedure Test_None is
      Scene : Scenes.Description := Scenes.Default;
   begin
      for Kind in Marker loop
         for With_Arena in int range 0 .. 1 loop
            for Noise in 0 .. 6 loop
               Scene.Arena := With_Arena;
               Scene.Noise := 5.0 * double (Noise);
               Scene.Seed := unsigned (Noise);
               Pictures.Show (Scene);
               Assert (Find (Kind) = Not_Found
                       and then Count = 0,
                       Kind'Image & " in noise" & Noise'Image);
            end loop;
         end loop;

         --  Nor in a marker of the other kind
         for Step in 0 .. 11 loop
            Pictures.Show
              (Pictures.Scene_With
                 (1 - Marker'Pos (Kind), int (Step * 83), 40.0, 30.0,
                  31.0 * double (Step)));
            Assert (Find (Kind) = Not_Found,
                    "no " & Kind'Image & " at" & Step'Image);
         end loop;
      end loop;
   end Test_None;

   function Marker_At (Step : Natural) return Place is
      --  Another place, heading and identifier for each Step
      Scene          : constant Scenes.Description :=
        Pictures.Scene_With
          (0, int (83 * Step), 20.0 + 3.3 * double (Step),
           15.0 + double (7 * Step mod 12) * 2.7, 31.0 * double (Step));
      Cx, Cy, Dx, Dy : double;
   begin
      Assert (Scenes.Robot_Truth (Scene, 0, Cx, Cy, Dx, Dy) = 0, "truth");
      return (Scene, Long_Float (Cx), Long_Float (Cy), Long_Float (Dx),
              Long_Float (Dy));
   end Marker_At;

   procedure Test_Aslant is
      Scene          : Scenes.Description;
      Cx, Cy, Dx, Dy : double;

      function Seen (Ahead, Right : double) return Point is
         --  Where what lies so is seen, in lengths of the robot
         X     : constant double :=
           Cx - 959.5 + Ahead * (Dx - Cx) - Right * (Dy - Cy);
         Y     : constant double :=
           Cy - 539.5 + Ahead * (Dy - Cy) + Right * (Dx - Cx);
         Depth : constant double :=
           1.0 + Scene.Lean_X * X + Scene.Lean_Y * Y;
      begin
         return (959.5 + X / Depth, 539.5 + Y / Depth);
      end Seen;

      function Between (P, Q : Point) return Point is
        (((P.X + Q.X) / 2.0, (P.Y + Q.Y) / 2.0));

   begin
      for Step in 0 .. 11 loop
         Scene := Pictures.Scene_With (0, int (83 * Step), 40.0, 30.0,
                                       31.0 * double (Step));
         Scene.Width := 1_920;
         Scene.Height := 1_080;
         Assert (Scenes.Robot_Truth (Scene, 0, Cx, Cy, Dx, Dy) = 0, "truth");
         Scene.Lean_X := double (8.0E-4 * Cos (Long_Float (Step)));
         Scene.Lean_Y := double (8.0E-4 * Sin (Long_Float (Step)));
         Pictures.Show (Scene);
         Assert (Find (Aruco) = Ok
                 and then Count = 1 and then Found (0).Id = int (83 * Step),
                 "aslant," & Step'Image);

         --  The middle between its first and third corner

         Assert (Away (Found (0).Centre,
                       Between (Seen (1.0, -1.0), Seen (-1.0, 1.0))) < 0.5,
                 "its centre," & Step'Image);
         Assert (Away (Found (0).Direction,
                       Between (Seen (1.0, -1.0), Seen (1.0, 1.0))) < 0.7,
                 "its direction," & Step'Image);
      end loop;
   end Test_Aslant;

   procedure Test_Doubtful is
      --  One module that is covered: named rightly or not at all
      P      : Place;
      Module : Natural;
      Cover  : Long_Float;

      function Change (X, Y : Long_Float; Level : Long_Float)
        return Long_Float
      is (if abs (Along (P, X, Y) - Long_Float (Module / 4) + 1.5) < 0.5
            and then
              abs (Across (P, X, Y) - Long_Float (Module mod 4) + 1.5) < 0.5
          then Cover else Level);

   begin
      for Step in 0 .. 5 loop
         P := Marker_At (Step);
         for Number in 0 .. 63 loop
            Module := Number / 4;
            Cover := 20.0 + 70.0 * Long_Float (Number mod 4);
            Pictures.Show_Changed (P.Scene, Change'Access);
            Assert (Find (Aruco) = Not_Found
                    or else (Count = 1
                             and then Found (0).Id = int (83 * Step)),
                    "identifier with module" & Module'Image & " covered,"
                    & Step'Image);
         end loop;
      end loop;
   end Test_Doubtful;

   function In_The_Middle (Step : Natural) return Place is
     (Scenes.Default, 320.0, 240.0,
      320.0 + 3.0 * Cos (31.0 * Long_Float (Step), 360.0),
      240.0 + 3.0 * Sin (31.0 * Long_Float (Step), 360.0));
   --  Of the image, where pixels are modules, at each of twelve headings

   function Blend (Under, Over, Depth : Long_Float) return Long_Float is
     (Under + (Over - Under)
              * Long_Float'Max (0.0, Long_Float'Min (1.0, 0.5 + Depth)));
   --  A pixel on an edge shows both

   procedure Test_White_Shapes is
      --  With three corners: a triangle on something bright, and set squares,
      --  more and more aslant
      P    : Place;
      Tip  : Long_Float;
      U, V : Long_Float;

      function Marker (X, Y : Long_Float; Ignored : Long_Float)
        return Long_Float
      is
         pragma Unreferenced (Ignored);
         U    : constant Long_Float := Along (P, X, Y);
         V    : constant Long_Float := abs Across (P, X, Y);
         Side : constant Long_Float := 0.954 * (0.3125 * (24.0 - U) - V);
      begin
         return Blend (Blend (40.0, 110.0,
                              Long_Float'Min (36.0 - abs U, 30.0 - V)),
                       230.0, Long_Float'Min (U + 14.0, Side));
      end Marker;

      function Set_Square (X, Y : Long_Float; Ignored : Long_Float)
        return Long_Float
      is
         pragma Unreferenced (Ignored);
         U    : constant Long_Float := Along (P, X, Y) + 24.0;
         V    : constant Long_Float := Across (P, X, Y) + 18.0;
         Long : constant Long_Float := V - Tip * U / 64.0;
         Side : constant Long_Float :=
           0.88 * (37.0 - (37.0 - Tip) * U / 64.0 - V);
      begin
         return Blend (40.0, 230.0,
                       Long_Float'Min (U, Long_Float'Min (Long, Side)));
      end Set_Square;

   begin
      for Step in 0 .. 11 loop
         P := In_The_Middle (Step);
         Pictures.Show_Changed (P.Scene, Marker'Access);
         Assert (Find (Triangle) = Ok and then Count = 1,
                 "found" & Step'Image);
         U := Along (P, Long_Float (Found (0).Direction.X),
                     Long_Float (Found (0).Direction.Y));
         V := Across (P, Long_Float (Found (0).Direction.X),
                      Long_Float (Found (0).Direction.Y));
         Assert (abs (U - 24.0) < Position_Tolerance
                 and then abs V < Position_Tolerance, "tip" & Step'Image);
         for Lean in 0 .. 2 loop
            Tip := 2.0 * Long_Float (Lean);
            Pictures.Show_Changed (P.Scene, Set_Square'Access);
            Assert (Find (Triangle) = Not_Found,
                    "a set square" & Step'Image & Lean'Image);
         end loop;
      end loop;
   end Test_White_Shapes;

begin
   Run_Test ("every heading", Test_Headings'Access);
   Run_Test ("an upright marker", Test_Upright'Access);
   Run_Test ("resolutions", Test_Resolutions'Access);
   Run_Test ("two robots, and more than fit", Test_Several'Access);
   Run_Test ("the same with and without the arena",
             Test_Positions_In_Arena'Access);
   Run_Test ("outside the arena, strange arenas",
             Test_Outside_Arena'Access);
   Run_Test ("no robot", Test_None'Access);
   Run_Test ("seen from close and aslant", Test_Aslant'Access);
   Run_Test ("one of its modules covered", Test_Doubtful'Access);
   Run_Test ("a triangle on something bright, but no set square",
             Test_White_Shapes'Access);
end Vision_Robot_Tests;
