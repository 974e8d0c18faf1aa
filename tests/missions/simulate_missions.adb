--  SPDX-License-Identifier: GPL-3.0-or-later
--  Simulates missions: bin/simulate_missions MISSIONS FIRST LAST KIND [SEED
--  [K]]. Through FIRST to LAST points each, as many of each count, by robots
--  that are ideal, have faults, see late (150 ms, of these faults) or are
--  changing (their speeds, by 10 percent at each order, of these faults). K:
--  prints what happens in that one.

with Ada.Command_Line;       use Ada.Command_Line;
with Ada.Text_IO;            use Ada.Text_IO;

with GNAT.Random_Numbers;    use GNAT.Random_Numbers;

with Missions;               use Missions;
with Simulated_Missions;     use Simulated_Missions;

procedure Simulate_Missions is

   Number : constant Positive := Positive'Value (Argument (1));
   First  : constant Point_Number := Point_Number'Value (Argument (2));
   Last   : constant Point_Number := Point_Number'Value (Argument (3));
   Kind   : constant String := Argument (4);
   Seed   : constant Natural :=
     (if Argument_Count > 4 then Natural'Value (Argument (5)) else 1);

   procedure Prepare (K : Natural; M : out Mission; F : out Faults) is
      Source : Generator;
   begin
      Reset (Source, Seed * 1_000_000 + K);
      Make_Mission (Source, First + K mod (Last - First + 1), M);
      F := Ideal;
      if Kind /= "ideal" then
         Make_Faults (Source, F);
         if Kind = "late" then
            F.Image_Delay := 150.0;
         elsif Kind = "changing" then
            F.Changing := 10;
         end if;
      end if;
   end Prepare;

   M      : Mission;
   F      : Faults;
   R      : Result;
   Bad    : Natural := 0;
   Slow   : Natural := 0;
   Far    : Natural := 0;
   Sum    : Float := 0.0;
   Pass   : Millimetres := 0.0;
   Room   : Millimetres := 1_000.0;
   Blind  : Milliseconds := 0.0;
   Worst  : Float := 0.0;
   Orders : Natural := 0;
   Points : Natural := 0;
   Extra  : Float := 0.0;
begin
   if Argument_Count > 5 then
      Prepare (Natural'Value (Argument (6)), M, F);
      Put_Line
        ("speed" & F.Wheels.Speed'Image & " turns" & F.Wheels.Turn_Speed'Image
         & " overshoot" & F.Wheels.Overshoot'Image
         & " pull" & F.Wheels.Pull'Image & " late" & F.Image_Delay'Image);
      for P of M.Targets (1 .. M.Count) loop
         Put_Line ("to" & Micrometres'Image (P.X / 1_000)
                   & Micrometres'Image (P.Y / 1_000));
      end loop;
      Simulate (M, F, Seed, R, True);
      Put_Line ("ratio" & Ratio (R)'Image & " pass" & R.Worst_Pass'Image);
      return;
   end if;

   for K in 1 .. Number loop
      Prepare (K, M, F);
      Simulate (M, F, Seed, R);
      if R.Ended /= Completed then
         Bad := Bad + 1;
         Put_Line (K'Image & ": " & R.Ended'Image);
      end if;
      if R.Worst_Pass > 15.0 then
         Far := Far + 1;
         Put_Line (K'Image & ": pass" & R.Worst_Pass'Image);
      end if;
      if Ratio (R) > 1.5 then
         Slow := Slow + 1;
         if Slow < 1_000 then
            Put_Line
              (K'Image & ":" & M.Count'Image & " points, ratio"
               & Ratio (R)'Image & ", exact" & R.Exact'Image);
         end if;
      end if;
      if R.Room <= 0.0 then
         Put_Line (K'Image & ": at the wall");
      end if;
      Sum    := Sum + Ratio (R);
      Pass   := Millimetres'Max (Pass, R.Worst_Pass);
      Room   := Millimetres'Min (Room, R.Room);
      Blind  := Milliseconds'Max (Blind, R.Blind);
      Worst  := Float'Max (Worst, Ratio (R));
      Orders := Orders + R.Orders;
      Points := Points + M.Count;
      Extra  := Extra + Float (R.Time) - Float (R.Exact);
   end loop;
   Put_Line
     (Kind & First'Image & " .." & Last'Image & ":" & Number'Image
      & " missions, not completed" & Bad'Image & ", slow" & Slow'Image
      & ", far" & Far'Image
      & ", mean ratio" & Float'Image (Sum / Float (Number))
      & ", worst" & Worst'Image & ", pass" & Pass'Image
      & ", room" & Room'Image & ", blind" & Blind'Image
      & ", orders a leg" & Float'Image (Float (Orders) / Float (Points))
      & ", extra ms a leg" & Float'Image (Extra / Float (Points)));
end Simulate_Missions;
