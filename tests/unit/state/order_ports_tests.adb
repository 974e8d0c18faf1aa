--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks' ports: first in first out, the capacity, the end of a session.

with AUnit.Assertions; use AUnit.Assertions;

with Order_Ports;
with Orders;           use Orders;
with Schedule;
with Unit_Runs; use Unit_Runs;

package body Order_Ports_Tests is

   package Port is new Order_Ports (Schedule.Th_Move);

   procedure Check (Number : Ticket) is
      --  The next order has Number.
      Item : Order;
   begin
      Port.Wait (Item);
      Assert (Item.Owed and then Item.Number = Number,
              Number'Image & " expected, not" & Item.Number'Image);
   end Check;

   procedure Put (Number : Ticket) is
      Item : Order := (Number => Number, Owed => True, others => <>);
   begin
      Port.Put (Item);
   end Put;

   procedure Test_Clear is
   begin
      Port.Clear;
      Put (1);
      Put (2);
      Port.Clear;
      Put (3);
      Check (3);
   end Test_Clear;

   procedure Test_Full is
   begin
      Port.Clear;

      --  more than once round the ring

      for Round in Ticket range 0 .. 2 loop
         for I in 1 .. Ticket'(Capacity) loop
            Put (1000 * Round + I);
         end loop;
         Put (9999);
         for I in 1 .. Ticket'(Capacity) loop
            Check (1000 * Round + I);
         end loop;
         Put (1000 * Round + 500);
         Check (1000 * Round + 500);
      end loop;
   end Test_Full;

   procedure Test_Order is
   begin
      Port.Clear;
      Put (1);
      Put (2);
      Check (1);
      Put (3);
      Check (2);
      Check (3);
   end Test_Order;

   procedure Add_Tests is
   begin
      Run_Test ("first in first out", Test_Order'Access);
      Run_Test ("room for 256, and no more", Test_Full'Access);
      Run_Test ("orders that are forgotten", Test_Clear'Access);
   end Add_Tests;

end Order_Ports_Tests;
