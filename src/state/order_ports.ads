--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event-data port of a task: a bounded FIFO queue of orders, from which
--  the task takes them.

with Order_Queues;
with Orders;
with Schedule;

generic
   Who : Schedule.Task_Name;
   --  the task that owns the port
package Order_Ports with SPARK_Mode is

   procedure Put (Item : in out Orders.Order)
   with
     Pre  => Item.Owed,
     Post => not Item.Owed,
     Annotate => (GNATprove, Terminating);
   --  An order for the task. There is always room: no more orders are in
   --  progress than the port holds

   procedure Wait (Item : in out Orders.Order)
   with
     Pre  => not Item.Owed,
     Post => Item.Owed;
   --  The next order; waits for it. For the owner of the port only: its job
   --  lasts until the next call

   procedure Clear with Annotate => (GNATprove, Terminating);
   --  Removes the waiting orders: their session has ended

private

   protected Port with Priority => Schedule.Order_Ceiling is
      procedure Put (Item : Orders.Order);
      procedure Clear;
      procedure Take
        (Item  : out Orders.Order;
         Found : out Boolean;
         More  : out Boolean);
   private
      Waiting : Order_Queues.Queue;
   end Port;

end Order_Ports;
