--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's position and the arena's ground, as the monitor is told of
--  them.

with Commands;
with Missions;
with Monitor.Protocol; use Monitor.Protocol;

package Monitor.Positions with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Positions);

   type Micro is range -10 ** 13 .. 10 ** 13;
   --  Millionths: of a pixel, or of a degree

   subtype Robot_Id is Integer range -1 .. 999;
   --  The number of a marker; -1 without a robot

   type Position is record
      Id     : Robot_Id := -1;
      Angle  : Micro    := 0;
      Cx, Cy : Micro    := 0;
      Dx, Dy : Micro    := 0;
   end record;
   --  Angle in degrees; centre (Cx, Cy) and direction (Dx, Dy) in pixels of
   --  the whole image

   Not_Found : constant Position :=
     (Id => -1, Angle => 0, Cx => -1_000_000, Cy => -1_000_000,
      Dx => 0, Dy => 0);
   --  No robot in the image: F18 requires identifier and centre; angle and
   --  direction are 0 as in the empty position of the existing platform

   function Position_Line (P : Position) return Short_Text;
   --  CPOS:id;angle;cx;cy;dx;dy and a line feed: the id as an integer, the
   --  others with exactly six decimals

   subtype Coordinate is Micro range -999_999_999 .. 9_999_999_999;
   --  In every image

   Ground_Label : constant Commands.Label_Text :=
     Commands.Table (Commands.Get_Ground).Label;

   type Corners is array (1 .. 8) of Coordinate;
   --  x and y of an arena's corners, clockwise from the upper left one

   function Ground
     (Size   : Missions.Arena_Size;
      Margin : Natural;
      Where  : Corners) return Short_Text
   with Pre => Margin <= 9;
   --  CARN:width;height;margin;x;y;x;y;x;y;x;y and a line feed: centimetres,
   --  then pixels with exactly six decimals. A mission's points keep Margin
   --  from the border

end Monitor.Positions;
