--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requirements of the checks, and the margins added: several worlds share
--  the processors, and neither load nor harness is under test.

package Tolerances is

   --  Requirements

   Stop_Limit : constant Duration := 0.2;
   --  The robot is stopped this long after the loss of command

   Loss_Limit : constant Duration := 0.05;
   --  F5: time to detect a close or a reset

   Vanished_Limit : constant Duration := 5.0;
   --  F5: time to detect a vanished monitor

   Silence_Limit : constant Duration := 0.9;
   --  Time to detect that announced signs of life do not come

   Stalled_Limit : constant Duration := 15.0;
   --  A monitor that accepts nothing is lost after this time

   Return_Limit : constant Duration := 1.0;
   --  F6: time from the detected loss to the admission of a new monitor

   Watchdog_Limit : constant Duration := 3.6;
   --  A robot with watchdog is stopped this long after the last reload

   Newcomer_Time : constant Duration := 0.0012;
   --  The supervisor serves ten pending connections in ten times this

   --  Margins

   Noise : constant Duration := 0.5;
   --  On all times above: a dozen worlds on two processors

   Answer_Limit : constant Duration := 20.0;
   --  For all answers of a session: as many exchanges as may wait, some with
   --  time-outs, and a camera that is slow to open

   Busy_Limit : constant Duration := 5.0;
   --  The same on busy processors, without any other fault

   Line_Attempts : constant := 5;
   --  For starting and moving the robot: on a loaded machine an answer of the
   --  emulated one sometimes misses its 80 ms. Violations that depend only on
   --  such an answer are tested again so often, if its line was late.

   Host_Grant : constant Duration := 0.1;
   --  Of processor time stolen by the host of a virtual machine during an
   --  injection (Host_Time). Above that, violations of time limits only are
   --  tested again, as no program can meet them. Double answers, leaks and
   --  crashes always count.

   Host_Attempts : constant := 12;
   --  Number of attempts

   Line_Pause : constant Duration := 0.2;
   --  Between two attempts, so that late answers arrive

   Settle_Limit : constant Duration := 5.0;
   --  Time after a session until descriptors and threads are as before

   Memory_Growth : constant Natural := 24 * 1024;
   --  Kilobytes above those after the supervisor's first session with a
   --  camera: memory pools of OpenCV and the C library grow in the first
   --  sessions. The limit for hundreds of injections into the same supervisor.

end Tolerances;
