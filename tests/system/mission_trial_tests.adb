--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random missions, judged.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Expectations;          use Expectations;
with Mission_Judges;        use Mission_Judges;
with Mission_Plans;         use Mission_Plans;
with Plain_Numbers;         use Plain_Numbers;
with Real_Missions;
with Scenarios;             use Scenarios;

procedure Mission_Trial_Tests is

   Seed : constant := 1;
   --  The same missions each time, some of script/bench missions: those that
   --  take the least time of the first thirty

   procedure Try (Number : Positive; Radio : Boolean := False) is
      --  Raises Failed unless it is done and reaches the goals, at once or in
      --  two of three runs: an image that a busy machine delays aborts it
      Name    : constant String := "mission " & Image (Number);
      Done    : Natural := 0;
      Aborted : Natural := 0;
      P       : Plan := Random (Seed, Number);
      V       : Verdict;
   begin
      P.Radio := Radio;
      loop
         Real_Missions.Run (P, V);
         Note (Name & ": " & Rounded (Float (V.Pass), 1)
               & " mm from a point at most, "
               & Rounded (Float (Ratio (V))) & " times an exact robot's time, "
               & Rounded (Float (V.Blind) * 1_000.0, 0)
               & " ms without a new position " & To_String (V.Reason));
         Check (V.Wrong = "", Name & ": " & To_String (V.Wrong));
         --  the goal of script/bench missions, and a margin for a machine that
         --  does other things, too
         Check_In_Time (not V.Done or else Ratio (V) <= 1.5 * Slowest,
                        Name & " takes " & Rounded (Float (Ratio (V)))
                        & " times an exact robot's time");
         Done := Done + Boolean'Pos (V.Done);
         Aborted := Aborted + Boolean'Pos (not V.Done);
         Check_In_Time
           (Aborted < 2, Name & " is aborted: " & To_String (V.Reason));
         exit when Done > Aborted;
      end loop;
   end Try;

   generic
      First, Second : Positive;
      By_Radio      : Boolean := False;
   procedure Try_Both;

   procedure Try_Both is
   begin
      Try (First, By_Radio);
      Try (Second, By_Radio);
   end Try_Both;

   procedure Ideal is new Try_Both (1, 3);
   procedure By_Radio is new Try_Both (1, 18, By_Radio => True);
   procedure With_Faults is new Try_Both (18, 30);

begin
   Add ("Mission_Trial_Ideal", Ideal'Access, Timed => True);
   Add ("Mission_Trial_By_Radio", By_Radio'Access, Timed => True);
   Add ("Mission_Trial_With_Faults", With_Faults'Access, Timed => True);
end Mission_Trial_Tests;
