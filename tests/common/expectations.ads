--  SPDX-License-Identifier: GPL-3.0-or-later
--  Expectations of a test, independent of the test framework: the benchmark
--  uses the same harness.

package Expectations is

   Failed : exception;
   --  An expectation was not met; the message says what was observed

   Too_Late : exception;
   --  One of time alone was not met: a test that measures is repeated for it

   Skipped : exception;
   --  The machine does not allow this test; the message says why

   Patience : constant Duration := 30.0;
   --  For whatever must come: waited for in full only where it does not

   procedure Check (Condition : Boolean; Message : String);
   --  Raises Failed with Message unless Condition

   procedure Check_Within (Taken : Duration; Limit : Duration; What : String);
   --  Raises Too_Late unless Taken <= Limit, and what the machine itself takes

   procedure Check_In_Time (Condition : Boolean; Message : String);
   --  The same unless Condition, which is one of time

   Own_Time : Duration := 0.0;
   --  What the machine itself takes

   Ignore_Times : Boolean := False;
   --  The two before only note what they saw

   procedure Skip (Reason : String) with No_Return;

   procedure Note (Text : String);
   --  Adds a figure to the report of the run

end Expectations;
