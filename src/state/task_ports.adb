--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event-data ports of the tasks that carry out the monitor's orders,
--  and the way of an order to the right one.

with Monitor_Protocol; use Monitor_Protocol;
with Robot_Line;
with Vision_Queue;

package body Task_Ports with SPARK_Mode is

   procedure To_Vision (Item : Orders.Order);
   --  Item is the vision's next order

   ---------------
   -- To_Vision --
   ---------------

   procedure To_Vision (Item : Orders.Order) is
   begin
      if Item.Message.Kind in Ask_Arena | Confirm_Arena | Reject_Arena then
         Arena.Put (Item);
      else
         Camera_Control.Put (Item);
      end if;
   end To_Vision;

   --------------
   -- Dispatch --
   --------------

   procedure Dispatch (Item : Orders.Order) is
      Now : Boolean;
   begin
      case Item.Message.Kind is
         when Monitor_Protocol.Open_Robot | Close_Robot =>
            Open_Robot.Put (Item);
         when Monitor_Protocol.Start_Robot =>
            Start_Robot.Put (Item);
         when Monitor_Protocol.Start_Robot_Watchdog =>
            Start_Robot_Watchdog.Put (Item);
         when Monitor_Protocol.Reset_Robot | Power_Off_Robot =>
            Reset_Robot.Put (Item);
         when Go_Forward .. Go_Right | Move_Robot | Turn_Robot =>
            Move.Put (Item);
         when Stop_Robot =>
            Robot_Line.Put_Stop (Item);
         when Ping_Robot | Reload_Watchdog | Get_Battery | Get_State =>
            Query.Put (Item);
         when Open_Camera .. Stop_Position =>
            Vision_Queue.Put (Item, Now);
            if Now then
               To_Vision (Item);
            end if;
         when Log_Message | Malformed =>
            null;
      end case;
   end Dispatch;

   -----------------
   -- Vision_Done --
   -----------------

   procedure Vision_Done is
      Item  : Orders.Order;
      Found : Boolean;
   begin
      Vision_Queue.Next (Item, Found);
      if Found then
         To_Vision (Item);
      end if;
   end Vision_Done;

   -----------
   -- Clear --
   -----------

   procedure Clear is
   begin
      --  the vision's ports hold one order between them, which is to be
      --  taken: it leads to the next
      Vision_Queue.Clear;
      Open_Robot.Clear;
      Start_Robot.Clear;
      Start_Robot_Watchdog.Clear;
      Reset_Robot.Clear;
      Move.Clear;
      Query.Clear;
   end Clear;

end Task_Ports;
