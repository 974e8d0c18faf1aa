--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, by the steps of Robot.Session.
--  For the owner of the line only.

with Ada.Real_Time;
with Robot.Session;

private package Robot.Exchange with SPARK_Mode is

   procedure Carry_Out
     (State   : in out Robot.Session.State;
      Request : Robot.Session.Request;
      Result  : out Robot.Session.Outcome;
      Counted : in out Ada.Real_Time.Time)
   with
     Pre  => Robot.Session.Is_Consistent (State),
     Post => Robot.Session.Is_Consistent (State);
   --  Counted: when the last start or reload was sent. To open an open line
   --  asks whether the robot answers. Terminates: a request has at most
   --  Robot.Session.Max_Steps steps, and none waits longer than the answer's
   --  time-out

end Robot.Exchange;
