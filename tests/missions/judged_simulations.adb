--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions in simulated time, judged as the real ones.

with Missions.Texts;
with Robot_Motion;
with Simulated_Missions;

package body Judged_Simulations is

   use type Micro;

   Noise : constant := 2.8;
   --  Millimetres: of the emulator's 2 pixels

   Angle_Noise : constant := 0.5;
   --  Degrees

   procedure Run (P : Plan; V : out Verdict; Traced : Boolean := False) is

      function Seconds (Time : Robot_Motion.Time_Point) return Duration is
        (Duration (Time - Simulated_Missions.Start_Time) / 1_000_000);

      M : Simulated_Missions.Mission :=
        (Start => P.Start, Count => P.Count, others => <>);
      F : Simulated_Missions.Faults := (Wheels => P.Wheels, others => <>);
      R : Simulated_Missions.Result;
      J : Judge;

      procedure See
        (Time   : Robot_Motion.Time_Point;
         Where  : Robot_Motion.Pose;
         Moving : Boolean) is
      begin
         See_Pose (J, Seconds (Time), Where, Moving);
      end See;

      procedure Sight (Time : Robot_Motion.Time_Point) is
      begin
         See_Position (J, Seconds (Time));
      end Sight;

   begin
      for K in 1 .. P.Count loop
         M.Targets (K) :=
           (Missions.Micrometres (P.Points (K).X),
            Missions.Micrometres (P.Points (K).Y));
      end loop;
      if P.Faulty then
         F.Image_Delay := Simulated_Missions.Milliseconds (Camera_Delay);
         F.Place_Noise := Noise;
         F.Heading_Noise := Angle_Noise;
         F.Lose_Every := Drop_Every;
      end if;
      Start (J, P);
      Simulated_Missions.Simulate
        (M, F, P.Number, R, Traced,
         Image => Sight'Access, Place => See'Access);
      Conclude
        (J, P, Missions.Texts.Text_Of (R.Ended), Duration (R.Time) / 1_000,
         R.Orders, V);
   end Run;

end Judged_Simulations;
