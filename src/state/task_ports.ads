--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event-data ports of the tasks that carry out the monitor's orders, and
--  the dispatch of orders to them.

with Commands;
with Order_Ports;
with Orders;
with Schedule;

package Task_Ports with SPARK_Mode is

   package Open_Robot is new Order_Ports (Schedule.Th_Open_Com_Robot);
   package Start_Robot is new Order_Ports (Schedule.Th_Start_Robot);
   package Start_Robot_Watchdog is new Order_Ports
     (Schedule.Th_Start_Robot_WD);
   package Reset_Robot is new Order_Ports (Schedule.Th_Reset_Robot);
   package Move is new Order_Ports (Schedule.Th_Move);
   package Query is new Order_Ports (Schedule.Th_Query);
   package Camera_Control is new Order_Ports (Schedule.Th_Camera_Control);
   package Arena is new Order_Ports (Schedule.Th_Arene);

   procedure Dispatch (Item : in out Orders.Order)
   with
     Pre  => Item.Owed
       and then Item.Command.Name in
         Commands.Robot_Command | Commands.Vision_Command,
     Post => not Item.Owed,
     Annotate => (GNATprove, Terminating);
   --  Sends Item to the task that carries it out (Commands.Table): vision
   --  orders one by one, in the order of the commands, a stop directly to the
   --  line's owner. An order by hand is made known to the line first

   procedure Vision_Done with Annotate => (GNATprove, Terminating);
   --  A vision task has carried out an order: the next one may start

   procedure Clear with Annotate => (GNATprove, Terminating);
   --  Removes all waiting orders: their session has ended

end Task_Ports;
