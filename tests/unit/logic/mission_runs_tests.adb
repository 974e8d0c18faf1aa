--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Numerics.Elementary_Functions;
use Ada.Numerics.Elementary_Functions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Commands;
with Mission_Judges;
with Mission_Plans;
with Missions;            use Missions;
with Missions.Angles;     use Missions.Angles;
with Missions.Driving;    use Missions.Driving;
with Missions.Runs;       use Missions.Runs;
with Robot_Motion;
with Simulated_Missions;  use Simulated_Missions;
with Unit_Runs; use Unit_Runs;

procedure Mission_Runs_Tests is

   use type Commands.Request_Kind;

   Size    : constant Arena_Size := (80, 60);
   Period  : constant := 100_000;
   --  of the images, microseconds
   Corner  : constant Place := (100_000, 100_000);
   Points  : constant Place_Array :=
     (1 => (700_000, 500_000), others => Corner);

   function Said
     (Digit : Character;
      Kind  : Commands.Outcome_Kind := Commands.Done)
     return Commands.Outcome
   is ((Kind, (Digit & (2 .. Commands.Answer_Length'Last => ' '), 1),
        others => <>));

   type Answer is (Taken, Refused, Unanswered, Closed);
   --  What becomes of all requests

   procedure Play (Script : String) is
      --  Of a robot that stands. Its words: "@X,Y,TO_X,TO_Y" begins a mission
      --  from there to one point, in micrometres; "+N": so many ms pass;
      --  ":N" is an image that shows the robot, its heading in degrees,
      --  "hidden" one without it; "stop", "TURN" and "MOVE" are ordered next,
      --  "asks" asks whether it moves, and it does not; "nothing" is; "looks"
      --  only in 10 ms or more
      R       : Missions.Runs.Run;
      Next    : Action;
      Now     : Microseconds := 0;
      Images  : Natural := 0;
      Here    : Place;
      Heading : Bearing := 0;

      procedure Carry_Out (Word : String) is
         Part : constant Line_Vectors.Vector :=
           Split (Word (Word'First + 1 .. Word'Last), ',');

         function Number (Place : Positive) return Micrometres is
           (Micrometres'Value (Part (Place)));

      begin
         if Word (Word'First) = '@' then
            Here := (Number (1), Number (2));
            Start (R, Size, (1 => (Number (3), Number (4)), others => Here), 1,
                   Now);
         elsif Word (Word'First) = '+' then
            Now := Now + 1_000 * Microseconds'Value (Part (1));
         elsif Word (Word'First) = ':' or else Word = "hidden" then
            Images := Images + 1;
            if Word /= "hidden" then
               Heading := 1_000_000 * Bearing'Value (Part (1));
            end if;
            See (R, (Images, Now, Word /= "hidden", (Here, Heading)));
         elsif Word = "looks" then
            Assert (Next_Look (R, Now) >= Now + 10_000, "looks all the time");
         else
            Step (R, Now, Next);
            Assert
              (not Has_Ended (R)
               and then
                 (if Word = "nothing" then Next.Kind = Nothing
                  elsif Word = "asks" then Next.Kind = Ask
                  else Next.Kind = Order
                    and then
                      (if Word = "stop" then Next.Request.Kind = Commands.Stop
                       else Next.Request.Command.Kind'Image = Word)),
               Word & " at" & Now'Image & ": " & Next.Kind'Image);
            if Next.Kind /= Nothing then
               Tell (R, Said ('0'), Now);
            end if;
         end if;
      end Carry_Out;

   begin
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

   procedure Run_Until_End
     (Image_Every : Positive;
      Seen        : Boolean;
      Given       : Answer;
      Moves       : Boolean;
      Why         : Ending;
      Within      : Microseconds;
      Pushed      : Boolean := False)
   is
      --  The robot stands, whatever it is told, or is pushed to and fro each
      --  second. Of so many images one comes
      Aside : constant Place := (Corner.X + 20_000, Corner.Y);
      R     : Missions.Runs.Run;
      Next  : Action;
      Stops : Natural := 0;
      Now   : Microseconds := 0;
      Last  : Microseconds := 0;
      Image : Natural := 0;
   begin
      Start (R, Size, Points, 1, 0);
      loop
         if Now >= Last + Period then
            Last  := Now;
            Image := Image + 1;
            if Image mod Image_Every = 0 then
               See (R,
                    (Image, Now, Seen,
                     ((if Pushed and then Now / 1_000_000 mod 2 = 1 then Aside
                       else Corner),
                      0)));
            end if;
         end if;
         Step (R, Now, Next);
         case Next.Kind is
            when Nothing           => null;
            when Ask | Order       =>
               Assert (not Has_Ended (R), "goes on after the end");
               Tell (R,
                     Said
                       ((if Next.Kind = Ask and then Moves then '1' else '0'),
                        (case Given is
                            when Taken      => Commands.Done,
                            when Refused    => Commands.Refused,
                            when Unanswered => Commands.Timed_Out,
                            when Closed     => Commands.Not_Open)),
                     Now);
               if Given = Unanswered then
                  Now := Now + 80_000;
               end if;
            when Stop              =>
               Stops := Stops + 1;
               Tell (R,
                     (Kind   => (if Stops < 3 then Commands.Timed_Out
                                 else Commands.Done),
                      others => <>),
                     Now);
            when Leave             => exit;
         end case;
         Now := Now + 10_000;
         Assert (Now < 60_000_000, "does not end: " & Why'Image);
      end loop;
      Assert (Ended_By (R) = Why,
              Why'Image & " expected: " & Ended_By (R)'Image);
      Assert (Stops = 3, "stops until one is answered:" & Stops'Image);
      Assert (Now <= Within, Why'Image & " after" & Now'Image);
   end Run_Until_End;

   procedure Test_Angles is
      Length : constant array (1 .. 4) of Float :=
        (50.0, 40_000.0, 900_000.0, 9.0E8);
      X, Y   : Micrometres;
      Back   : Bearing;
   begin
      for K in Microdegrees range -1_800 .. 1_800 loop
         declare
            Angle : constant Bearing := K * 100_000;
            Rad   : constant Float := Float (K) / 1_800.0 * 3.141_592_65;
         begin
            Assert (abs (Float (Sine (Angle)) - 1.0E6 * Sin (Rad)) < 5.0
                    and then
                    abs (Float (Cosine (Angle)) - 1.0E6 * Cos (Rad)) < 5.0,
                    "sine or cosine of" & Angle'Image);
            for L of Length loop
               X := Micrometres (L * Cos (Rad));
               Y := Micrometres (L * Sin (Rad));
               Back := Direction (X, Y);
               Assert (abs Normal (Back - Angle) <
                         (if L > 1_000.0 then 3_000 else 1_500_000),
                       "direction" & X'Image & Y'Image & ":" & Back'Image);
               Assert (abs (Float (Along (X, Y, Back)) - L) < 2.0 + L / 1.0E4,
                       "length" & X'Image & Y'Image);
            end loop;
         end;
      end loop;
      Assert (Direction (0, 0) = 0, "no vector");
      Assert (Normal (270_000_000) = -90_000_000, "normal");
   end Test_Angles;

   procedure Test_Ends is
      R    : Missions.Runs.Run;
      Next : Action;
   begin
      Run_Until_End (100, True, Taken, False, No_Image, 350_000);
      Run_Until_End (1, False, Taken, False, No_Position, 350_000);
      Run_Until_End (1, True, Taken, True, No_Progress, 2_400_000);
      Run_Until_End (1, True, Taken, False, No_Progress, 2_400_000);
      Run_Until_End (1, True, Unanswered, True, No_Progress, 2_400_000);
      Run_Until_End (1, True, Refused, False, Orders_Refused, 500_000);
      Run_Until_End (1, True, Closed, False, Robot_Stopped, 100_000);
      for Moves in Boolean loop
         Run_Until_End (1, True, Unanswered, Moves, Leg_Too_Long, 34_000_000,
                        Pushed => True);
      end loop;

      for Why in Abort_Reason loop
         Start (R, Size, Points, 1, 0);
         End_By (R, Why);
         End_By (R, No_Image);
         Assert (Has_Ended (R) and then Ended_By (R) = Why, "another end");
         Step (R, 10, Next);
         Assert (Next.Kind =
                   (if Why in By_Hand | Session_Over then Leave else Stop),
                 "after " & Why'Image);
      end loop;
   end Test_Ends;

   procedure Test_Far_From_Ideal is
      --  Twenty missions each: within the range of Gain they are completed,
      --  outside of it they end soon, and say what was measured

      procedure Check
        (Turns, Drives : Robot_Motion.Speed_Percent;
         Why           : Ending;
         Percent       : Integer := 0)
      is
         P : Mission_Plans.Plan;
         R : Result;

         procedure Expect (Condition : Boolean; Text : String) is
         begin
            Assert
              (Condition,
               "turns" & Turns'Image & ", drives" & Drives'Image & ":" & Text);
         end Expect;

      begin
         for K in 1 .. 20 loop
            P := Mission_Plans.Random (2, 2 * K - 1, Least => 12);
            P.Wheels.Turn_Speed := Turns;
            P.Wheels.Speed := Drives;
            Simulate (P, R);
            Expect (R.Verdict.Clearance > 0.0, K'Image & " at the border");
            Expect (R.Ended = Why, K'Image & " " & R.Ended'Image);
            if Why = Completed then
               Expect (R.Verdict.Passed = P.Count, K'Image & " not passed");
            else
               Expect (abs (R.Measured - Percent) <= 2,
                       K'Image & R.Measured'Image & " %");
               Expect (R.Verdict.Time <= 6.0,
                       K'Image & " only after" & R.Verdict.Time'Image & " s");
            end if;
         end loop;
      end Check;

   begin
      Check (10, 100, Turns_Amiss, 10);
      Check (100, 5, Drives_Amiss, 5);
      Check (100, 3, Drives_Amiss, 3);
      Check (180, 180, Completed);
   end Test_Far_From_Ideal;

   procedure Test_Completed is
      --  A hundred missions of exact robots and of faulty ones. Those that
      --  take an exact robot less time may take longer than 1.5 times as
      --  long: looking takes time, and learning what the robot does
      P : Mission_Plans.Plan;
      R : Result;
   begin
      for Number in 1 .. 200 loop
         P := Mission_Plans.Random (1 + Number mod 2, Number, Least => 2);
         Simulate (P, R);
         Assert (R.Ended = Completed and then R.Verdict.Wrong = "",
                 P.Faulty'Image & Number'Image & ": " & R.Ended'Image
                 & To_String (R.Verdict.Wrong));
         Assert (R.Verdict.Exact < (if P.Faulty then 9.0 else 3.0)
                 or else Mission_Judges.Is_Good (R.Verdict),
                 P.Faulty'Image & Number'Image & ":" & R.Verdict.Time'Image
                 & " s instead of" & R.Verdict.Exact'Image);
      end loop;
   end Test_Completed;

   procedure Test_Guards is

      function Permitted
        (X, Y, Degrees : Integer;
         Move          : Drive_Length;
         D             : Doubts := (10_000, 0, 0, 0)) return Boolean
      is (Is_Permitted
            (((Micrometres (X) * 1_000, Micrometres (Y) * 1_000),
              Bearing (Degrees) * 1_000_000), Move, D, Size));

      procedure Check_Furthest (Degrees : Integer; Move : Drive_Length) is
         --  From (400, 300), and a millimetre more is too far
      begin
         Assert (Permitted (400, 300, Degrees, Move), "not" & Move'Image);
         Assert (not Permitted
                   (400, 300, Degrees, Move + (if Move < 0 then -1 else 1)),
                 "more than" & Move'Image);
      end Check_Furthest;

   begin
      Assert (Is_Target ((80_000, 520_000), Size), "at the margin");
      Assert (not Is_Target ((79_999, 520_000), Size), "left of it");
      Assert (not Is_Target ((80_000, 520_001), Size), "above it");
      Check_Furthest (0, 330);
      Check_Furthest (0, -330);
      Check_Furthest (-90, 230);
      Assert (Permitted (50, 300, 0, 100), "inward from outside");
      Assert (not Permitted (50, 300, 180, 1), "further out");
      Assert
        (not Permitted (400, 300, 0, 330, (10_100, 0, 0, 0)), "a longer way");
      Assert (not Permitted (200, 75, 0, 300, (10_000, 0, 10_000, 0)),
              "pulled to the border");
      Assert (not Permitted (200, 75, 4, 300, (10_000, -40_000, 0, 0)),
              "in an arc to the border");
      Assert (not Permitted (200, 75, 0, 300, (10_000, 0, 0, 1_500_000)),
              "in a direction not quite known");
      Assert (Permitted (200, 75, 0, 300), "along the border");
   end Test_Guards;

   procedure Test_Slow is
      --  7 mm a second, on the way to a point that is right ahead
      R     : Missions.Runs.Run;
      Next  : Action;
      Now   : Microseconds := 0;
      Image : Natural := 0;
   begin
      Start (R, Size, (1 => (500_000, 300_000), others => Corner), 1, Now);
      loop
         Image := Image + 1;
         See (R,
              (Image, Now, True,
               ((200_000 + Micrometres (7 * Now / 1_000), 300_000), 0)));
         Step (R, Now, Next);
         exit when Has_Ended (R);
         if Next.Kind in Ask | Order then
            Tell (R, Said ((if Next.Kind = Ask then '1' else '0')), Now);
         end if;
         Now := Now + 20_000;
         Assert (Now <= 7_000_000, "goes on");
      end loop;
      Assert (Ended_By (R) = Drives_Amiss, "ended by" & Ended_By (R)'Image);
      Assert (Measured (R) in 3 .. 4, Measured (R)'Image & " %");
   end Test_Slow;

begin
   Run_Test ("angles all around", Test_Angles'Access);
   Run_Test ("what the guards permit", Test_Guards'Access);
   Run_Test ("a hundred missions of exact robots and of faulty ones",
             Test_Completed'Access);
   Run_Test ("robots that do a part of what is asked, or twice as much",
             Test_Far_From_Ideal'Access);
   Run_Test ("a slow robot", Test_Slow'Access);
   Run_Test ("why missions end", Test_Ends'Access);
   Run_Scripts
     (Play'Access,
      --  Two images with the robot, then two without it: in time for
      --  everything, but the robot was seen too long ago
      "no order from an old position: @100_000,100_000,700_000,500_000 stop"
      & " +100 :0 +100 :0 +100 hidden +100 hidden +150 nothing +10 :0 TURN"

      --  The point is about 300 mm away, 3.3 degrees to the left. The first
      --  turn is looked at. The second need not be, but ends while the robot
      --  is hidden
      & "|waits for a new position: @200_000,300_000,499_000,317_500 stop"
      & " +100 :-45 +100 :-45 TURN +250 :-25 +250 asks +100 :-5 +100 :-5 TURN"
      & " +100 hidden +100 hidden +110 asks nothing looks +10 :3 MOVE");
end Mission_Runs_Tests;
