--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, step by step as the session's
--  logic says. For the owner of the line only.

with Robot.Session;

private package Robot.Exchange with SPARK_Mode is

   procedure Carry_Out
     (State   : in out Robot.Session.State;
      Request : Robot.Session.Request;
      Result  : out Robot.Session.Outcome)
   with
     Pre  => Robot.Session.Is_Consistent (State),
     Post => Robot.Session.Is_Consistent (State);
   --  Comes to an end: a request has Robot.Session.Max_Steps steps at most,
   --  and none of them waits for longer than the answer's time-out

end Robot.Exchange;
