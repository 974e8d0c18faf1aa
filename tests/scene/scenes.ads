--  SPDX-License-Identifier: GPL-3.0-or-later
--  The synthetic arena of scene.h, for tests.

with Interfaces.C; use Interfaces.C;
with System;

package Scenes is

   type Robot is record
      Marker  : int;     --  0: ArUco, 1: triangle
      Id      : int;
      X, Y    : double;  --  centimetres from the left, from the bottom
      Heading : double;  --  degrees, counter-clockwise from x
   end record
   with Convention => C;

   type Robot_Array is array (0 .. 3) of Robot with Convention => C;

   type Description is record
      Width, Height : int;
      Arena         : int;
      Fill          : double;
      Turn          : double;
      Noise         : double;
      Blur          : double;
      Uneven        : double;
      Lean_X        : double;
      Lean_Y        : double;
      Seed          : unsigned;
      Robots        : int;
      Robot         : Robot_Array;
   end record
   with Convention => C;
   --  What is drawn; scene.h has units and ranges. Passed by reference

   type Corner_Coordinates is array (0 .. 7) of double with Convention => C;
   --  x and y of top left, top right, bottom right, bottom left

   function Default return Description
   with Import, Convention => C, External_Name => "scene_default";

   function Draw (Scene : Description; Bgr : System.Address) return int
   with Import, Convention => C, External_Name => "scene_draw";

   function Robot_Truth
     (Scene          : Description;
      N              : int;
      Cx, Cy, Dx, Dy : out double) return int
   with Import, Convention => C, External_Name => "scene_robot_truth";

   function Arena_Truth
     (Scene : Description; Corner : out Corner_Coordinates) return int
   with Import, Convention => C, External_Name => "scene_arena_truth";

   function Jpeg
     (Scene    : Description;
      Quality  : int;
      Buffer   : System.Address;
      Capacity : int) return int
   with Import, Convention => C, External_Name => "scene_jpeg";

   function Decode_Grey
     (Jpeg          : System.Address;
      Length        : int;
      Width, Height : int;
      Grey          : System.Address) return int
   with Import, Convention => C, External_Name => "scene_decode_grey";

   function Page
     (Path          : char_array;
      Scale         : int;
      Bgr           : System.Address;
      Room          : int;
      Width, Height : out int) return int
   with Import, Convention => C, External_Name => "scene_page";

   function Video
     (Scene       : Description;
      Frames, Fps : int;
      Path        : char_array) return int
   with Import, Convention => C, External_Name => "scene_video";

end Scenes;
