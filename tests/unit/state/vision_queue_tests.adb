--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision: one at a time, in the order of the commands.

with AUnit.Assertions; use AUnit.Assertions;

with Orders;           use Orders;
with Vision.Queue;
with Unit_Runs; use Unit_Runs;

procedure Vision_Queue_Tests is

   procedure Check_End is
      --  The order under way is done, and none follows.
      Item : Order;
   begin
      Vision.Queue.Next (Item);
      Assert (not Item.Owed, "none expected, not" & Item.Number'Image);
   end Check_End;

   procedure Begin_Anew is
      --  Nothing is carried out, nothing waits.
   begin
      Vision.Queue.Clear;
      Check_End;
   end Begin_Anew;

   procedure Check (Number : Ticket) is
      --  The order under way is done, and the next has Number.
      Item : Order;
   begin
      Vision.Queue.Next (Item);
      Assert (Item.Owed, Number'Image & " waits");
      Assert (Item.Number = Number,
              Number'Image & " expected, not" & Item.Number'Image);
   end Check;

   procedure Put (Number : Ticket; At_Once : Boolean) is
      Item : Order := (Number => Number, Owed => True, others => <>);
   begin
      Vision.Queue.Put (Item);
      Assert (Item.Owed = At_Once,
              Number'Image & (if At_Once then " at once" else " waits"));
   end Put;

   procedure Test_Clear is
   begin
      Begin_Anew;
      Put (1, At_Once => True);
      Put (2, At_Once => False);
      Vision.Queue.Clear;
      Put (3, At_Once => False);
      Check (3);
      Check_End;
      Put (4, At_Once => True);
   end Test_Clear;

   procedure Test_Full is
   begin
      Begin_Anew;
      Put (1000, At_Once => True);
      for I in 1 .. Ticket'(Capacity) loop
         Put (I, At_Once => False);
      end loop;
      for I in 1 .. Ticket'(Capacity) loop
         Check (I);
      end loop;
      Check_End;
   end Test_Full;

   procedure Test_Order is
   begin
      Begin_Anew;
      Put (1, At_Once => True);
      Put (2, At_Once => False);
      Put (3, At_Once => False);
      Check (2);
      Put (4, At_Once => False);
      Check (3);
      Check (4);
      Check_End;
      Put (5, At_Once => True);
      Check_End;
   end Test_Order;

begin
   Run_Test ("one at a time, in order", Test_Order'Access);
   Run_Test ("what is under way outlasts its session", Test_Clear'Access);
   Run_Test ("room for 256", Test_Full'Access);
end Vision_Queue_Tests;
