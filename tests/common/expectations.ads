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

   procedure Leave_Out_Measurements;
   --  From now on tests that measure time are skipped

   procedure Measures_Time;
   --  Says that the test measures time: raises Skipped where such tests are
   --  left out. Measure_Calmly calls it, and a test that holds a time against
   --  a goal without Measure_Calmly.

   procedure Measure_Calmly (Measure : not null access procedure);
   --  Measure, and if what it expects fails, again, three times at most. The
   --  last failure is raised, the others are noted. For times and periods
   --  only: a defect that comes each time is found, one that comes seldom may
   --  not be.

   procedure Limit_Time (Span : Duration);
   --  From now on Check_Time raises Failed when Span has passed

   procedure Check_Time;
   --  For what may wait again and again; nothing without Limit_Time

   procedure Skip (Reason : String) with No_Return;

   procedure Note (Text : String);
   --  A figure worth reading in the report of the run

end Expectations;
