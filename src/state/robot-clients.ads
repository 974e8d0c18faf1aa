--  SPDX-License-Identifier: GPL-3.0-or-later
--  The clients of the robot's line, one for each task that makes requests.

with Robot.Line.Clients;
with Robot.Requests;
with Schedule;

package Robot.Clients with SPARK_Mode is

   package Safe_State is new Robot.Line.Clients
     (Robot.Requests.Safe_State, Schedule.Th_Com_Mon_Perdue);
   package Reload is new Robot.Line.Clients
     (Robot.Requests.Reload, Schedule.Th_Reload_WD);
   package Move is new Robot.Line.Clients
     (Robot.Requests.Move, Schedule.Th_Move);
   package Mission is new Robot.Line.Clients
     (Robot.Requests.Mission, Schedule.Th_Mission);
   package Battery is new Robot.Line.Clients
     (Robot.Requests.Battery, Schedule.Th_Battery_Level);
   package Open is new Robot.Line.Clients
     (Robot.Requests.Open, Schedule.Th_Open_Com_Robot);
   package Start is new Robot.Line.Clients
     (Robot.Requests.Start, Schedule.Th_Start_Robot);
   package Start_Watchdog is new Robot.Line.Clients
     (Robot.Requests.Start_Watchdog, Schedule.Th_Start_Robot_WD);
   package Reset is new Robot.Line.Clients
     (Robot.Requests.Reset, Schedule.Th_Reset_Robot);
   package Query is new Robot.Line.Clients
     (Robot.Requests.Query, Schedule.Th_Query);
   package Keep_Alive is new Robot.Line.Clients
     (Robot.Requests.Keep_Alive, Schedule.Th_Keep_Alive);

   procedure Signal (Who : Robot.Requests.Client)
   with Annotate => (GNATprove, Terminating);
   --  The request of Who has been carried out. No effect for a stop, which has
   --  no client

end Robot.Clients;
