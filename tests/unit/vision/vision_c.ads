--  SPDX-License-Identifier: GPL-3.0-or-later
--  vision_c/vision.h as it is, for tests that the Ada side would not let
--  through.

with Interfaces.C; use Interfaces.C;
with System;

package Vision_C is

   type Status is
     (Ok, Not_Found, No_Camera, No_Image, Too_Small, Bad_Argument, Failed)
   with Convention => C;

   type Any_Marker is (Aruco, Triangle, No_Such_Marker) with Convention => C;

   subtype Marker is Any_Marker range Aruco .. Triangle;

   type Point is record
      X, Y : double := 0.0;
   end record
   with Convention => C;

   type Corners is array (0 .. 3) of Point with Convention => C;

   type Arena is record
      Corner : Corners;
   end record
   with Convention => C;

   type Robot is record
      Id        : int := 0;
      Centre    : Point;
      Direction : Point;
      Angle     : double := 0.0;
   end record
   with Convention => C;

   type Robot_Array is array (int range <>) of Robot with Convention => C;

   function Open
     (Source : char_array; Width, Height, Fps : int) return Status
   with Import, Convention => C, External_Name => "vision_open";

   function Open_At
     (Source : System.Address; Width, Height, Fps : int) return Status
   with Import, Convention => C, External_Name => "vision_open";

   function Grab (Slot : int) return Status
   with Import, Convention => C, External_Name => "vision_grab";

   function Close return Status
   with Import, Convention => C, External_Name => "vision_close";

   function Find_Arena (Slot : int; Found : access Arena) return Status
   with Import, Convention => C, External_Name => "vision_find_arena";

   function Find_Robots
     (Slot     : int;
      Kind     : Any_Marker;
      Inside   : access constant Arena;
      Robots   : System.Address;
      Capacity : int;
      Count    : access int;
      Areas    : System.Address := System.Null_Address;
      Number   : int := 0) return Status
   with Import, Convention => C, External_Name => "vision_find_robots";

   function Draw_Arena
     (Slot : int; Item : access constant Arena) return Status
   with Import, Convention => C, External_Name => "vision_draw_arena";

   function Draw_Robot
     (Slot : int; Item : access constant Robot) return Status
   with Import, Convention => C, External_Name => "vision_draw_robot";

   function Encode
     (Slot, Quality : int;
      Buffer        : System.Address;
      Capacity      : int;
      Length        : access int) return Status
   with Import, Convention => C, External_Name => "vision_encode";

   function Print_Markers (Descriptor, First, Side : int) return Status
   with Import, Convention => C, External_Name => "vision_print_markers";

   function Reason return System.Address
   with Import, Convention => C, External_Name => "vision_reason";

end Vision_C;
