--  SPDX-License-Identifier: GPL-3.0-or-later
--  The clients of the robot's line, one for each task that asks.

with Line_Clients;
with Line_Requests;
with Schedule;

package Robot_Clients with SPARK_Mode is

   package Safe_State is new Line_Clients
     (Line_Requests.Safe_State, Schedule.Th_Com_Mon_Perdue);
   package Reload is new Line_Clients
     (Line_Requests.Reload, Schedule.Th_Reload_WD);
   package Move is new Line_Clients
     (Line_Requests.Move, Schedule.Th_Move);
   package Battery is new Line_Clients
     (Line_Requests.Battery, Schedule.Th_Battery_Level);
   package Open is new Line_Clients
     (Line_Requests.Open, Schedule.Th_Open_Com_Robot);
   package Start is new Line_Clients
     (Line_Requests.Start, Schedule.Th_Start_Robot);
   package Start_Watchdog is new Line_Clients
     (Line_Requests.Start_Watchdog, Schedule.Th_Start_Robot_WD);
   package Reset is new Line_Clients
     (Line_Requests.Reset, Schedule.Th_Reset_Robot);
   package Query is new Line_Clients
     (Line_Requests.Query, Schedule.Th_Query);
   package Keep_Alive is new Line_Clients
     (Line_Requests.Keep_Alive, Schedule.Th_Keep_Alive);

   procedure Signal (Who : Line_Requests.Client)
   with Annotate => (GNATprove, Terminating);
   --  The request of Who has been carried out. A stop has no client, and
   --  nobody waits for it

end Robot_Clients;
