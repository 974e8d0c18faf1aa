--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects, independent of the framework that runs it: the
--  benchmark uses the same harness.

package Expectations is

   Failed : exception;
   --  What was expected did not happen; the message says what was seen

   Skipped : exception;
   --  The machine does not allow this test; the message says why

   procedure Check (Condition : Boolean; Message : String);
   --  Raises Failed with Message unless Condition

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String);
   --  Raises Failed unless Taken <= Limit

   procedure Check_Timing (Condition : Boolean; Message : String);
   --  The same as Check, of something that only a time decides

   procedure Measure_Calmly (Measure : not null access procedure);
   --  Measure, and if what it expects fails, again: a virtual machine's host
   --  that takes its processors away for half a second does so once, a defect
   --  comes each time. Three times, and up to six where the host took 0.1 s
   --  or more of processor time meanwhile (Host_Time). The last failure is
   --  raised, the others are noted; but where the host took as much in that
   --  one, too, and what failed is Check_Within or Check_Timing, it is only
   --  noted that it cannot be judged here.

   procedure Skip (Reason : String) with No_Return;

   procedure Note (Text : String);
   --  A figure worth reading in the report of the run

end Expectations;
