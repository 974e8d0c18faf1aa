--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions in simulated time, judged as the real ones: the supervisor's run
--  drives the emulator's robot over a line at 9600 baud, and sees it by a
--  camera of 10 images a second.

with Mission_Judges; use Mission_Judges;
with Mission_Plans;  use Mission_Plans;
with Missions;

package Simulated_Missions is

   type Result is record
      Ended    : Missions.Ending  := Missions.No_Way;
      Measured : Missions.Percent := 0;
      Verdict  : Mission_Judges.Verdict;
   end record;

   procedure Simulate
     (P        : Plan;
      R        : out Result;
      Changing : Natural := 0)
     with Pre => P.Count > 0 and then Changing <= 30;
   --  Changing: percent by which the speeds change from order to order, either
   --  way

end Simulated_Missions;
