--  SPDX-License-Identifier: GPL-3.0-or-later

with Order_Meanings; use Order_Meanings;
with Robot.Line;
with Robot.Requests;
with Vision.Queue;

package body Task_Ports with SPARK_Mode is

   procedure To_Vision (Item : in out Orders.Order)
   with
     Pre  => Item.Owed,
     Post => not Item.Owed;
   --  Sends the vision's next order

   procedure To_Vision (Item : in out Orders.Order) is
   begin
      if Item.Message.Kind in Arena_Order then
         Arena.Put (Item);
      else
         Camera_Control.Put (Item);
      end if;
   end To_Vision;

   procedure Dispatch (Item : in out Orders.Order) is
   begin
      if Is_By_Hand (Item.Message.Kind) then
         --  before it is passed on: then no order of the mission follows it
         Robot.Line.Note_Hand (Item.Number);
      end if;
      if Item.Message.Kind in Vision_Order then
         Vision.Queue.Put (Item);
         if Item.Owed then
            To_Vision (Item);
         end if;
      else
         case Client_Of (Item.Message.Kind) is
            when Robot.Requests.Open           => Open_Robot.Put (Item);
            when Robot.Requests.Start          => Start_Robot.Put (Item);
            when Robot.Requests.Start_Watchdog =>
               Start_Robot_Watchdog.Put (Item);
            when Robot.Requests.Reset          => Reset_Robot.Put (Item);
            when Robot.Requests.Move           => Move.Put (Item);
            when Robot.Requests.Stop_Order     => Robot.Line.Put_Stop (Item);
            when others                        => Query.Put (Item);
         end case;
      end if;
   end Dispatch;

   procedure Vision_Done is
      Item : Orders.Order;
   begin
      Vision.Queue.Next (Item);
      if Item.Owed then
         To_Vision (Item);
      end if;
      pragma Assert (not Item.Owed);
   end Vision_Done;

   procedure Clear is
   begin
      --  the vision's ports hold at most one order, which must still be taken,
      --  as it leads to the next
      Vision.Queue.Clear;
      Open_Robot.Clear;
      Start_Robot.Clear;
      Start_Robot_Watchdog.Clear;
      Reset_Robot.Clear;
      Move.Clear;
      Query.Clear;
   end Clear;

end Task_Ports;
