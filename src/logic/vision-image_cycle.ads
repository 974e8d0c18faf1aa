--  SPDX-License-Identifier: GPL-3.0-or-later
--  One cycle of the periodic images (F15, F18): whether to send an image, when
--  the next cycle starts, which robots are still known, and what is drawn and
--  reported. th_captureImg carries it out.

with Monitor.Positions;
with Options;
with Vision.Following;
with Vision.Image_Grid;
with Vision.Mode;
with Vision.Shapes;

package Vision.Image_Cycle with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Image_Cycle);

   use type Options.Drawing_Kind;
   use type Vision.Following.State;
   use type Vision.Image_Grid.State;
   use type Vision.Shapes.Arena_Corners;

   subtype Microseconds is Vision.Image_Grid.Microseconds;

   type Work is
     (Leave,           --  the camera is closed
      Report_Silence,  --  it has delivered nothing for too long
      Look,            --  look for an image to send
      Rest);           --  until the next cycle

   function Work_Of (Mode : Vision.Mode.State; Silent : Boolean) return Work
   is (if not Vision.Mode.Is_Open (Mode) then Leave
       elsif Silent then Report_Silence
       elsif Vision.Mode.Images_Flow (Mode) then Look
       else Rest);

   function Draws_Arena
     (Mode : Vision.Mode.State; Drawing : Options.Drawing_Kind) return Boolean
   is (Vision.Mode.Uses_Arena (Mode) and then Drawing >= Options.Arena);

   function Draws_Robots
     (Mode : Vision.Mode.State; Drawing : Options.Drawing_Kind) return Boolean
   is (Mode.Position_On and then Drawing = Options.All_Of_It);

   type State is record
      Grid   : Vision.Image_Grid.State := Vision.Image_Grid.Initial;
      Waited : Boolean := False;
      --  for an image, since the last instant of the grid
      Known  : Vision.Following.State;
      Arena  : Vision.Shapes.Arena_Corners := Vision.Shapes.No_Arena;
      --  the arena in which Known were found
   end record;
   --  Initially no image has been sent, and no robot is known

   procedure Take_Image
     (S           : in out State;
      Late        : Microseconds;
      Age         : Microseconds;
      Has_Reserve : Boolean;
      Period      : Vision.Image_Grid.Period_Time;
      Length      : out Microseconds)
   with
     Post => Vision.Image_Grid.Has_Begun (S.Grid)
       and then Length in Vision.Image_Grid.Shortest (Period) .. Period
       and then not S.Waited
       and then S.Known = S'Old.Known
       and then S.Arena = S'Old.Arena;
   --  Called when an image is sent that arrived Age ago. If the sender had to
   --  wait for it, it arrived Late after the last instant of the grid.
   --  Has_Reserve: a newer image is already there. Length: time to the next
   --  instant

   procedure Look_In
     (S : in out State; Mode : Vision.Mode.State)
   with
     Post => S.Grid = S'Old.Grid
       and then S.Waited = S'Old.Waited
       and then
         (if Mode.Position_On and then Mode.Arena = S'Old.Arena
          then S.Known = S'Old.Known and then S.Arena = S'Old.Arena
          else Vision.Following.Count (S.Known) = 0
            and then S.Arena = Mode.Arena);
   --  Robots are searched in the mode's arena, if at all. Robots known from
   --  another arena, or from before a pause of the search, are forgotten

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

end Vision.Image_Cycle;
