--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long after a reload of the watchdog the next is due. The robot counts
--  ticks of 100 ms, accepts a reload at 9 to 11 of them, and counts anew at
--  the 12th, a miss, or after a reload. If a reload has no answer, either it
--  or its answer was lost: the next must be right in both cases.

with Schedule;

package Robot.Reload_Times with SPARK_Mode is

   subtype Unanswered_Count is Natural range 0 .. 2;
   --  Reloads without an answer in a row; 2: or more

   function Interval_After (Unanswered : Unanswered_Count) return Positive is
     (case Unanswered is
         when 0 => Schedule.Reload_Ms,
         when 1 => Schedule.First_Retry_Ms,
         when 2 => Schedule.Next_Retry_Ms);
   --  Milliseconds from this reload to the next

private

   --  What the robot does, in milliseconds

   Tick : constant Positive := 100 with Ghost;

   subtype First_Tick is Positive range 1 .. Tick with Ghost;
   --  From when it has begun to count to its next tick. A whole tick after a
   --  miss, as it begins to count at a tick then

   function Is_Accepted (After : Integer; First : First_Tick) return Boolean is
     (After in First + 8 * Tick .. First + 11 * Tick - 1)
   with Ghost, Pre => After in 0 .. 10_000;

   function Miss (First : First_Tick) return Positive is (First + 11 * Tick)
   with Ghost;

   procedure Prove_Windows (First : First_Tick)
   with
     Ghost,
     Post =>
       Is_Accepted (Interval_After (0), First)
       --  an answer was lost
       and then Is_Accepted (Interval_After (1), First)
       --  a reload was lost
       and then Is_Accepted
         (Interval_After (0) + Interval_After (1) - Miss (First), Tick)
       --  two in a row were lost
       and then Is_Accepted
         (Interval_After (0) + Interval_After (1) + Interval_After (2)
          - Miss (First) - Miss (Tick), Tick);
   --  First: from an accepted reload. So one lost frame costs one miss at
   --  most, and two lost reloads in a row cost two of the three

end Robot.Reload_Times;
