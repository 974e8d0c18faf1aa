--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the checks demand, and what they grant beyond it: several worlds
--  share the processors, and neither the load nor the harness are what the
--  faults are to test.

package Tolerances is

   --  Demanded

   Stop_Limit : constant Duration := 0.2;
   --  The robot stands after nobody is in command for so long

   Loss_Limit : constant Duration := 0.05;
   --  F5: a close and a reset are found

   Vanished_Limit : constant Duration := 5.0;
   --  F5: a monitor that vanished is found

   Stalled_Limit : constant Duration := 15.0;
   --  A monitor that takes nothing is lost after so long

   Return_Limit : constant Duration := 1.0;
   --  F6: a new monitor is admitted after the loss was found

   Watchdog_Limit : constant Duration := 3.6;
   --  A robot with its watchdog on stands, so long after the last reload

   Admission_Limit : constant Duration := 2.0;
   --  Who comes amid a flood from other addresses is seen to

   Newcomer_Time : constant Duration := 0.0012;
   --  The supervisor sees to ten newcomers in ten times that

   Block_Time : constant Duration := 1.0;
   --  Who comes from where a flood came from may have to try again after
   --  that

   --  Granted

   Noise : constant Duration := 0.5;
   --  On every time above: a dozen worlds on two processors

   Answer_Limit : constant Duration := 20.0;
   --  For all answers of a session: as many exchanges as may wait, some of
   --  them with time-outs, and a camera that opens slowly

   Busy_Limit : constant Duration := 5.0;
   --  The same where nothing is wrong but that the processors are busy

   Line_Attempts : constant := 5;
   --  To start and to move the robot: between two programs the kernel's
   --  pseudo-terminal carries the bytes in a thread of ordinary priority,
   --  and on a loaded machine an answer misses its 80 ms now and then

   Late_Line : constant Duration := 0.025;
   --  A pseudo-terminal that takes so long for a byte (Line_Watch) may have
   --  spoilt exchanges that no fault has spoilt. What was violated then only
   --  because of an answer of the robot is looked at again, so often.

   Host_Grant : constant Duration := 0.1;
   --  Of processor time that the host of a virtual machine takes during an
   --  injection (Host_Time). Where it took more, what was violated only
   --  because of a time is looked at again: no program can hold
   --  one then. What was answered twice, leaks or has died has no such
   --  excuse.

   Host_Attempts : constant := 12;
   --  So often at most

   Line_Pause : constant Duration := 0.2;
   --  Between two attempts, for late answers to come in

   Settle_Limit : constant Duration := 5.0;
   --  For descriptors and threads to be what they were, after a session

   Memory_Growth : constant Natural := 24 * 1024;
   --  Kilobytes over those of a supervisor that has had its first session
   --  with a camera: OpenCV's and the C library's pools grow with the first
   --  sessions. Hundreds of injections into the same supervisor may not add
   --  more.

end Tolerances;
