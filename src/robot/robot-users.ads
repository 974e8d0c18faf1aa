--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks that use the robot's line, one at a time: the event by which each
--  learns that it may take the line, or is to look when it will.

with Commands;
with Event;
with Schedule; use Schedule;

package Robot.Users with SPARK_Mode is

   package Open_Com is new Event (Th_Open_Com_Robot);
   package Start is new Event (Th_Start_Robot);
   package Start_WD is new Event (Th_Start_Robot_WD);
   package Reset is new Event (Th_Reset_Robot);
   package Move is new Event (Th_Move);
   package Battery is new Event (Th_Battery_Level);
   package Mission is new Event (Th_Mission);
   package Monitor_Lost is new Event (Th_Com_Mon_Perdue);

   procedure Set (Who : Task_Name; Number : Commands.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  The event of Who, if it is one of these. Number: of the monitor's order
   --  that Who is to carry out, if any

end Robot.Users;
