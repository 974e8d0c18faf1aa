--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision, one at a time in the order of the commands,
--  though two tasks share the work.

with Orders;

package Vision.Queue with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Queue);
   --  A claim that GNATprove checks: every subprogram ends

   procedure Put (Item : in out Orders.Order)
   with
     Pre => Item.Owed;
   --  Item stays the caller's (Owed) where it may be carried out at once;
   --  else it waits its turn here

   procedure Next (Item : out Orders.Order);
   --  An order has been carried out: the next one, Owed, if there is one

   procedure Clear;
   --  Forget the orders that wait: their session has ended

end Vision.Queue;
