--  SPDX-License-Identifier: GPL-3.0-or-later
--  Curves over time as an SVG file: panels with a common time axis, readable
--  on light and dark pages.

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
   --  The time axis is 0 .. Last_X. Raises Name_Error or Use_Error if the file
   --  cannot be written.

   procedure Begin_Panel
     (C         : in out Chart;
      Title     : String;
      Low, High : Float;
      Kind      : Scale := Linear)
   with Pre => Low < High and then (Kind = Linear or else Low > 0.0);
   --  Range of all its curves; the axis is extended to round values. Title
   --  includes the unit.

   procedure Draw
     (C       : in out Chart;
      Curve   : Points;
      Name    : String;
      As      : Colour;
      Stepped : Boolean := False);
   --  Adds a curve to the last panel; Name is for its legend. Points on the
   --  line through their neighbours are omitted. Stepped: a value holds until
   --  the next.

   procedure Mark (C : in out Chart; X : Float);
   --  A mark on the axis of the last panel

   procedure Finish (C : in out Chart);

private

   type Chart is limited record
      File         : Svg_Files.Svg_File;
      Last_X       : Float := 1.0;
      Panels       : Natural := 0;
      --  started so far
      Bottom       : Float := 0.0;
      --  of the last panel, pixels
      Low, High    : Float := 0.0;
      --  of its axis
      Kind         : Scale := Linear;
      Legend       : Float := 0.0;
      --  position of the next name, pixels
   end record;

end Svg_Charts;
