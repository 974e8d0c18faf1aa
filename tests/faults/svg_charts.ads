--  SPDX-License-Identifier: GPL-3.0-or-later
--  Curves over time as an SVG file: panels below each other with one axis of
--  time, readable on a light page and on a dark one.

with Ada.Containers.Vectors;

private with Svg_Files;

package Svg_Charts is

   type Point is record
      X, Y : Float;
   end record;

   package Point_Vectors is new Ada.Containers.Vectors (Positive, Point);
   subtype Points is Point_Vectors.Vector;

   type Colour is (Blue, Orange, Green);

   type Scale is (Linear, Logarithmic);

   type Chart is limited private;

   procedure Start
     (C      : in out Chart;
      Path   : String;
      Title  : String;
      Last_X : Float;
      Unit_X : String;
      Panels : Positive)
   with Pre => Last_X > 0.0;
   --  The time axis goes from 0 to Last_X. Raises Name_Error or Use_Error
   --  where the file cannot be written.

   procedure Begin_Panel
     (C         : in out Chart;
      Title     : String;
      Low, High : Float;
      Kind      : Scale := Linear)
   with Pre => Low < High and then (Kind = Linear or else Low > 0.0);
   --  Of all its curves; the axis may begin lower and end higher, at round
   --  values. Title has the unit.

   procedure Draw
     (C       : in out Chart;
      Curve   : Points;
      Name    : String;
      As      : Colour;
      Stepped : Boolean := False);
   --  Into the last panel; Name goes into its legend. Points that a line
   --  through their neighbours gives as well are left out. Stepped: a value
   --  holds until the next.

   procedure Mark (C : in out Chart; X : Float);
   --  A stroke on the axis of the last panel

   procedure Finish (C : in out Chart);

private

   type Chart is limited record
      File         : Svg_Files.Svg_File;
      Last_X       : Float := 1.0;
      Panels       : Natural := 0;
      --  begun so far
      Bottom       : Float := 0.0;
      --  of the last panel, pixels
      Low, High    : Float := 0.0;
      --  of its axis
      Kind         : Scale := Linear;
      Legend       : Float := 0.0;
      --  where its next name goes, pixels
   end record;

end Svg_Charts;
