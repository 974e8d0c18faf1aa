--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks beside the report's: the console, and the end of the process,
--  orderly or after a failure.

with Schedule;

package Support_Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Console with Priority => Schedule.Console_Priority;
   --  Writes the log

   task Th_Stop with Priority => Schedule.Stop_Priority;
   --  Waits for the signal that ends the process: an orderly stop (exit 0),
   --  or a task that has failed (stop order, exit 3)

   procedure Finish_Trace;
   --  Writes the file of --trace, where there is one, and says in the log
   --  where it is not complete. The last thing before the process ends

end Support_Tasks;
