--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the robot is, as the newest searched image of the camera shows it.

with Ada.Real_Time;
with Vision.Shapes;

package Vision.Robot_Sightings with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Robot_Sightings);

   use type Vision.Shapes.Robot;

   type Sighting is record
      Number : Natural := 0;
      --  number of images searched for robots since the camera was opened
      Came   : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  when the image came from the camera
      Seen   : Boolean := False;
      --  exactly one robot is in it: Robot
      Robot  : Vision.Shapes.Robot;
   end record;

   procedure Note
     (S      : in out Sighting;
      Came   : Ada.Real_Time.Time;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count)
   with
     Post => S.Number =
         (if S'Old.Number = Natural'Last then 1 else S'Old.Number + 1)
       and then S.Seen = (Count = 1)
       and then (if S.Seen then S.Robot = Robots (1));
   --  The image that came at Came has been searched: it has Robots (1 ..
   --  Count)

end Vision.Robot_Sightings;
