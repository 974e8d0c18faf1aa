--  SPDX-License-Identifier: GPL-3.0-or-later
--  The figures of F4, F11, F12, F13 and F15 under full load: images with
--  positions, 30 commands a second, two busy loops.

package Full_Load is

   procedure Report;
   --  Once with the robot's line at 9600 baud, and once unpaced, to show the
   --  supervisor's own part of F12

   procedure Report_Tasks;
   --  The processor time of each task, compared with its budget in the
   --  deadline analysis

end Full_Load;
