--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision, carried out one at a time in the order of the
--  commands by two tasks.

with Orders;

package Vision.Queue with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Queue);

   procedure Put (Item : in out Orders.Order)
   with
     Pre => Item.Owed;
   --  If Item may be carried out at once, it stays with the caller (Owed);
   --  otherwise it is queued here

   procedure Next (Item : out Orders.Order);
   --  An order has been carried out: the next one, Owed, if any

   procedure Clear;
   --  Removes the waiting orders: their session has ended

end Vision.Queue;
