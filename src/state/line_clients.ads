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

   procedure Ask
     (Request : Robot_Session.Request;
      Order   : Orders.Order;
      Result  : out Robot_Session.Outcome);
   --  Has Request carried out on the robot's line. For one task only

   procedure Ask (Request : Robot_Session.Request);
   --  The same for a request of its own, where it makes no difference what
   --  comes of it

   procedure Signal with Annotate => (GNATprove, Terminating);
   --  The request has been carried out

end Line_Clients;
