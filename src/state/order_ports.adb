--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event-data port of one task: a bounded queue of orders, first in
--  first out, with the task waiting at its end.

package body Order_Ports with SPARK_Mode is

   protected body Port is

      procedure Put (Item : Orders.Order) is
      begin
         if Count < Orders.Capacity then
            Items ((First - 1 + Count) mod Orders.Capacity + 1) := Item;
            Count := Count + 1;
            Any := True;
         end if;
      end Put;

      procedure Clear is
      begin
         Count := 0;
         Any := False;
      end Clear;

      entry Take (Item : out Orders.Order) when Any is
      begin
         Item := Items (First);
         First := First mod Orders.Capacity + 1;
         if Count > 0 then
            Count := Count - 1;
         end if;
         Any := Count > 0;
      end Take;

   end Port;

   ---------
   -- Put --
   ---------

   procedure Put (Item : Orders.Order) is
   begin
      Port.Put (Item);
   end Put;

   ----------
   -- Wait --
   ----------

   procedure Wait (Item : out Orders.Order) is
   begin
      Port.Take (Item);
   end Wait;

   -----------
   -- Clear --
   -----------

   procedure Clear is
   begin
      Port.Clear;
   end Clear;

end Order_Ports;
