--  SPDX-License-Identifier: GPL-3.0-or-later
--  A fault, an abort or an exit in a library, such as OpenCV or FFmpeg, which
--  share the process with the tasks: the robot is stopped first.

with Process;

package Crashes with SPARK_Mode is

   procedure Catch with Global => (In_Out => Process.System_State);
   --  From now on such an end writes a stop on the robot's line, if it is
   --  open, and nothing goes there after it; then the process dies of the
   --  signal, or after an exit with status 3.
   --
   --  A fault in the program's own code becomes an exception of its task, as
   --  it does without this (Failures); the stop is written before

end Crashes;
