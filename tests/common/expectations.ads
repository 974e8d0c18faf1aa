--  SPDX-License-Identifier: GPL-3.0-or-later
--  Expectations of a test, independent of the test framework: the benchmark
--  uses the same harness.

package Expectations is

   Failed : exception;
   --  An expectation was not met; the message says what was observed

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
   --  The test measures time: raises Skipped if such tests are skipped. Called
   --  by Measure_Calmly, and by tests that compare a time with a goal without
   --  it.

   procedure Measure_Calmly (Measure : not null access procedure);
   --  Runs Measure; repeats it on failure, three times at most. The last
   --  failure is raised, the others are logged. For times and periods only: a
   --  permanent defect is found, a rare one may be missed.

   procedure Limit_Time (Span : Duration);
   --  From now on Check_Time raises Failed once Span has passed

   procedure Check_Time;
   --  For operations that may wait repeatedly; no effect without Limit_Time

   procedure Skip (Reason : String) with No_Return;

   procedure Note (Text : String);
   --  Adds a figure to the report of the run

end Expectations;
