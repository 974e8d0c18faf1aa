--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision: one at a time, in the order of the commands.

with AUnit.Assertions; use AUnit.Assertions;

with Orders;           use Orders;
with Vision.Queue;

package body Vision_Queue_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   procedure Begin_Anew;
   --  Nothing is carried out, nothing waits.

   procedure Put (Number : Ticket; At_Once : Boolean);

   procedure Check (Number : Ticket);
   --  The order under way is done, and the next has Number.

   procedure Check_End;
   --  The order under way is done, and none follows.

   procedure Test_Order (T : in out Any_Test);
   procedure Test_Clear (T : in out Any_Test);
   procedure Test_Full (T : in out Any_Test);

   procedure Begin_Anew is
   begin
      Vision.Queue.Clear;
      Check_End;
   end Begin_Anew;

   procedure Check (Number : Ticket) is
      Item : Order;
   begin
      Vision.Queue.Next (Item);
      Assert (Item.Owed, Number'Image & " waits");
      Assert (Item.Number = Number,
              Number'Image & " expected, not" & Item.Number'Image);
   end Check;

   procedure Check_End is
      Item : Order;
   begin
      Vision.Queue.Next (Item);
      Assert (not Item.Owed, "none expected, not" & Item.Number'Image);
   end Check_End;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Vision.Queue"));

   procedure Put (Number : Ticket; At_Once : Boolean) is
      Item : Order := (Number => Number, Owed => True, others => <>);
   begin
      Vision.Queue.Put (Item);
      Assert (Item.Owed = At_Once,
              Number'Image & (if At_Once then " at once" else " waits"));
   end Put;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Order'Access, "one at a time, in order");
      Register_Routine (T, Test_Clear'Access,
                        "what is under way outlasts its session");
      Register_Routine (T, Test_Full'Access, "room for 256");
   end Register_Tests;

   procedure Test_Clear (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Full (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Order (T : in out Any_Test) is
      pragma Unreferenced (T);
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

end Vision_Queue_Tests;
