--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, step by step as the session's
--  logic says. For the owner of the line only.

with Robot_Session;

package Line_Exchange with SPARK_Mode is

   procedure Carry_Out
     (State   : in out Robot_Session.State;
      Request : Robot_Session.Request;
      Result  : out Robot_Session.Outcome);

end Line_Exchange;
