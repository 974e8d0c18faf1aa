--  SPDX-License-Identifier: GPL-3.0-or-later
--  The newest sighting of the robot, from th_captureImg to th_mission.

with Ada.Real_Time; use Ada.Real_Time;
with Schedule;
with Vision.Following;
with Vision.Shapes;

package Vision.Sightings with SPARK_Mode is

   protected Store with Priority => Schedule.Sight_Ceiling is

      procedure Clear;
      --  The camera has just been opened, or is closed: nothing has been seen

      procedure Put
        (Came    : Time;
         Robots  : Vision.Shapes.Robot_Array;
         Count   : Vision.Shapes.Robot_Count;
         Awaited : out Boolean);

      procedure Get (Newest : out Vision.Following.Sighting);

      procedure Watch (On : Boolean);
      --  A mission begins or has ended. For th_mission only

   private
      Known   : Vision.Following.Sighting;
      Watched : Boolean := False;
   end Store;

   procedure Put
     (Came   : Time;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count)
   with Annotate => (GNATprove, Terminating);
   --  An image has been searched. Wakes th_mission while that watches

   procedure Wait_Until (At_Time : Time);
   --  Until an image has been searched, or At_Time. For th_mission only

end Vision.Sightings;
