--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark was asked for.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Bench_Settings is

   Sample_Count : Positive := 2_000;
   --  of each distribution

   Seconds : Positive := 60;
   --  of each measurement that lasts

   function Short_Seconds return Positive is (Integer'Min (Seconds, 120));
   --  of one that keeps too much for hours

   As_Service : Boolean := False;
   --  the supervisor runs as its unit runs it, in the sections that can

   Trace_File : Unbounded_String;
   --  whose responses are asked for, "" for some that are made

   Folder : Unbounded_String := To_Unbounded_String ("/tmp");
   --  where these are left

end Bench_Settings;
