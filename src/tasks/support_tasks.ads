--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks that are not in the design report: the console, and the end of
--  the process, in order or after a failure.

with Event;
with Schedule;

package Support_Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Console with Priority => Schedule.Console_Priority;
   --  Writes the log

   task Th_Stop with Priority => Schedule.Stop_Priority;
   --  Waits for the signal that ends the process: an orderly stop (exit 0), or
   --  the failure of a task (stop order, exit 3)

   package Stop_Failed is new Event (Schedule.Main);
   --  Th_Stop has failed itself: the main procedure, which waits for it, must
   --  end the process

   procedure React (Line : String; Of_Stop : Boolean);
   --  For the handler of Failures, when a task has ended, as none may: puts
   --  Line into the log and tells Th_Stop. If it was that one (Of_Stop), the
   --  robot is stopped here, and the main procedure is told

   procedure Finish_Trace;
   --  Writes the file of --trace, if any, and logs if it is incomplete. The
   --  last call before the process ends

end Support_Tasks;
