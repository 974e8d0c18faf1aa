--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arena renderer of tests/scene, as far as the camera uses it.

package body Arena_Scenes is

   procedure Draw
     (What     : Scene;
      Quality  : int;
      Data     : System.Address;
      Capacity : int;
      Length   : out int)
   is
      function Jpeg
        (What     : System.Address;
         Quality  : int;
         Data     : System.Address;
         Capacity : int) return int
        with Import, Convention => C, External_Name => "scene_jpeg";
   begin
      Length := Jpeg (What'Address, Quality, Data, Capacity);
   end Draw;

   procedure Find_Robot
     (Where          : Scene;
      Number         : int;
      Cx, Cy, Dx, Dy : out double;
      Status         : out int)
   is
      function Truth
        (Where          : System.Address;
         Number         : int;
         Cx, Cy, Dx, Dy : System.Address) return int
        with Import, Convention => C, External_Name => "scene_robot_truth";
   begin
      Cx := 0.0;
      Cy := 0.0;
      Dx := 0.0;
      Dy := 0.0;
      Status := Truth
        (Where'Address, Number, Cx'Address, Cy'Address, Dx'Address,
         Dy'Address);
   end Find_Robot;

end Arena_Scenes;
