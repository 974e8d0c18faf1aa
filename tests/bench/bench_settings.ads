--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark was asked for.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Bench_Settings is

   Sample_Count : Positive := 2_000;
   --  of each distribution

   Seconds : Positive := 60;
   --  of each measurement that lasts

   Trace_File : Unbounded_String;
   --  whose responses are asked for, "" for one that is made

end Bench_Settings;
