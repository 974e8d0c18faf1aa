--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, step by step as the session's
--  logic says. For the owner of the line only.

with Robot_Session;

package Line_Exchange with SPARK_Mode is

   procedure Carry_Out
     (State   : in out Robot_Session.State;
      Request : Robot_Session.Request;
      Result  : out Robot_Session.Outcome)
   with
     Pre  => Robot_Session.Is_Consistent (State),
     Post => Robot_Session.Is_Consistent (State);
   --  Comes to an end: a request has Robot_Session.Max_Steps steps at most,
   --  and none of them waits for longer than the answer's time-out

end Line_Exchange;
