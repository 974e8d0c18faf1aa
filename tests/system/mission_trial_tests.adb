--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random missions, judged.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Expectations;          use Expectations;
with Mission_Judges;        use Mission_Judges;
with Mission_Plans;         use Mission_Plans;
with Plain_Numbers;         use Plain_Numbers;
with Real_Missions;
with Scenarios;             use Scenarios;

package body Mission_Trial_Tests is

   Seed : constant := 1;
   --  The same missions each time, some of script/bench missions: those that
   --  take the least time of the first thirty

   procedure Try (Number : Positive) is
      --  Raises Failed unless it is done and reaches the goals
      V : Verdict;
   begin
      Real_Missions.Run (Random (Seed, Number), V);
      Note
        ("mission " & Image (Number) & ": " & Rounded (Float (V.Pass), 1)
         & " mm from a point at most, "
         & Rounded (Float (Ratio (V))) & " times an exact robot's time, "
         & Rounded (Float (V.Blind) * 1_000.0, 0)
         & " ms without a new position");
      Check
        (V.Wrong = "",
         "mission " & Image (Number) & ": " & To_String (V.Wrong));
      Check
        (V.Done,
         "mission " & Image (Number) & " is aborted: "
         & To_String (V.Reason));
      --  the goal of script/bench missions, and a margin for a machine that
      --  does other things, too
      Check
        (Ratio (V) <= 1.5 * Slowest,
         "mission " & Image (Number) & " takes "
         & Rounded (Float (Ratio (V))) & " times an exact robot's time");
   end Try;

   procedure Ideal is
   begin
      Try (1);
      Try (3);
   end Ideal;

   procedure With_Faults is
   begin
      Try (18);
      Try (30);
   end With_Faults;

   procedure Register is
   begin
      Add ("Mission_Trial_Ideal", Ideal'Access, Timed => True);
      Add ("Mission_Trial_With_Faults", With_Faults'Access, Timed => True);
   end Register;

end Mission_Trial_Tests;
