--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a task does that may take the robot's line.

with Commands;
with Schedule;

package Robot.Service with SPARK_Mode is

   procedure Serve
     (Who    : Schedule.Task_Name;
      Result : out Commands.Outcome;
      Found  : out Boolean);
   --  Takes the line, carries out the request and gives the line back; answers
   --  the monitor's order, if it is one. Not Found: it is the turn of another

   procedure Serve (Who : Schedule.Task_Name);
   --  The same, for tasks that need no result

end Robot.Service;
