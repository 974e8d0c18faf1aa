--  SPDX-License-Identifier: GPL-3.0-or-later
--  What judges missions.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Emulators;
with Instants;              use Instants;
with Mission_Judges;        use Mission_Judges;
with Mission_Plans;         use Mission_Plans;
with Robot_Motion;
with Robot_Truths;
with Unit_Runs; use Unit_Runs;

procedure Mission_Judges_Tests is

   use type Robot_Motion.Micro;

   Two : constant Plan := Read ("10,10,0", "MPCM:30;10;30.00;30.0");
   --  200 mm, a quarter to the left, 200 mm

   J    : Judge;
   V    : Verdict;
   Time : Duration;

   procedure Begin_Anew is
   begin
      Start (J, Two);
      Time := 0.0;
   end Begin_Anew;

   procedure Drive
     (X1, Y1, X2, Y2 : Micro; Positions : Boolean := True)
   is
      --  A straight line in millimetres, one a millisecond; a position each
      --  time
      Steps : constant Micro :=
        Micro'Max (1, Micro'Max (abs (X2 - X1), abs (Y2 - Y1)));
   begin
      for K in 0 .. Steps loop
         if Positions then
            See_Position (J, Time);
         end if;
         See_Pose (J, Time,
                   (X      => X1 * 1_000 + (X2 - X1) * 1_000 * K / Steps,
                    Y      => Y1 * 1_000 + (Y2 - Y1) * 1_000 * K / Steps,
                    others => <>),
                   Driving => K < Steps);
         Time := Time + 0.001;
      end loop;
   end Drive;

   procedure Judge_It (Wrong : String := ""; Said : String := "done") is
      --  Wrong is what is wrong, "" nothing
   begin
      Conclude (J, Two, Said, 4.5, 3, V);
      Assert (V.Wrong = Wrong, "judged: """ & To_String (V.Wrong)
              & """ instead of """ & Wrong & """");
   end Judge_It;

   procedure Test_Blind is
   begin
      Begin_Anew;
      Drive (100, 100, 300, 100);
      Drive (300, 100, 300, 300, Positions => False);
      Judge_It;
      Assert (V.Blind in 0.195 .. 0.205, "blind for" & V.Blind'Image);

      --  At rest it may be blind for long
      Time := Time + 5.0;
      See_Position (J, Time);
      Drive (300, 300, 300, 300, Positions => False);
      Judge_It;

      Drive (300, 300, 300, 500, Positions => False);
      Drive (300, 500, 300, 250, Positions => False);
      Conclude (J, Two, "done", 4.5, 3, V);
      Assert (V.Blind in 0.44 .. 0.46
              and then V.Wrong = Integer (V.Blind * 1_000)'Image (2 .. 4)
                & " ms without a new position", "blind for" & V.Blind'Image);
   end Test_Blind;

   procedure Test_Ends is
   begin
      Begin_Anew;
      Drive (100, 100, 200, 100);
      Judge_It (Said => "aborted;no way");
      Assert (not V.Done and then To_String (V.Reason) = "no way"
              and then V.Passed = 0,
              "an end that is told");
      Judge_It ("no end was said", Said => "");
      Judge_It ("said done, 2 points not passed", Said => "done");
      See_Pose (J, Time, (300_000, 100_000, 0), Driving => True);
      Judge_It ("drives after its end", Said => "aborted;no way");
      Assert (V.Passed = 1, "passed" & V.Passed'Image);
   end Test_Ends;

   procedure Test_Passes is
   begin
      Begin_Anew;
      Drive (100, 114, 300, 114);
      Drive (300, 114, 300, 290);
      Judge_It;
      Assert (abs (V.Pass - 14.0) < 0.001 and then V.Passed = 2
              and then V.Orders = 3 and then V.Time = 4.5,
              "passed at" & V.Pass'Image);
      Assert (abs (Ratio (V) - 1.5) < 0.001, "ratio" & Ratio (V)'Image);

      Begin_Anew;
      Drive (100, 100, 300, 100);
      Drive (300, 100, 300, 284);
      Judge_It ("said done, 1 points not passed");
      Assert (abs (V.Pass - 16.0) < 0.001, "passed at" & V.Pass'Image);

      --  In their order

      Begin_Anew;
      Drive (300, 300, 300, 100);
      Judge_It ("said done, 1 points not passed");
      Drive (300, 100, 300, 300);
      Judge_It;

      --  To a wall

      Drive (300, 300, 737, 300);
      Judge_It;
      Assert (abs (V.Clearance - 1.0) < 0.001, "room" & V.Clearance'Image);
      Drive (737, 300, 738, 300);
      Judge_It ("has touched a wall");
   end Test_Passes;

   procedure Test_Plans is
      P : Plan;
   begin
      Assert (Order (Two) = "MPCM:30.00;10.00;30.00;30.00", Order (Two));
      Assert (abs (Exact_Time (Two) - 3.0) < 0.001,
              "exact:" & Exact_Time (Two)'Image);
      P := Read ("30,10,350", "MPCM:10;10");
      Assert (abs (Exact_Time (P) - 2.889) < 0.001,
              "half a turn, nearly:" & Exact_Time (P)'Image);
      Assert (Exact_Time (Read ("10,10,90", "MPCM:10;10")) = 0.0,
              "a point where it stands");
      for Row of Split
        ("10,10 MPCM:30;10|10,10,0 MPTH:30;10|10,10,0 MPCM:30;x"
         & "|10,10,0 MPCM:30;10;30|10,10,0 MPCM:3000;10")
      loop
         begin
            P := Read (Split (Row, ' ') (1), Split (Row, ' ') (2));
            Assert (False, Row & " gives" & P.Count'Image);
         exception
            when Bad_Plan => null;
         end;
      end loop;
   end Test_Plans;

   procedure Test_Random_Plans is
      use type Robot_Motion.Wheel_Errors;
      P : Plan;
   begin
      for Number in 1 .. 500 loop
         P := Random (7, Number);
         Assert (P = Random (7, Number), "not the same again");
         Assert (P /= Random (8, Number), "the same with another seed");
         Assert (P.Faulty or else P.Wheels = Robot_Motion.Ideal,
                 "faults without being asked for");
         for Where of P.Points (1 .. P.Count) loop
            Assert (Where.X in Margin .. Robot_Motion.Arena_Width - Margin
                    and then
                      Where.Y in Margin .. Robot_Motion.Arena_Height - Margin,
                    "a point outside");
         end loop;
         Assert (Read ("8,8,0", Order (P)).Points (1 .. P.Count)
                 = P.Points (1 .. P.Count),
                 "the order has other points: " & Order (P));
      end loop;
   end Test_Random_Plans;

   procedure Test_Replay is

      Second : constant Instant := 1_000_000_000;
      Notes  : Emulators.Notes;
      Seen   : Natural := 0;

      procedure Put (Time : Instant; Command, Answer : String) is
      begin
         Notes.Append ((First   => Time - 1_000_000,
                        Last    => Time,
                        Command => To_Unbounded_String (Command),
                        Answer  => To_Unbounded_String (Answer),
                        others  => <>));
      end Put;

      procedure See
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean)
      is

         procedure Is_At (X, Y, Angle : Micro; Moves : Boolean) is
         begin
            Seen := Seen + 1;
            Assert (abs (Where.X - X) <= 50 and then abs (Where.Y - Y) <= 50
                    and then abs (Where.Angle - Angle) <= 50
                    and then Driving = Moves,
                    "after" & Instant'Image (Time / 1_000_000) & " ms:"
                    & Where.X'Image & Where.Y'Image & Where.Angle'Image
                    & " " & Driving'Image);
         end Is_At;

      begin
         case Time / 1_000_000 is
            when 10_999 => Is_At (100_000, 100_000, 0, False);
            when 11_500 => Is_At (190_000, 100_000, 0, True);
            when 12_500 => Is_At (280_000, 100_000, 0, False);
            when 13_500 => Is_At (280_000, 100_000, 49_500_000, True);
            when 15_000 => Is_At (280_000, 100_000, 99_000_000, False);
            when 16_500 => Is_At (280_000, 100_000, 99_000_000, False);
            when others => null;
         end case;
      end See;

   begin
      Put (11 * Second, "M=200", "O");
      Put (Second * 23 / 2, "v", "2");
      Put (Second * 23 / 2, "M=100", "E");
      Put (13 * Second, "T=90", "O");
      Put (16 * Second, "M=0", "O");
      Robot_Truths.Replay (Notes, (100_000, 100_000, 0),
                           (Speed => 90, Turn_Speed => 110, others => 0),
                           10 * Second, 17 * Second, See'Access);
      Assert (Seen = 6, "poses:" & Seen'Image);
      Assert (Robot_Truths.Movements (Notes) = 2,
              "movements:" & Robot_Truths.Movements (Notes)'Image);
   end Test_Replay;

begin
   Run_Test ("plans, good and bad", Test_Plans'Access);
   Run_Test ("random plans", Test_Random_Plans'Access);
   Run_Test ("a journal's truth", Test_Replay'Access);
   Run_Test ("the points' distances and order, walls", Test_Passes'Access);
   Run_Test ("without a position", Test_Blind'Access);
   Run_Test ("ends", Test_Ends'Access);
end Mission_Judges_Tests;
