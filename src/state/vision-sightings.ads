--  SPDX-License-Identifier: GPL-3.0-or-later
--  The newest sighting of the robot, from th_captureImg to th_mission.

with Ada.Real_Time;
with Vision.Robot_Sightings;
with Vision.Shapes;

package Vision.Sightings with SPARK_Mode is

   subtype Sighting is Vision.Robot_Sightings.Sighting;

   procedure Clear with Annotate => (GNATprove, Terminating);
   --  The camera has just been opened, or is closed: nothing has been seen

   procedure Put
     (Came   : Ada.Real_Time.Time;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count)
   with Annotate => (GNATprove, Terminating);
   --  An image has been searched. Wakes th_mission while that watches

   procedure Get (Newest : out Sighting)
   with Annotate => (GNATprove, Terminating);

   --  For th_mission only

   procedure Watch (On : Boolean) with Annotate => (GNATprove, Terminating);
   --  A mission begins or has ended

   procedure Wait_Until (At_Time : Ada.Real_Time.Time);
   --  Until an image has been searched, or At_Time

end Vision.Sightings;
