--  SPDX-License-Identifier: GPL-3.0-or-later
--  A client of the robot's line: makes a request and waits for its outcome.

with Orders;
with Robot.Line_Status;
with Robot.Requests;
with Robot.Session;
with Schedule;

generic
   Who      : Robot.Requests.Single;
   Its_Task : Schedule.Task_Name;
package Robot.Line.Clients with SPARK_Mode is

   procedure Ask (Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed;
   --  Has the monitor's order carried out on the robot's line, and answered.
   --  For one task only

   procedure Ask
     (Request : Robot.Session.Request; Result : out Robot.Session.Outcome);
   --  The same for a request of the task itself

   procedure Ask
     (Run     : Robot.Line_Status.Status;
      Request : Robot.Session.Request;
      Result  : out Robot.Session.Outcome);
   --  The same, unless the run of the robot that Run is of has ended: then no
   --  request is made, and the result is Not_Open

   procedure Ask_For_Mission
     (Request : Robot.Session.Request;
      Order   : Orders.Order;
      Result  : out Robot.Session.Outcome)
   with Pre => not Order.Owed;
   --  The same for the mission that Order has asked for. Refused without an
   --  exchange where its session has ended or an order by hand has ended the
   --  mission; Timed_Out where it has waited too long

   procedure Signal with Annotate => (GNATprove, Terminating);
   --  The request has been carried out

end Robot.Line.Clients;
