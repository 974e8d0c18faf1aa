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

end Robot.Reload_Times;
