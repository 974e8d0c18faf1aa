--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks of the robot, those of the design report. Each takes the line
--  when it is its turn, and carries out an order or what is due.

with Schedule;

package Robot.Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Open_Com_Robot with Priority => Schedule.Open_Priority;
   --  ROPN, RCLS (F7), RPIN, RVER; pings an idle line

   task Th_Start_Robot with Priority => Schedule.Open_Priority;
   --  RSOW (F10)

   task Th_Start_Robot_WD with Priority => Schedule.Reload_Priority;
   --  RSWW (F11), RLDW; reloads the watchdog every Reload_Period

   task Th_Reset_Robot with Priority => Schedule.Open_Priority;
   --  RRST, RPOF

   task Th_Move with Priority => Schedule.Move_Priority;
   --  The movement orders and stops (F12), RGST

   task Th_Battery_Level with Priority => Schedule.Battery_Priority;
   --  Reads the battery level every Battery_Period (F13); RGBT

end Robot.Tasks;
