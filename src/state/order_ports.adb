--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Order_Ports with SPARK_Mode is

   package Arrived is new Event;

   protected body Port is

      procedure Put (Item : Orders.Order) is
      begin
         Order_Queues.Put (Waiting, Item);
      end Put;

      procedure Clear is
      begin
         Order_Queues.Clear (Waiting);
      end Clear;

      procedure Take
        (Item  : out Orders.Order;
         Found : out Boolean;
         More  : out Boolean) is
      begin
         Order_Queues.Take (Waiting, Item, Found);
         More := Order_Queues.Length (Waiting) > 0;
      end Take;

   end Port;

   procedure Put (Item : in out Orders.Order) is
   begin
      Item.Owed := False;
      Port.Put (Item);
      Trace.Release (Who, Item.Number);
      Arrived.Set;
   end Put;

   procedure Wait (Item : in out Orders.Order) is
      Found : Boolean;
      More  : Boolean;
   begin
      Trace.Done (Who);
      loop
         Arrived.Wait;
         Port.Take (Item, Found, More);
         exit when Found;
         Trace.Idle (Who);
      end loop;
      if More then
         --  the next Wait returns at once
         Arrived.Set;
      end if;
      Trace.Start (Who, Item.Number);
      Item.Owed := True;
   end Wait;

   procedure Clear is
   begin
      Port.Clear;
   end Clear;

end Order_Ports;
