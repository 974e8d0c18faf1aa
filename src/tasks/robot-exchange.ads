--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, by the steps of Robot.Session.
--  For the owner of the line only.

with Robot.Line_Status;
with Robot.Session;

private package Robot.Exchange with SPARK_Mode is

   procedure Carry_Out
     (Held    : in out Robot.Line_Status.Dialogue;
      Request : Robot.Session.Request;
      Result  : out Robot.Session.Outcome);
   --  To open an open line asks whether the robot answers. Terminates: a
   --  request has at most Robot.Session.Max_Steps steps, and none waits longer
   --  than the answer's time-out

end Robot.Exchange;
