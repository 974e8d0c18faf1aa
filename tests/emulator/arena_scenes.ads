--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arena renderer of tests/scene (scene.h), as used by the camera.

with Interfaces.C; use Interfaces.C;
with System;

package Arena_Scenes is

   type Robot_In_Scene is record
      Marker  : int;
      Id      : int;
      X, Y    : double;
      Heading : double;
   end record with Convention => C;
   --  scene_robot: centimetres, degrees

   type Robot_Array is array (1 .. 4) of Robot_In_Scene
     with Convention => C;

   type Scene is record
      Width, Height : int;
      Arena         : int;
      Fill          : double;
      Turn          : double;
      Noise         : double;
      Blur          : double;
      Uneven        : double;
      Seed          : unsigned;
      Robots        : int;
      Robot         : Robot_Array;
   end record with Convention => C;
   --  scene_description

   procedure Find_Robot
     (Where          : Scene;
      Number         : int;
      Cx, Cy, Dx, Dy : out double;
      Status         : out int);
   --  scene_robot_truth: centre and direction in pixels, Status 0 if done

   procedure Draw
     (What     : Scene;
      Quality  : int;
      Data     : System.Address;
      Capacity : int;
      Length   : out int);
   --  scene_jpeg: Length is -1 on failure

end Arena_Scenes;
