--  SPDX-License-Identifier: GPL-3.0-or-later

with Commands; use Commands;
with Robot.Line;
with Schedule; use Schedule;
with Vision.Queue;

package body Task_Ports with SPARK_Mode is

   procedure To_Vision (Item : in out Orders.Order)
   with
     Pre  => Item.Owed,
     Post => not Item.Owed
   is
      --  Sends the vision's next order
   begin
      if Commands.Table (Item.Command.Name).By = Th_Arene then
         Arena.Put (Item);
      else
         Camera_Control.Put (Item);
      end if;
   end To_Vision;

   procedure Dispatch (Item : in out Orders.Order) is
   begin
      if Item.Command.Name in Vision_Command then
         Vision.Queue.Put (Item);
         if Item.Owed then
            To_Vision (Item);
         end if;
      else
         if Is_By_Hand (Item.Command.Name) then
            --  before it is passed on: then no order of the mission follows it
            Robot.Line.Note_Hand (Item.Number);
         end if;
         case Commands.Table (Item.Command.Name).By is
            when Th_Line           => Robot.Line.Put_Stop (Item);
            when Th_Move           => Move.Put (Item);
            when Th_Open_Com_Robot => Open_Robot.Put (Item);
            when Th_Start_Robot    => Start_Robot.Put (Item);
            when Th_Start_Robot_WD => Start_Robot_Watchdog.Put (Item);
            when Th_Reset_Robot    => Reset_Robot.Put (Item);
            when others            => Query.Put (Item);
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
