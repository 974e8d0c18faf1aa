--  SPDX-License-Identifier: GPL-3.0-or-later
--  The task that drives the robot through the points of a mission.

with Schedule;

package Mission_Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Mission with Priority => Schedule.Mission_Priority;
   --  MGTO, MPTH, MGCM, MPCM: looks at each position and every
   --  Schedule.Mission_Period, and gives the robot the orders that
   --  Missions.Runs decides on

end Mission_Tasks;
