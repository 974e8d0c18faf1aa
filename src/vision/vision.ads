--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision: shapes in an image, its mode, the times of the images, the
--  camera and its library, the images in transit, and the tasks.

package Vision with SPARK_Mode, Pure is

   type Slot is range 0 .. 5;
   --  A place for one image. Used at most: one by the camera's owner, one for
   --  the newest image, one for the image before it, and one by each of the
   --  two readers. So one is always free

   type Micro_Pixels is range -10 ** 13 .. 10 ** 13;
   --  Millionths of a pixel of the whole image, x to the right and y down; 0
   --  is the centre of the top left pixel

   type Micro_Degrees is range -180_000_000 .. 180_000_000;
   --  Millionths of a degree

   type Point is record
      X, Y : Micro_Pixels := 0;
   end record;

   type Corner is (Top_Left, Top_Right, Bottom_Right, Bottom_Left);

   type Arena_Corners is array (Corner) of Point;
   --  Inner corners of the white border, in image coordinates

   No_Arena : constant Arena_Corners := (others => (X => 0, Y => 0));

   type Identifier is range 0 .. 999;
   --  ID of an ArUco marker (DICT_4X4_1000); 0 for a triangle

   type Robot is record
      Id        : Identifier    := 0;
      Centre    : Point;
      Direction : Point;               --  a point in the robot's direction
      Angle     : Micro_Degrees := 0;  --  atan2 (cy - dy, cx - dx)
   end record;

   subtype Robot_Count is Natural range 0 .. 4;

   type Robot_Array is array (1 .. Robot_Count'Last) of Robot;

   type Area is record
      Centre : Point;
      Reach  : Micro_Pixels := 0;
   end record;
   --  A square of the image: its centre, and half its side

   type Area_Array is array (1 .. Robot_Count'Last) of Area;

end Vision;
