--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the robot is, as the newest searched image of the camera shows it.

with Ada.Real_Time;
with Vision.Shapes;

package Vision.Robot_Sightings with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Robot_Sightings);

   type Sighting is record
      Number : Natural := 0;
      --  number of images searched for robots since the camera was opened
      Came   : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  when the image came from the camera
      Seen   : Boolean := False;
      --  exactly one robot is in it: Robot
      Robot  : Vision.Shapes.Robot;
   end record;

   function Next
     (S      : Sighting;
      Came   : Ada.Real_Time.Time;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count) return Sighting
   is ((Number => (if S.Number = Natural'Last then 1 else S.Number + 1),
        Came   => Came,
        Seen   => Count = 1,
        Robot  => Robots (1)));
   --  The image that came at Came has been searched: it has Robots (1 ..
   --  Count)

end Vision.Robot_Sightings;
