--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision, one at a time in the order of the commands,
--  though two tasks share the work.

with Schedule;

package body Vision_Queue with SPARK_Mode is

   type Order_Array is array (1 .. Orders.Capacity) of Orders.Order;

   protected Queue with Priority => Schedule.Order_Ceiling is
      procedure Put (Item : Orders.Order; Now : out Boolean);
      procedure Next (Item : out Orders.Order; Found : out Boolean);
      procedure Clear;
   private
      Items : Order_Array;
      First : Positive range 1 .. Orders.Capacity := 1;
      Count : Orders.Order_Count := 0;
      Busy  : Boolean := False;  --  an order is being carried out
   end Queue;

   protected body Queue is

      procedure Put (Item : Orders.Order; Now : out Boolean) is
      begin
         Now := not Busy;
         if not Busy then
            Busy := True;
         elsif Count < Orders.Capacity then
            Items ((First - 1 + Count) mod Orders.Capacity + 1) := Item;
            Count := Count + 1;
         end if;
      end Put;

      procedure Next (Item : out Orders.Order; Found : out Boolean) is
      begin
         Item := Items (First);
         Found := Count > 0;
         if Count > 0 then
            First := First mod Orders.Capacity + 1;
            Count := Count - 1;
         else
            Busy := False;
         end if;
      end Next;

      procedure Clear is
      begin
         Count := 0;
      end Clear;

   end Queue;

   ---------
   -- Put --
   ---------

   procedure Put (Item : Orders.Order; Now : out Boolean) is
   begin
      Queue.Put (Item, Now);
   end Put;

   ----------
   -- Next --
   ----------

   procedure Next (Item : out Orders.Order; Found : out Boolean) is
   begin
      Queue.Next (Item, Found);
   end Next;

   -----------
   -- Clear --
   -----------

   procedure Clear is
   begin
      Queue.Clear;
   end Clear;

end Vision_Queue;
