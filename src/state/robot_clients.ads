--  SPDX-License-Identifier: GPL-3.0-or-later
--  The clients of the robot's line, one for each task that asks.

with Line_Clients;
with Line_Requests;

package Robot_Clients with SPARK_Mode is

   package Safe_State is new Line_Clients (Line_Requests.Safe_State);
   package Reload is new Line_Clients (Line_Requests.Reload);
   package Move is new Line_Clients (Line_Requests.Move);
   package Battery is new Line_Clients (Line_Requests.Battery);
   package Open is new Line_Clients (Line_Requests.Open);
   package Start is new Line_Clients (Line_Requests.Start);
   package Start_Watchdog is new Line_Clients (Line_Requests.Start_Watchdog);
   package Reset is new Line_Clients (Line_Requests.Reset);
   package Query is new Line_Clients (Line_Requests.Query);
   package Keep_Alive is new Line_Clients (Line_Requests.Keep_Alive);

   procedure Signal (Who : Line_Requests.Client)
   with Annotate => (GNATprove, Terminating);
   --  The request of Who has been carried out. A stop has no client: the
   --  owner of the line answers it

end Robot_Clients;
