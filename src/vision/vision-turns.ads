--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision, carried out one at a time in the order of the
--  commands by two tasks.

with Commands;

package Vision.Turns with SPARK_Mode is

   procedure Put (Order : in out Commands.Order)
   with
     Pre  => Order.Owed and then Order.Command.Name in Commands.Vision_Command,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  For the task of Commands.Table. There is always room: no more orders are
   --  in progress than wait here

   procedure Wait_Camera_Control (Order : in out Commands.Order)
   with
     Pre  => not Order.Owed,
     Post => Order.Owed;
   --  The next order for th_cameraControl; waits for its turn

   procedure Wait_Arena (Order : in out Commands.Order)
   with
     Pre  => not Order.Owed,
     Post => Order.Owed;
   --  The same for th_arene

   procedure Finish with Annotate => (GNATprove, Terminating);
   --  The order has been carried out: the next one may start

   procedure Clear with Annotate => (GNATprove, Terminating);
   --  Removes the waiting orders: their session has ended

end Vision.Turns;
