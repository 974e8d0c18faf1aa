--  SPDX-License-Identifier: GPL-3.0-or-later
--  Parses numbers, words and poses from the command line or standard input.

with Arena_Camera;
with Robot_Bench;
with Robot_Core;
with Robot_Motion;

package Readings is

   Bad_Value : exception;
   --  The message says what was expected

   function Whole (Text : String; Low, High : Integer) return Integer;
   --  A decimal number in Low .. High, or Bad_Value

   function Is_Word_Of (Text : String; Kind : Robot_Bench.Fault_Kind)
     return Boolean;
   --  Such as drop-every

   function Fault_Value (Kind : Robot_Bench.Fault_Command; Text : String)
     return Natural;
   --  A number, or on or off, as Robot_Bench.Bench.Set takes it

   function On_Or_Off (Text : String) return Boolean;

   function Battery (Text : String) return Robot_Core.Centivolts;
   --  0, 1, 2 or critical, or its voltage, such as 3.42

   function Pose (X, Y, Angle : String) return Robot_Motion.Pose;
   --  Centimetres from the left and from the bottom wall, degrees
   --  counter-clockwise from the x axis; decimals are allowed

   procedure Size
     (Text   : String;
      Width  : out Arena_Camera.Frame_Width;
      Height : out Arena_Camera.Frame_Height);
   --  WIDTHxHEIGHT in pixels, or Bad_Value

   subtype Data_Length is Natural range 0 .. 256;

   function Bytes (Text : String) return Robot_Core.Octets
     with Post => Bytes'Result'Length <= Data_Length'Last;
   --  Characters, with the usual escapes \r, \n, \\ and \xHH

   function Image (Value : Robot_Motion.Micro; Unit : Positive) return String;
   --  Value / Unit (a power of 10) with three decimals

end Readings;
