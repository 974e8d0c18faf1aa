--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the monitor is told of a searched image, in its own types.

with Monitor.Positions;
with Vision.Shapes;

package Vision.Reports with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Reports);

   function Position_Of
     (Robots : Vision.Shapes.Robot_Array; Count : Vision.Shapes.Robot_Count)
      return Monitor.Positions.Position
   is (if Count = 0 then Monitor.Positions.Not_Found
       else
         (Id    => Integer (Robots (1).Id),
          Angle => Monitor.Positions.Micro (Robots (1).Angle),
          Cx    => Monitor.Positions.Micro (Robots (1).Centre.X),
          Cy    => Monitor.Positions.Micro (Robots (1).Centre.Y),
          Dx    => Monitor.Positions.Micro (Robots (1).Direction.X),
          Dy    => Monitor.Positions.Micro (Robots (1).Direction.Y)));
   --  The position reported to the monitor: that of Robots (1)

   function Are_Coordinates (Arena : Vision.Shapes.Arena_Corners)
     return Boolean
   is (for all P of Arena =>
         Monitor.Positions.Micro (P.X) in Monitor.Positions.Coordinate
         and then
           Monitor.Positions.Micro (P.Y) in Monitor.Positions.Coordinate);

   function Corners_Of (Arena : Vision.Shapes.Arena_Corners)
     return Monitor.Positions.Corners
   is (1 => Monitor.Positions.Micro (Arena (Vision.Shapes.Top_Left).X),
       2 => Monitor.Positions.Micro (Arena (Vision.Shapes.Top_Left).Y),
       3 => Monitor.Positions.Micro (Arena (Vision.Shapes.Top_Right).X),
       4 => Monitor.Positions.Micro (Arena (Vision.Shapes.Top_Right).Y),
       5 => Monitor.Positions.Micro (Arena (Vision.Shapes.Bottom_Right).X),
       6 => Monitor.Positions.Micro (Arena (Vision.Shapes.Bottom_Right).Y),
       7 => Monitor.Positions.Micro (Arena (Vision.Shapes.Bottom_Left).X),
       8 => Monitor.Positions.Micro (Arena (Vision.Shapes.Bottom_Left).Y))
   with Pre => Are_Coordinates (Arena);

end Vision.Reports;
