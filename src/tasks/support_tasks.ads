--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks that are not in the design report: the console, and the end of
--  the process, in order or after a failure.

with Schedule;

package Support_Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Console with Priority => Schedule.Console_Priority;
   --  Writes the log

   task Th_Stop with Priority => Schedule.Stop_Priority;
   --  Waits for the signal that ends the process: an orderly stop (exit 0), or
   --  the failure of a task (stop order, exit 3)

   procedure Finish_Trace;
   --  Writes the file of --trace, if any, and logs if it is incomplete. The
   --  last call before the process ends

end Support_Tasks;
