--  SPDX-License-Identifier: GPL-3.0-or-later
--  The handlers for the end of any task, which the run time calls, and for a
--  fault, an abort or an exit in a library, such as OpenCV or FFmpeg, which
--  share the process with the tasks.

with Process;

package Failures with SPARK_Mode is

   pragma Elaborate_Body;
   --  The elaboration sets the handler for all tasks, before any runs

   procedure Catch_Crashes with Global => (In_Out => Process.System_State);
   --  From now on a crash of a library writes a stop on the robot's line, if
   --  it is open, and nothing goes there after it; then the process dies of
   --  the signal, or after an exit with status 3.
   --
   --  A fault in the program's own code becomes an exception of its task, as
   --  it does without this; the stop is written before

end Failures;
