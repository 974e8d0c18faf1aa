--  SPDX-License-Identifier: GPL-3.0-or-later
--  One client of the robot's line: asks, and waits for what comes of it.

with Orders;
with Robot_Line;
with Robot_Session;

generic
   Who : Robot_Line.Client;
package Line_Clients with SPARK_Mode is

   procedure Ask
     (Request : Robot_Session.Request;
      Order   : Orders.Order;
      Result  : out Robot_Session.Outcome);
   --  Has Request carried out on the robot's line. For one task only

   procedure Signal;
   --  The request has been carried out

end Line_Clients;
