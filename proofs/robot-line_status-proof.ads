--  SPDX-License-Identifier: GPL-3.0-or-later
--  The intervals are right whether a reload or its answer was lost.

package Robot.Line_Status.Proof with SPARK_Mode, Ghost is

   --  What the robot does, in milliseconds

   Tick : constant Positive := 100;

   subtype First_Tick is Positive range 1 .. Tick;
   --  From when it has begun to count to its next tick. A whole tick after a
   --  miss, as it begins to count at a tick then

   function Is_Accepted (After : Integer; First : First_Tick) return Boolean is
     (After in First + 8 * Tick .. First + 11 * Tick - 1)
   with Pre => After in 0 .. 10_000;

   function Miss (First : First_Tick) return Positive is (First + 11 * Tick);

   procedure Prove_Windows (First : First_Tick)
   with
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

end Robot.Line_Status.Proof;
