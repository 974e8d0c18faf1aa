--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks of the robot: six of the design report, the owner of the line,
--  and the periodic ones that a start releases.

with Schedule;

package Robot.Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Line with Priority => Schedule.Line_Priority;
   --  Owns the serial line: takes the most urgent request, carries it out,
   --  answers the monitor's orders, and releases the periodic tasks

   task Th_Open_Com_Robot with Priority => Schedule.Open_Priority;
   --  ROPN, RCLS (F7)

   task Th_Start_Robot with Priority => Schedule.Start_Priority;
   --  RSOW (F10)

   task Th_Start_Robot_WD with Priority => Schedule.Start_Watchdog_Priority;
   --  RSWW (F11); Th_Reload_WD then does the reloads

   task Th_Reload_WD with Priority => Schedule.Reload_Priority;
   --  Reloads the watchdog every Reload_Period after the start

   task Th_Reset_Robot with Priority => Schedule.Reset_Priority;
   --  RRST, RPOF

   task Th_Move with Priority => Schedule.Move_Priority;
   --  The movement orders (F12)

   task Th_Battery_Level with Priority => Schedule.Battery_Priority;
   --  Reads the battery level every Battery_Period (F13)

   task Th_Query with Priority => Schedule.Query_Priority;
   --  RPIN, RLDW, RGBT, RGST

   task Th_Keep_Alive with Priority => Schedule.Keep_Alive_Priority;
   --  Pings while the robot is started and its line is idle

end Robot.Tasks;
