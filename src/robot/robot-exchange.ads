--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, by the steps of Robot.Session.
--  For the task that has the line.

with Commands;
with Robot.Line_Status;
with Schedule;

private package Robot.Exchange with SPARK_Mode is

   procedure Carry_Out
     (Who     : Schedule.Task_Name;
      Held    : in out Line_Status.Dialogue;
      Request : Commands.Request;
      Result  : out Commands.Outcome);
   --  To open an open line asks whether the robot answers. Terminates: a
   --  request has at most Robot.Session.Max_Steps steps, and none waits longer
   --  than the answer's time-out

end Robot.Exchange;
