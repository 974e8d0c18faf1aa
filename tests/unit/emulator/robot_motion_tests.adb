--  SPDX-License-Identifier: GPL-3.0-or-later
--  The wheels: distances, turns, walls.

with Ada.Numerics;
with Ada.Numerics.Long_Elementary_Functions;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Robot_Motion;     use Robot_Motion;
with Unit_Runs; use Unit_Runs;

procedure Robot_Motion_Tests is

   subtype Arc_Angle is Pull_Angle with Static_Predicate => Arc_Angle /= 0;

   type Angles is array (Positive range <>) of Pull_Angle;

   type Exact_Pose is record
      X, Y, Angle : Long_Float;  --  micrometres, degrees
   end record;

   M : Motion;

   procedure Expect (X, Y, Angle : Micro; Tolerance : Micro := 0) is
      P : constant Pose := Pose_Of (M);
   begin
      Assert (abs (P.X - X) <= Tolerance
              and then abs (P.Y - Y) <= Tolerance
              and then P.Angle = Angle,
              "at" & P.X'Image & P.Y'Image & P.Angle'Image & ", not"
              & X'Image & Y'Image & Angle'Image);
   end Expect;

   procedure Expect_Near (Exact : Exact_Pose; What : String) is
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

   procedure Pass (Time : Micro) is
      --  Any time, in steps
      Left : Micro := Time;
   begin
      while Left > 0 loop
         Advance (M, Micro'Min (Left, Step'Last));
         Left := Left - Micro'Min (Left, Step'Last);
      end loop;
   end Pass;

   procedure Pass_To_End (Time : Micro) is
      --  Its order ends after exactly that time
   begin
      Pass (Time - 1);
      Assert (Is_Moving (M), "too early");
      Pass (1);
      Assert (not Is_Moving (M), "too late");
   end Pass_To_End;

   procedure Play (Script : String) is
      --  Its words: "@X,Y,ANGLE" places it, at first in the middle, with the
      --  wheels "*SPEED,TURN_SPEED,OVERSHOOT,PULL", at first ideal; "go:N" and
      --  "turn:N" order, "halt" halts; "+N" microseconds pass, "!N" just as
      --  many until the order ends; "moves", "rests" and "west", at that wall;
      --  "=X,Y,ANGLE" is where it is, with the tolerance that "~N" has set
      Wheels    : Wheel_Errors;
      Tolerance : Micro := 0;

      procedure Carry_Out (Word : String) is
         Rest  : constant String := Word (Word'First + 1 .. Word'Last);
         Order : constant String :=
           Word (Natural'Max (Index (Word, ":") + 1, Word'First)
                 .. Word'Last);

         function Part (Number : Positive) return Micro is
           (Micro'Value (Split (Rest, ',') (Number)));

      begin
         case Word (Word'First) is
            when '@' => Place (M, (Part (1), Part (2), Part (3)));
            when '=' => Expect (Part (1), Part (2), Part (3), Tolerance);
            when '*' => Wheels := (Integer (Part (1)), Integer (Part (2)),
                                   Integer (Part (3)), Integer (Part (4)));
            when '+' => Pass (Micro'Value (Rest));
            when '!' => Pass_To_End (Micro'Value (Rest));
            when '~' => Tolerance := Micro'Value (Rest);
            when 'g' => Go (M, Integer'Value (Order), Wheels);
            when 't' => Turn (M, Integer'Value (Order), Wheels);
            when 'h' => Halt (M);
            when 'w' => Assert (Pose_Of (M).X = X_Position'First, Script);
            when others =>
               Assert (Is_Moving (M) = (Word = "moves"),
                       Word & " in " & Script);
         end case;
      end Carry_Out;

   begin
      Place (M, (others => <>));
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

   procedure Test_Arc_Touches_A_Wall is
      Left : constant Wheel_Errors := (Pull => 30, others => <>);
      P    : Pose;
   begin
      --  3 degrees towards the wall: the arc would come 2.6 mm nearer to it
      --  and then away again

      Place (M, (200_000, 66_000, 357_000_000));
      Go (M, 400, Left);
      Pass (2_000_000);
      Expect_Near (On_Arc ((200_000, 66_000, 357_000_000), 30, 400_000.0),
                   "past the wall");

      Place (M, (200_000, 63_000, 357_000_000));
      Go (M, 400, Left);
      Pass (2_000_000);
      P := Pose_Of (M);
      Assert (P.Y = 62_000 and then P.X in 220_000 .. 225_000,
              "not where it touched the wall:" & P.X'Image & P.Y'Image);

      --  There it stays, and so does its heading, but for the micrometre
      --  by which positions are rounded; backward it gets away

      Go (M, 400, Left);
      Pass (1_000_000);
      Assert (Pose_Of (M).Y = P.Y and then Pose_Of (M).X - P.X in 0 .. 50
              and then Pose_Of (M).Angle - P.Angle in 0 .. 1_500,
              "along the wall");
      Pass (1_000_000);
      Go (M, -10, Left);
      Pass (50_000);
      Assert (Pose_Of (M).Y > 62_100, "caught at the wall");
   end Test_Arc_Touches_A_Wall;

   procedure Test_Arcs is
      Start : Pose;
      Way   : Long_Float;
   begin
      for Pull in Arc_Angle loop
         for Step in 0 .. 59 loop
            for Speed in 7 .. 13 loop
               Start := (400_000, 300_000, Micro (Step) * 6_012_345);
               Way := Long_Float (Speed) * (-1.0) ** (Step mod 2);
               Place (M, Start);
               Go (M, 170 * (-1) ** (Step mod 2),
                   (Speed => 10 * Speed, Pull => Pull, others => <>));
               Pass (400_000);
               Expect_Near (On_Arc (Start, Pull, 8_000.0 * Way), "under way");
               Pass_To_End (450_000);
               Expect_Near (On_Arc (Start, Pull, 17_000.0 * Way), "its end");
            end loop;
         end loop;

         --  Nearly the longest there are

         Start := (100_000, 300_000, 0);
         Place (M, Start);
         Go (M, 600, (Pull => Pull, others => <>));
         Pass (3_000_000);
         Expect_Near (On_Arc (Start, Pull, 600_000.0), "long");
         Assert (Pose_Of (M).Angle = (Micro (Pull) * 600_000) mod Full_Turn,
                 "its heading");
      end loop;
   end Test_Arcs;

   procedure Test_Arcs_At_Walls is
      Start, P : Pose;
      Turned   : Micro;
      Length   : Long_Float;
      Before   : Exact_Pose;
   begin
      for Pull of Angles'(-30, -11, -1, 1, 12, 30) loop
         for Degree in 0 .. 359 loop
            Start := (111_111, 500_000, Micro (Degree) * 1_000_000);
            Place (M, Start);
            Go (M, (if Degree mod 3 = 0 then Endless_Backward
                    else Endless_Forward),
                (Speed => 70 + Degree mod 61, Pull => Pull, others => <>));
            Pass (60_000_000);
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
            Expect_Near (On_Arc (Start, Pull, Length), "on its arc");
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

   procedure Test_Every_Direction is
      Forward : Pose;
   begin
      for Degree in Micro range 0 .. 359 loop
         for Pull of Angles'(0, 23) loop
            Place (M, (400_000, 300_000, Degree * 1_000_000 + 123_456));
            Go (M, 100, (Pull => Pull, others => <>));
            Pass (500_000);
            Assert (not Is_Moving (M), "still under way");
            Forward := Pose_Of (M);
            Assert (Forward.Angle = (Degree * 1_000_000 + 123_456
                                     + Micro (Pull) * 100_000) mod Full_Turn,
                    "its heading");
            if Pull = 0 then
               Assert (abs (Forward.X - 400_000
                            - Cosine (Forward.Angle) / 10) <= 6
                       and then abs (Forward.Y - 300_000
                                     - Sine (Forward.Angle) / 10) <= 6,
                       "towards" & Degree'Image);
            end if;
            Go (M, -100, (Pull => Pull, others => <>));
            Pass (500_000);
            Expect (400_000, 300_000, Degree * 1_000_000 + 123_456, 2);
         end loop;
      end loop;
   end Test_Every_Direction;

   procedure Test_Sine is
      use Ada.Numerics.Long_Elementary_Functions;
      Angle : Micro := 0;
   begin
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

   procedure Test_Small_Steps is
      Small : Pose;
   begin
      Play ("@300_000,200_000,33_300_000 go:150");
      for K in 1 .. 100_000 loop
         Advance (M, 7);
      end loop;
      Small := Pose_Of (M);
      Play ("@300_000,200_000,33_300_000 go:150 +700_000");
      Expect (Small.X, Small.Y, Small.Angle);
   end Test_Small_Steps;

   procedure Test_Wheels is
   begin
      for Speed in Speed_Percent loop
         Place (M, (300_000, 300_000, 0));
         Go (M, 200, (Speed => Speed, others => <>));
         Pass (500_000);
         Expect (300_000 + 1_000 * Micro (Speed), 300_000, 0);
         Pass_To_End (500_000);
         Expect (300_000 + 2_000 * Micro (Speed), 300_000, 0);

         Turn (M, 200, (Turn_Speed => Speed, others => <>));
         Pass (500_000);
         Expect (300_000 + 2_000 * Micro (Speed), 300_000,
                 450_000 * Micro (Speed));
         Pass_To_End (1_722_223);
         Expect (300_000 + 2_000 * Micro (Speed), 300_000,
                 (2_000_000 * Micro (Speed)) mod Full_Turn);
         Turn (M, -200, (Turn_Speed => Speed, others => <>));
         Pass (3_000_000);
         Expect (300_000 + 2_000 * Micro (Speed), 300_000, 0);

         --  Without an end, by 0.9 degrees a second and percent, for hours

         Turn (M, Endless_Backward, (Turn_Speed => Speed, others => <>));
         Pass (39_900_000_000);
         Assert (Is_Moving (M), "ended");
         Expect (300_000 + 2_000 * Micro (Speed), 300_000,
                 (-(39_900 * 900_000 * Micro (Speed))) mod Full_Turn);
      end loop;
      for Part in Overshoot_Percent loop
         Place (M, (400_000, 300_000, 0));
         Turn (M, 90, (Overshoot => Part, others => <>));
         Pass_To_End (1_000_000 + Micro (Part) * 10_000);
         Expect (400_000, 300_000, 90_000_000 + Micro (Part) * 900_000);
      end loop;
   end Test_Wheels;

begin
   Run_Test ("sine and cosine", Test_Sine'Access);
   Run_Scripts
     (Play'Access,
      "straight on: =400_000,300_000,0 rests go:1 !5_000 =401_000,300_000,0"
      & " go:-201 +1_005_000 =200_000,300_000,0"

      & "|turns: turn:90 +500_000 =400_000,300_000,45_000_000 !500_000"
      & " =400_000,300_000,90_000_000 turn:-91 +2_000_000"
      & " =400_000,300_000,359_000_000 turn:7 +77_778 rests"
      & " =400_000,300_000,6_000_000 turn:720 +8_000_000"
      & " =400_000,300_000,6_000_000"
      & "|turns without an end: turn:32767 " & 1_000 * "+4_000_000 "
      & "moves =400_000,300_000,0 +500_000 =400_000,300_000,45_000_000"
      & " turn:-32768 +1_000_000 =400_000,300_000,315_000_000"

      & "|a halt, and orders by 0: go:500 +300_000 halt rests"
      & " =460_000,300_000,0 +10_000_000 =460_000,300_000,0 turn:90 +250_000"
      & " turn:0 rests =460_000,300_000,22_500_000 go:0 rests"

      & "|100 squares: @300_000,200_000,0 "
      & 400 * "go:200 +1_000_000 turn:90 +1_000_000 " & "=300_000,200_000,0"

      --  They take their time and end where they must; 32,766 * 1.3 * 1.2
      --  degrees are 141 turns and 354.96 degrees
      & "|the longest orders: turn:32766 !364_066_667"
      & " =400_000,300_000,6_000_000 @400_000,300_000,0 turn:-32767"
      & " +365_000_000 =400_000,300_000,353_000_000 @400_000,300_000,0"
      & " go:32766 !163_830_000 =738_000,300_000,0"
      & " @400_000,300_000,0 *130,130,20,30 turn:32766 !436_880_000"
      & " =400_000,300_000,354_960_000 go:-32767 !163_835_000 west"

      --  It stops where it touches, does not slide along, and gets away
      --  again. Its wheels slip: an order takes as long as elsewhere
      & "|walls: go:32767 +60_000_000 =738_000,300_000,0 go:-32768"
      & " +60_000_000 moves =62_000,300_000,0 @400_000,300_000,90_000_000"
      & " go:32767 +60_000_000 =400_000,538_000,90_000_000 go:-32768"
      & " +60_000_000 =400_000,62_000,90_000_000 @700_000,300_000,45_000_000"
      & " go:32767 +60_000_000 ~5 =738_000,338_000,45_000_000 go:-50"
      & " +250_000 ~10 =702_645,302_645,45_000_000 @738_000,300_000,0 go:200"
      & " !1_000_000 ~0 =738_000,300_000,0"
      & " @700_000,300_000,90_000_000 *130,100,0,0 go:-300 !1_500_000"
      & " =700_000,62_000,90_000_000 *3,100,0,0 go:32767 +100_000_000"
      & " =700_000,538_000,90_000_000"

      --  Its factor and that of the speed: 90 * 0.7 * 1.2. Neither stopping
      --  a turn nor an endless one knows it, nor a way
      & "|overshoot: @400_000,300_000,108_000_000 *100,100,20,0 turn:-90"
      & " +1_000_000 =400_000,300_000,18_000_000 +500_000 =400_000,300_000,0"
      & " *100,70,20,0 turn:90 !1_200_000 =400_000,300_000,75_600_000"
      & " *100,100,20,0 turn:-90 +840_000 halt +1_000_000"
      & " =400_000,300_000,0 turn:32767 +41_000_000"
      & " =400_000,300_000,90_000_000 halt go:100 +500_000 rests"
      & " =400_000,400_000,90_000_000");
   Run_Test ("every direction, and back", Test_Every_Direction'Access);
   Run_Test ("small steps or large", Test_Small_Steps'Access);
   Run_Test ("every speed and overshoot", Test_Wheels'Access);
   Run_Test ("arcs", Test_Arcs'Access);
   Run_Test ("arcs at walls", Test_Arcs_At_Walls'Access);
   Run_Test ("an arc that touches a wall", Test_Arc_Touches_A_Wall'Access);
end Robot_Motion_Tests;
