--  SPDX-License-Identifier: GPL-3.0-or-later
--  The wheels: distances, turns, walls.

with Ada.Numerics;
with Ada.Numerics.Long_Elementary_Functions;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Robot_Motion;     use Robot_Motion;
with Unit_Runs; use Unit_Runs;

procedure Robot_Motion_Tests is

   type Pulls is array (Positive range <>) of Pull_Angle;

   type Exact_Pose is record
      X, Y, Angle : Long_Float;  --  micrometres, degrees
   end record;

   procedure Expect
     (M : Motion; X, Y, Angle : Micro; Tolerance : Micro := 0)
   is
      P : constant Pose := Pose_Of (M);
   begin
      Assert (abs (P.X - X) <= Tolerance
              and then abs (P.Y - Y) <= Tolerance
              and then P.Angle = Angle,
              "at" & P.X'Image & P.Y'Image & P.Angle'Image & ", not"
              & X'Image & Y'Image & Angle'Image);
   end Expect;

   procedure Expect_Near (M : Motion; Exact : Exact_Pose; What : String) is
      --  Within the 40 micrometres of Pose_Of's description
      P       : constant Pose := Pose_Of (M);
      Degrees : constant Long_Float :=
        abs (Long_Float (P.Angle) / 1.0e6 - Exact.Angle);
   begin
      Assert (abs (Long_Float (P.X) - Exact.X) <= 40.0
              and then abs (Long_Float (P.Y) - Exact.Y) <= 40.0
              and then (Degrees < 2.0e-6 or else Degrees > 360.0 - 2.0e-6),
              What & ": at" & P.X'Image & P.Y'Image & P.Angle'Image
              & ", not" & Exact.X'Image & Exact.Y'Image & Exact.Angle'Image);
   end Expect_Near;

   function On_Arc
     (From : Pose; Pull : Pull_Angle; Length : Long_Float)
      return Exact_Pose
   is
      --  By the circle's centre; Length in micrometres, negative backward
      use Ada.Numerics.Long_Elementary_Functions;
      Radius : constant Long_Float :=
        1.0e6 * 180.0 / (Ada.Numerics.Pi * Long_Float (Pull));
      --  Negative to the right
      Before : constant Long_Float := Long_Float (From.Angle) / 1.0e6;
      After  : constant Long_Float :=
        Before + Long_Float (Pull) * Length / 1.0e6;
   begin
      return
        (X     => Long_Float (From.X)
                  + Radius * (Sin (After, 360.0) - Sin (Before, 360.0)),
         Y     => Long_Float (From.Y)
                  - Radius * (Cos (After, 360.0) - Cos (Before, 360.0)),
         Angle => (if After < 0.0 then After + 360.0
                   elsif After >= 360.0 then After - 360.0
                   else After));
   end On_Arc;

   procedure Pass (M : in out Motion; Time : Micro) is
      --  Any time, in steps
      Left : Micro := Time;
   begin
      while Left > 0 loop
         Advance (M, Micro'Min (Left, Step'Last));
         Left := Left - Micro'Min (Left, Step'Last);
      end loop;
   end Pass;

   procedure Pass_To_End (M : in out Motion; Time : Micro) is
      --  Its order ends after exactly that time
   begin
      Pass (M, Time - 1);
      Assert (Is_Moving (M), "too early");
      Pass (M, 1);
      Assert (not Is_Moving (M), "too late");
   end Pass_To_End;

   procedure Expect_After
     (M : in out Motion; Time, X, Y, Angle : Micro; Tolerance : Micro := 0) is
   begin
      Pass (M, Time);
      Expect (M, X, Y, Angle, Tolerance);
   end Expect_After;

   procedure Expect_End (M : in out Motion; Time, X, Y, Angle : Micro) is
      --  Its order ends after exactly that time, and there
   begin
      Pass_To_End (M, Time);
      Expect (M, X, Y, Angle);
   end Expect_End;

   function Placed (X, Y, Angle : Micro) return Motion is
      M : Motion;
   begin
      Place (M, (X, Y, Angle));
      return M;
   end Placed;

   procedure Play (Script : String; Wheels : Wheel_Errors := (others => <>)) is
      --  Its words: "@X,Y,ANGLE" places it; "go:N" and "turn:N" order,
      --  "halt" halts; "+N" microseconds pass, "!N" just as many until the
      --  order ends; "moves" and "rests"; "=X,Y,ANGLE" is where it is, with
      --  the tolerance that "~N" has set
      M         : Motion;
      Tolerance : Micro := 0;

      function Part (Word : String; Number : Positive) return Micro is
        (Micro'Value (Split (Word, ',') (Number)));

      procedure Carry_Out (Word : String) is
         Rest  : constant String := Word (Word'First + 1 .. Word'Last);
         Colon : constant Natural := Index (Word, ":");
         Order : constant String :=
           Word (Natural'Max (Colon, Word'First) + 1 .. Word'Last);
      begin
         case Word (Word'First) is
            when '@' =>
               Place (M, (Part (Rest, 1), Part (Rest, 2), Part (Rest, 3)));
            when '=' =>
               Expect (M, Part (Rest, 1), Part (Rest, 2), Part (Rest, 3),
                       Tolerance);
            when '+' => Pass (M, Micro'Value (Rest));
            when '!' => Pass_To_End (M, Micro'Value (Rest));
            when '~' => Tolerance := Micro'Value (Rest);
            when 'g' => Go (M, Integer'Value (Order), Wheels);
            when 't' => Turn (M, Integer'Value (Order), Wheels);
            when 'h' => Halt (M);
            when others =>
               Assert (Is_Moving (M) = (Word = "moves"),
                       Word & " in " & Script);
         end case;
      end Carry_Out;

   begin
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

   procedure Test_Orders is
      M : Motion;
   begin
      --  Straight on

      Play ("=400_000,300_000,0 rests go:1 !5_000 =401_000,300_000,0"
            & " go:-201 +1_005_000 =200_000,300_000,0");

      --  Turns, and those without an end

      Play ("turn:90 +500_000 =400_000,300_000,45_000_000 !500_000"
            & " =400_000,300_000,90_000_000 turn:-91 +2_000_000"
            & " =400_000,300_000,359_000_000 turn:7 +77_778 rests"
            & " =400_000,300_000,6_000_000 turn:720 +8_000_000"
            & " =400_000,300_000,6_000_000");
      Play ("turn:32767 " & 1_000 * "+4_000_000 " & "moves =400_000,300_000,0"
            & " +500_000 =400_000,300_000,45_000_000 turn:-32768 +1_000_000"
            & " =400_000,300_000,315_000_000");

      --  A halt, and orders by 0

      Play ("go:500 +300_000 halt rests =460_000,300_000,0 +10_000_000"
            & " =460_000,300_000,0 turn:90 +250_000 turn:0 rests"
            & " =460_000,300_000,22_500_000 go:0 rests");

      --  100 squares

      Play ("@300_000,200_000,0 "
            & 400 * "go:200 +1_000_000 turn:90 +1_000_000 "
            & "=300_000,200_000,0");

      --  The longest finite orders take their time and end where they must;
      --  32,766 * 1.3 * 1.2 degrees are 141 turns and 354.96 degrees

      Play ("turn:32766 !364_066_667 =400_000,300_000,6_000_000"
            & " @400_000,300_000,0 turn:-32767 +365_000_000"
            & " =400_000,300_000,353_000_000 @400_000,300_000,0 go:32766"
            & " !163_830_000 =738_000,300_000,0");
      Play ("turn:32766 !436_880_000 =400_000,300_000,354_960_000",
            (130, 130, 20, 30));
      Go (M, -32_767, (130, 130, 20, 30));
      Pass_To_End (M, 163_835_000);
      Assert (Pose_Of (M).X = 62_000, "not at the wall");

      --  Walls: it stops where it touches, does not slide along, and gets
      --  away again. Its wheels slip: an order takes as long as elsewhere

      Play ("go:32767 +60_000_000 =738_000,300_000,0 go:-32768 +60_000_000"
            & " =62_000,300_000,0 @400_000,300_000,90_000_000 go:32767"
            & " +60_000_000 =400_000,538_000,90_000_000 go:-32768 +60_000_000"
            & " =400_000,62_000,90_000_000 @700_000,300_000,45_000_000"
            & " go:32767 +60_000_000 ~5 =738_000,338_000,45_000_000 go:-50"
            & " +250_000 ~10 =702_645,302_645,45_000_000"
            & " @738_000,300_000,0 go:200 !1_000_000 ~0 =738_000,300_000,0");
   end Test_Orders;

   procedure Test_Arc_Touches_A_Wall is
      Left : constant Wheel_Errors := (Pull => 30, others => <>);
      M    : Motion;
      P    : Pose;
   begin
      --  3 degrees towards the wall: the arc would come 2.6 mm nearer to it
      --  and then away again

      M := Placed (200_000, 66_000, 357_000_000);
      Go (M, 400, Left);
      Pass (M, 2_000_000);
      Expect_Near (M, On_Arc ((200_000, 66_000, 357_000_000), 30, 400_000.0),
                   "past the wall");

      M := Placed (200_000, 63_000, 357_000_000);
      Go (M, 400, Left);
      Pass (M, 2_000_000);
      P := Pose_Of (M);
      Assert (P.Y = 62_000 and then P.X in 220_000 .. 225_000,
              "not where it touched the wall:" & P.X'Image & P.Y'Image);

      --  There it stays, and so does its heading, but for the micrometre
      --  by which positions are rounded; backward it gets away

      Go (M, 400, Left);
      Pass (M, 1_000_000);
      Assert (Pose_Of (M).Y = P.Y and then Pose_Of (M).X - P.X in 0 .. 50
              and then Pose_Of (M).Angle - P.Angle in 0 .. 1_500,
              "along the wall");
      Pass (M, 1_000_000);
      Go (M, -10, Left);
      Pass (M, 50_000);
      Assert (Pose_Of (M).Y > 62_100, "caught at the wall");
   end Test_Arc_Touches_A_Wall;

   procedure Test_Arcs is
      M       : Motion;
      Start   : Pose;
      Heading : Micro;
   begin
      for Pull in Pull_Angle loop
         for Step in 0 .. 59 loop
            Heading := Micro (Step) * 6_012_345;
            if Pull /= 0 then
               for Speed in 7 .. 13 loop
                  M := Placed (400_000, 300_000, Heading);
                  Start := Pose_Of (M);
                  Go (M, (if Step mod 2 = 0 then 170 else -170),
                      (Speed => 10 * Speed, Pull => Pull, others => <>));
                  Pass (M, 400_000);
                  Expect_Near
                    (M,
                     On_Arc (Start, Pull,
                             Long_Float (Speed) * 8_000.0
                             * (if Step mod 2 = 0 then 1.0 else -1.0)),
                     "under way");
                  Pass_To_End (M, 450_000);
                  Expect_Near
                    (M,
                     On_Arc (Start, Pull,
                             Long_Float (Speed) * 17_000.0
                             * (if Step mod 2 = 0 then 1.0 else -1.0)),
                     "at the end");
               end loop;
            end if;
         end loop;

         --  Nearly the longest there are

         if Pull /= 0 then
            M := Placed (100_000, 300_000, 0);
            Start := Pose_Of (M);
            Go (M, 600, (Pull => Pull, others => <>));
            Pass (M, 3_000_000);
            Expect_Near (M, On_Arc (Start, Pull, 600_000.0), "long");
            Assert (Pose_Of (M).Angle
                    = (Micro (Pull) * 600_000) mod Full_Turn, "its heading");
         end if;
      end loop;
   end Test_Arcs;

   procedure Test_Arcs_At_Walls is
      M      : Motion;
      Start  : Pose;
      P      : Pose;
      Turned : Micro;
      Length : Long_Float;
      Before : Exact_Pose;
   begin
      for Pull of Pulls'(-30, -11, -1, 1, 12, 30) loop
         for Degree in 0 .. 359 loop
            M := Placed (111_111, 500_000, Micro (Degree) * 1_000_000);
            Start := Pose_Of (M);
            Go (M, (if Degree mod 3 = 0 then Endless_Backward
                    else Endless_Forward),
                (Speed => 70 + Degree mod 61, Pull => Pull, others => <>));
            Pass (M, 60_000_000);
            Assert (Is_Moving (M), "ended");

            --  At a wall, on the arc, and nowhere before was there a wall

            P := Pose_Of (M);
            Assert (P.X <= 62_002 or else P.X >= 737_998
                    or else P.Y <= 62_002 or else P.Y >= 537_998,
                    "not at a wall:" & P.X'Image & P.Y'Image);
            Turned := (P.Angle - Start.Angle) mod Full_Turn;
            if Turned > Full_Turn / 2 then
               Turned := Turned - Full_Turn;
            end if;
            Length := Long_Float (Turned) / Long_Float (Pull);
            Assert ((Length <= 0.0) = (Degree mod 3 = 0), "its direction");
            Expect_Near (M, On_Arc (Start, Pull, Length), "on its arc");
            for Part in 0 .. 99 loop
               Before := On_Arc
                 (Start, Pull, Length * Long_Float (Part) / 100.0);
               Assert (Before.X > 61_960.0 and then Before.X < 738_040.0
                       and then Before.Y > 61_960.0
                       and then Before.Y < 538_040.0, "through a wall");
            end loop;
         end loop;
      end loop;
   end Test_Arcs_At_Walls;

   procedure Test_Back_Along_An_Arc is
      M : Motion;
   begin
      for Degree in 0 .. 359 loop
         M := Placed (400_000, 300_000, Micro (Degree) * 1_000_000);
         Go (M, 200, (Pull => 23, others => <>));
         Pass (M, 1_000_000);
         Assert (Pose_Of (M).Angle
                 = (Micro (Degree) * 1_000_000 + 4_600_000) mod Full_Turn,
                 "23 degrees per metre");
         Go (M, -200, (Pull => 23, others => <>));
         Expect_After (M, 1_000_000, 400_000, 300_000,
                       Micro (Degree) * 1_000_000, Tolerance => 2);
      end loop;
   end Test_Back_Along_An_Arc;

   procedure Test_Every_Direction is
      use Ada.Numerics.Long_Elementary_Functions;
      M : Motion;
   begin
      for Degree in 0 .. 359 loop
         M := Placed (400_000, 300_000, Micro (Degree) * 1_000_000 + 123_456);
         Go (M, 100);
         Pass (M, 500_000);
         Assert (not Is_Moving (M), "still under way");
         declare
            Angle : constant Long_Float := Long_Float (Degree) + 0.123_456;
         begin
            Expect (M,
                    400_000 + Micro (100_000.0 * Cos (Angle, 360.0)),
                    300_000 + Micro (100_000.0 * Sin (Angle, 360.0)),
                    Micro (Degree) * 1_000_000 + 123_456,
                    Tolerance => 6);
         end;
      end loop;
   end Test_Every_Direction;

   procedure Test_Overshoot is
      M : Motion;
   begin
      for Part in Overshoot_Percent loop
         M := Placed (400_000, 300_000, 0);
         Turn (M, 90, (Overshoot => Part, others => <>));
         Expect_End (M, 1_000_000 + Micro (Part) * 10_000, 400_000, 300_000,
                     90_000_000 + Micro (Part) * 900_000);
      end loop;

      Play ("@400_000,300_000,108_000_000 turn:-90 +1_000_000"
            & " =400_000,300_000,18_000_000 +500_000 =400_000,300_000,0",
            (Overshoot => 20, others => <>));

      --  Its factor and that of the speed: 90 * 0.7 * 1.2. Neither stopping
      --  a turn nor an endless one knows it, nor a way.

      Play ("turn:90 !1_200_000 =400_000,300_000,75_600_000",
            (Turn_Speed => 70, Overshoot => 20, others => <>));
      Play ("@400_000,300_000,75_600_000 turn:-90 +840_000 halt +1_000_000"
            & " =400_000,300_000,0 turn:32767 +41_000_000"
            & " =400_000,300_000,90_000_000 halt go:100 +500_000 rests"
            & " =400_000,400_000,90_000_000",
            (Overshoot => 20, others => <>));
   end Test_Overshoot;

   procedure Test_Sine is
      use Ada.Numerics.Long_Elementary_Functions;
      Angle : Micro := 0;
   begin
      Assert (Sine (0) = 0 and then Cosine (0) = 1_000_000, "0");
      Assert (Sine (90_000_000) = 1_000_000
              and then Cosine (90_000_000) = 0, "90");
      Assert (Sine (180_000_000) = 0
              and then Cosine (180_000_000) = -1_000_000, "180");
      Assert (Sine (270_000_000) = -1_000_000
              and then Cosine (270_000_000) = 0, "270");
      while Angle in Heading loop
         Assert
           (abs (Long_Float (Sine (Angle))
                 - 1.0e6 * Sin (Long_Float (Angle) / 1.0e6, 360.0)) < 40.0
            and then
            abs (Long_Float (Cosine (Angle))
                 - 1.0e6 * Cos (Long_Float (Angle) / 1.0e6, 360.0)) < 40.0,
            "at" & Angle'Image);
         Angle := Angle + 77_777;
      end loop;
   end Test_Sine;

   procedure Test_Speed is
      M : Motion;
   begin
      for Speed in Speed_Percent loop
         M := Placed (300_000, 300_000, 0);
         Go (M, 200, (Speed => Speed, others => <>));
         Expect_After
           (M, 500_000, 300_000 + 1_000 * Micro (Speed), 300_000, 0);
         Expect_End (M, 500_000, 300_000 + 2_000 * Micro (Speed), 300_000, 0);
         Turn (M, 90, (Speed => Speed, others => <>));
         Expect_After (M, 1_000_000, 300_000 + 2_000 * Micro (Speed), 300_000,
                       90_000_000);
      end loop;

      --  The wall stops it, its order takes the usual time

      Go (M, -300, (Speed => 130, others => <>));
      Expect_End (M, 1_500_000, 700_000, 62_000, 90_000_000);

      --  The slowest without an end gets from one wall to the other

      Go (M, Endless_Forward, (Speed => Speed_Percent'First, others => <>));
      Expect_After (M, 100_000_000, 700_000, 538_000, 90_000_000);
   end Test_Speed;

   procedure Test_Steps_Do_Not_Matter is
      A, B : Motion := Placed (300_000, 200_000, 33_300_000);
      P    : Pose;
   begin
      Go (A, 150);
      Go (B, 150);
      Pass (A, 700_000);
      for K in 1 .. 100_000 loop
         Advance (B, 7);
      end loop;
      P := Pose_Of (A);
      Expect (B, P.X, P.Y, P.Angle);
   end Test_Steps_Do_Not_Matter;

   procedure Test_Turn_Speed is
      M : Motion;
   begin
      for Speed in Speed_Percent loop
         M := Placed (400_000, 300_000, 0);
         Turn (M, 200, (Turn_Speed => Speed, others => <>));
         Expect_After (M, 500_000, 400_000, 300_000, 450_000 * Micro (Speed));
         Expect_End (M, 1_722_223, 400_000, 300_000,
                     (2_000_000 * Micro (Speed)) mod Full_Turn);
         Turn (M, -200, (Turn_Speed => Speed, others => <>));
         Expect_After (M, 3_000_000, 400_000, 300_000, 0);

         --  Without an end, by 0.9 degrees a second and percent, for hours

         Turn (M, Endless_Backward, (Turn_Speed => Speed, others => <>));
         for K in 1 .. 100 loop
            Pass (M, 399_000_000);
         end loop;
         Assert (Is_Moving (M), "ended");
         Expect (M, 400_000, 300_000,
                 (-(39_900 * 900_000 * Micro (Speed))) mod Full_Turn);
      end loop;
   end Test_Turn_Speed;

   procedure Test_Walls is
      M : Motion;
   begin
      --  Every direction, however slanted

      for Degree in 0 .. 359 loop
         M := Placed (111_111, 537_999, Micro (Degree) * 1_000_000);
         Go (M, Endless_Forward);
         Pass (M, 60_000_000);
         Assert (Is_Moving (M), "ended");
         declare
            P : constant Pose := Pose_Of (M);
         begin
            Assert (Micro'Max (P.X, 738_000) = 738_000
                    and then Micro'Min (P.X, 62_000) = 62_000
                    and then Micro'Max (P.Y, 538_000) = 538_000
                    and then Micro'Min (P.Y, 62_000) = 62_000, "outside");
         end;
      end loop;
   end Test_Walls;

begin
   Run_Test ("sine and cosine", Test_Sine'Access);
   Run_Test ("orders, one by one", Test_Orders'Access);
   Run_Test ("every direction", Test_Every_Direction'Access);
   Run_Test ("walls", Test_Walls'Access);
   Run_Test ("small steps or large", Test_Steps_Do_Not_Matter'Access);
   Run_Test ("speeds", Test_Speed'Access);
   Run_Test ("speeds of turns", Test_Turn_Speed'Access);
   Run_Test ("overshoot", Test_Overshoot'Access);
   Run_Test ("arcs", Test_Arcs'Access);
   Run_Test ("back along an arc", Test_Back_Along_An_Arc'Access);
   Run_Test ("arcs at walls", Test_Arcs_At_Walls'Access);
   Run_Test ("an arc that touches a wall", Test_Arc_Touches_A_Wall'Access);
end Robot_Motion_Tests;
