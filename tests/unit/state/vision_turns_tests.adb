--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision: one at a time, in the order of the commands.

with Commands;         use Commands;
with Vision.Turns;
with Unit_Runs; use Unit_Runs;

procedure Vision_Turns_Tests is

   procedure Put (Number : Ticket; Name : Vision_Command) is
      Item : Order := (Number, (Name, 0), Owed => True, others => <>);
   begin
      Vision.Turns.Put (Item);
      Assert (not Item.Owed, "nobody has" & Number'Image);
   end Put;

   procedure Check (Number : Ticket; Name : Vision_Command) is
      --  The next order; it is carried out
      Item : Order;
   begin
      if Name in Ask_Arena .. Get_Ground then
         Vision.Turns.Wait_Arena (Item);
      else
         Vision.Turns.Wait_Camera_Control (Item);
      end if;
      Assert (Item.Number = Number,
              Number'Image & " expected, not" & Item.Number'Image);
      Vision.Turns.Finish;
   end Check;

   procedure Test_Clear is
      Item : Order;
   begin
      Put (1, Open_Camera);
      Vision.Turns.Wait_Camera_Control (Item);
      Put (2, Ask_Arena);
      Vision.Turns.Clear;
      Put (3, Ask_Arena);
      --  the first is still under way
      Vision.Turns.Finish;
      Check (3, Ask_Arena);
   end Test_Clear;

   procedure Test_Order is
      --  As many as may wait
      Names : constant array (Ticket range 0 .. 3) of Vision_Command :=
        (Open_Camera, Ask_Arena, Confirm_Arena, Start_Position);
   begin
      for I in 1 .. Ticket'(Capacity) loop
         Put (I, Names (I mod 4));
      end loop;
      for I in 1 .. Ticket'(Capacity) loop
         Check (I, Names (I mod 4));
      end loop;
   end Test_Order;

begin
   Run_Test ("one at a time, in order, 256", Test_Order'Access);
   Run_Test ("what is under way outlasts its session", Test_Clear'Access);
end Vision_Turns_Tests;
