--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark was asked for.

package Bench_Settings is

   Sample_Count : Positive := 2_000;
   --  of each distribution

   Seconds : Positive := 60;
   --  of each measurement that lasts

end Bench_Settings;
