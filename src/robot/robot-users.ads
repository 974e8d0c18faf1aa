--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks that use the robot's line, one at a time.

with Orders;
with Robot.Turns;
with Schedule; use Schedule;

package Robot.Users with SPARK_Mode is

   package Open_Com is new Robot.Turns (Th_Open_Com_Robot);
   package Start is new Robot.Turns (Th_Start_Robot);
   package Start_WD is new Robot.Turns (Th_Start_Robot_WD);
   package Reset is new Robot.Turns (Th_Reset_Robot);
   package Move is new Robot.Turns (Th_Move);
   package Battery is new Robot.Turns (Th_Battery_Level);
   package Mission is new Robot.Turns (Th_Mission);
   package Monitor_Lost is new Robot.Turns (Th_Com_Mon_Perdue);

   procedure Signal (Who : Task_Name; Number : Orders.Ticket := 0)
   with Annotate => (GNATprove, Terminating);
   --  Wakes Who, if it is one of these

end Robot.Users;
