--  SPDX-License-Identifier: GPL-3.0-or-later
--  The clients of the robot's line, one for each task that asks.

with Line_Clients;
with Robot_Line;

package Robot_Clients with SPARK_Mode is

   package Safe_State is new Line_Clients (Robot_Line.Safe_State);
   package Reload is new Line_Clients (Robot_Line.Reload);
   package Move is new Line_Clients (Robot_Line.Move);
   package Battery is new Line_Clients (Robot_Line.Battery);
   package Open is new Line_Clients (Robot_Line.Open);
   package Start is new Line_Clients (Robot_Line.Start);
   package Start_Watchdog is new Line_Clients (Robot_Line.Start_Watchdog);
   package Reset is new Line_Clients (Robot_Line.Reset);
   package Query is new Line_Clients (Robot_Line.Query);
   package Keep_Alive is new Line_Clients (Robot_Line.Keep_Alive);

   procedure Signal (Who : Robot_Line.Client);
   --  The request of Who has been carried out. A stop has no client: the
   --  owner of the line answers it

end Robot_Clients;
