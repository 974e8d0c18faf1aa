--  SPDX-License-Identifier: GPL-3.0-or-later
--  Drawings as SVG files: texts, lines, boxes and curves. Positions and sizes
--  are in pixels from the upper left corner.

private with Ada.Text_IO;

package Svg_Files is

   type Svg_File is limited private;

   procedure Create
     (Drawing       : in out Svg_File;
      Path          : String;
      Title         : String;
      Width, Height : Float;
      Style         : String);
   --  Style is CSS with the classes used below; a shape may have several
   --  classes, separated by blanks. Raises Name_Error or Use_Error if the file
   --  cannot be written.

   type Anchor_Kind is (First, Middle, Last);
   --  Which part of a text is at its position

   procedure Put_Text
     (Drawing : in out Svg_File;
      X, Y    : Float;
      Text    : String;
      Anchor  : Anchor_Kind := First;
      Class   : String      := "");

   procedure Put_Stroke
     (Drawing : in out Svg_File; X1, Y1, X2, Y2 : Float; Class : String);

   procedure Put_Box
     (Drawing : in out Svg_File; X, Y, Width, Height : Float; Class : String);

   procedure Begin_Curve (Drawing : in out Svg_File; Class : String);

   procedure Go_On (Drawing : in out Svg_File; X, Y : Float);
   --  To the next point of the curve

   procedure End_Curve (Drawing : in out Svg_File);

   procedure Close (Drawing : in out Svg_File);

   function Decimal (Value : Float; Most : Positive := 1) return String;
   --  As short as possible, with at most so many decimals

private

   type Svg_File is limited record
      File   : Ada.Text_IO.File_Type;
      Points : Natural := 0;
      --  of the curve so far
   end record;

end Svg_Files;
