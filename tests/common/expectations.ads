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

   procedure Check_In_Time (Condition : Boolean; Message : String);
   --  The same where time has run out unless Condition

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String);
   --  Raises Failed unless Taken <= Limit

   function Time_Ran_Out return Boolean;
   --  Whether Failed was last raised for a limit of time

   procedure Leave_Out_Measurements;
   --  From now on tests that measure time are skipped

   procedure Measures_Time;
   --  Raises Skipped if such tests are skipped

   procedure Limit_Time (Span : Duration);
   --  From now on Check_Time raises Failed once Span has passed

   procedure Check_Time;
   --  For operations that may wait repeatedly; no effect without Limit_Time

   procedure Skip (Reason : String) with No_Return;

   procedure Note (Text : String);
   --  Adds a figure to the report of the run

end Expectations;
