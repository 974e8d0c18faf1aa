--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks' ports: first in first out, the capacity, the end of a session.

with AUnit.Assertions; use AUnit.Assertions;

with Order_Ports;
with Orders;           use Orders;
with Schedule;

package body Order_Ports_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   package Port is new Order_Ports (Schedule.Th_Move);

   procedure Put (Number : Ticket);

   procedure Check (Number : Ticket);
   --  The next order has Number.

   procedure Test_Order (T : in out Any_Test);
   procedure Test_Full (T : in out Any_Test);
   procedure Test_Clear (T : in out Any_Test);

   procedure Check (Number : Ticket) is
      Item : Order;
   begin
      Port.Wait (Item);
      Assert (Item.Owed and then Item.Number = Number,
              Number'Image & " expected, not" & Item.Number'Image);
   end Check;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Order_Ports"));

   procedure Put (Number : Ticket) is
      Item : Order := (Number => Number, Owed => True, others => <>);
   begin
      Port.Put (Item);
   end Put;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Order'Access, "first in first out");
      Register_Routine (T, Test_Full'Access, "room for 256, and no more");
      Register_Routine (T, Test_Clear'Access, "orders that are forgotten");
   end Register_Tests;

   procedure Test_Clear (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Port.Clear;
      Put (1);
      Put (2);
      Port.Clear;
      Put (3);
      Check (3);
   end Test_Clear;

   procedure Test_Full (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Order (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Port.Clear;
      Put (1);
      Put (2);
      Check (1);
      Put (3);
      Check (2);
      Check (3);
   end Test_Order;

end Order_Ports_Tests;
