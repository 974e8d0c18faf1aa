--  SPDX-License-Identifier: GPL-3.0-or-later
--  One client of the robot's line: asks, and waits for what comes of it.

with Line_Requests;
with Orders;
with Robot_Session;
with Schedule;

generic
   Who      : Line_Requests.Single;
   Its_Task : Schedule.Task_Name;
package Line_Clients with SPARK_Mode is

   procedure Ask (Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed;
   --  Has the monitor's order carried out on the robot's line, and answered.
   --  For one task only

   procedure Ask
     (Request : Robot_Session.Request; Result : out Robot_Session.Outcome);
   --  The same for a request of its own

   procedure Signal with Annotate => (GNATprove, Terminating);
   --  The request has been carried out

end Line_Clients;
