--  SPDX-License-Identifier: GPL-3.0-or-later
--  The three vision tasks of the design report, and the camera's owner.

with Bytes;
with Monitor.Outbox;
with Schedule;

package Vision.Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Camera_Control with
     Priority => Schedule.Camera_Control_Priority;
   --  COPN, CCLS (F14, F16), CPCO, CPST (F18, F19)

   task Th_Capture_Img with Priority => Schedule.Capture_Priority;
   --  Sends the periodic image and the robot's position in it (F15, F18)

   task Th_Arene with Priority => Schedule.Arena_Priority;
   --  CASA, CACO, CAIN (F17)

   task Th_Camera with Priority => Schedule.Camera_Priority;
   --  Owns the camera: opens it, takes every image, closes it

private

   subtype Jpeg_Buffer is Bytes.Byte_Array
     (1 .. Monitor.Outbox.Max_Jpeg);

   Image_Jpeg : Jpeg_Buffer := (others => 0)
     with Part_Of => Th_Capture_Img;
   Arena_Jpeg : Jpeg_Buffer := (others => 0)
     with Part_Of => Th_Arene;

end Vision.Tasks;
