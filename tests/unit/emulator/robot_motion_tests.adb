--  SPDX-License-Identifier: GPL-3.0-or-later
--  The wheels: distances, turns, walls.

with Ada.Numerics.Long_Elementary_Functions;

with AUnit.Assertions; use AUnit.Assertions;

with Robot_Motion;     use Robot_Motion;

package body Robot_Motion_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   procedure Pass (M : in out Motion; Time : Micro);
   --  Any time, in steps

   procedure Expect
     (M : Motion; X, Y, Angle : Micro; Tolerance : Micro := 0);

   function Placed (X, Y, Angle : Micro) return Motion;

   procedure Test_Sine (T : in out Any_Test);
   procedure Test_Straight (T : in out Any_Test);
   procedure Test_Every_Direction (T : in out Any_Test);
   procedure Test_Turns (T : in out Any_Test);
   procedure Test_Halt (T : in out Any_Test);
   procedure Test_Walls (T : in out Any_Test);
   procedure Test_Wall_Keeps_Busy (T : in out Any_Test);
   procedure Test_Endless (T : in out Any_Test);
   procedure Test_Steps_Do_Not_Matter (T : in out Any_Test);
   procedure Test_Square (T : in out Any_Test);
   procedure Test_Extremes (T : in out Any_Test);

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

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Robot_Motion"));

   procedure Pass (M : in out Motion; Time : Micro) is
      Left : Micro := Time;
   begin
      while Left > 0 loop
         Advance (M, Micro'Min (Left, Step'Last));
         Left := Left - Micro'Min (Left, Step'Last);
      end loop;
   end Pass;

   function Placed (X, Y, Angle : Micro) return Motion is
      M : Motion;
   begin
      Place (M, (X, Y, Angle));
      return M;
   end Placed;

   procedure Test_Endless (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion;
   begin
      Turn (M, Endless_Forward);
      for K in 1 .. 1_000 loop
         Pass (M, 4_000_000);
      end loop;
      Assert (Is_Moving (M), "ended");
      Expect (M, 400_000, 300_000, 0);
      Pass (M, 500_000);
      Expect (M, 400_000, 300_000, 45_000_000);
      Turn (M, Endless_Backward);
      Pass (M, 1_000_000);
      Expect (M, 400_000, 300_000, 315_000_000);
   end Test_Endless;

   procedure Test_Every_Direction (T : in out Any_Test) is
      pragma Unreferenced (T);
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
            Expect
              (M,
               400_000 + Micro (100_000.0 * Cos (Angle, 360.0)),
               300_000 + Micro (100_000.0 * Sin (Angle, 360.0)),
               Micro (Degree) * 1_000_000 + 123_456,
               Tolerance => 6);
         end;
      end loop;
   end Test_Every_Direction;

   procedure Test_Extremes (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion;
   begin
      --  The longest finite orders take their time and end where they must

      Turn (M, 32_766);
      Pass (M, 364_066_666);
      Assert (Is_Moving (M), "too early");
      Pass (M, 1);
      Assert (not Is_Moving (M), "too late");
      Expect (M, 400_000, 300_000, 6_000_000);

      M := Placed (400_000, 300_000, 0);
      Turn (M, -32_767);
      Pass (M, 365_000_000);
      Expect (M, 400_000, 300_000, 353_000_000);

      M := Placed (400_000, 300_000, 0);
      Go (M, 32_766);
      Pass (M, 163_829_999);
      Assert (Is_Moving (M), "too early");
      Pass (M, 1);
      Assert (not Is_Moving (M), "too late");
      Expect (M, 738_000, 300_000, 0);
   end Test_Extremes;

   procedure Test_Halt (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion;
   begin
      Go (M, 500);
      Pass (M, 300_000);
      Halt (M);
      Assert (not Is_Moving (M), "moving");
      Expect (M, 460_000, 300_000, 0);
      Pass (M, 10_000_000);
      Expect (M, 460_000, 300_000, 0);
      Turn (M, 90);
      Pass (M, 250_000);
      Turn (M, 0);
      Assert (not Is_Moving (M), "turning");
      Expect (M, 460_000, 300_000, 22_500_000);
      Go (M, 0);
      Assert (not Is_Moving (M), "moving by 0");
   end Test_Halt;

   procedure Test_Sine (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Square (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion := Placed (300_000, 200_000, 0);
   begin
      for Round in 1 .. 100 loop
         for Side in 1 .. 4 loop
            Go (M, 200);
            Pass (M, 1_000_000);
            Turn (M, 90);
            Pass (M, 1_000_000);
         end loop;
      end loop;
      Expect (M, 300_000, 200_000, 0);
   end Test_Square;

   procedure Test_Steps_Do_Not_Matter (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Straight (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion;
   begin
      Expect (M, 400_000, 300_000, 0);
      Assert (not Is_Moving (M), "moving from the beginning");
      Go (M, 1);
      Pass (M, 4_999);
      Assert (Is_Moving (M), "too early");
      Pass (M, 1);
      Assert (not Is_Moving (M), "too late");
      Expect (M, 401_000, 300_000, 0);
      Go (M, -201);
      Pass (M, 1_005_000);
      Expect (M, 200_000, 300_000, 0);
   end Test_Straight;

   procedure Test_Turns (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion;
   begin
      Turn (M, 90);
      Pass (M, 500_000);
      Expect (M, 400_000, 300_000, 45_000_000);
      Pass (M, 499_999);
      Assert (Is_Moving (M), "too early");
      Pass (M, 1);
      Assert (not Is_Moving (M), "too late");
      Expect (M, 400_000, 300_000, 90_000_000);
      Turn (M, -91);
      Pass (M, 2_000_000);
      Expect (M, 400_000, 300_000, 359_000_000);
      Turn (M, 7);
      Pass (M, 77_778);
      Assert (not Is_Moving (M), "7 degrees, 77.8 ms");
      Expect (M, 400_000, 300_000, 6_000_000);
      Turn (M, 720);
      Pass (M, 8_000_000);
      Expect (M, 400_000, 300_000, 6_000_000);
   end Test_Turns;

   procedure Test_Walls (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion;
   begin
      Go (M, Endless_Forward);
      Pass (M, 60_000_000);
      Expect (M, 738_000, 300_000, 0);
      Go (M, Endless_Backward);
      Pass (M, 60_000_000);
      Expect (M, 62_000, 300_000, 0);

      M := Placed (400_000, 300_000, 90_000_000);
      Go (M, Endless_Forward);
      Pass (M, 60_000_000);
      Expect (M, 400_000, 538_000, 90_000_000);
      Go (M, Endless_Backward);
      Pass (M, 60_000_000);
      Expect (M, 400_000, 62_000, 90_000_000);

      --  It stops where it touches, it does not slide along

      M := Placed (700_000, 300_000, 45_000_000);
      Go (M, Endless_Forward);
      Pass (M, 60_000_000);
      Expect (M, 738_000, 338_000, 45_000_000, Tolerance => 5);

      --  And it gets away again

      Go (M, -50);
      Pass (M, 250_000);
      Expect (M, 702_645, 302_645, 45_000_000, Tolerance => 10);

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

   procedure Test_Wall_Keeps_Busy (T : in out Any_Test) is
      pragma Unreferenced (T);
      M : Motion := Placed (738_000, 300_000, 0);
   begin
      --  The wheels slip: the order takes as long as on free ground

      Go (M, 200);
      Pass (M, 999_999);
      Assert (Is_Moving (M), "ended at the wall");
      Pass (M, 1);
      Assert (not Is_Moving (M), "never ends");
      Expect (M, 738_000, 300_000, 0);
   end Test_Wall_Keeps_Busy;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Sine'Access, "sine and cosine");
      Register_Routine (T, Test_Straight'Access, "straight on");
      Register_Routine (T, Test_Every_Direction'Access, "every direction");
      Register_Routine (T, Test_Turns'Access, "turns");
      Register_Routine (T, Test_Halt'Access, "halt");
      Register_Routine (T, Test_Walls'Access, "walls");
      Register_Routine (T, Test_Wall_Keeps_Busy'Access, "busy at a wall");
      Register_Routine (T, Test_Endless'Access, "endless turns");
      Register_Routine
        (T, Test_Steps_Do_Not_Matter'Access, "small steps or large");
      Register_Routine (T, Test_Square'Access, "100 squares");
      Register_Routine (T, Test_Extremes'Access, "longest orders");
   end Register_Tests;

end Robot_Motion_Tests;
