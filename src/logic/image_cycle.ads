--  SPDX-License-Identifier: GPL-3.0-or-later
--  One cycle of the periodic images (F15, F18): whether an image is looked
--  for, when the next cycle begins, which robots are still known, and what is
--  drawn and told. Decides; th_captureImg carries out.

with Following;
with Image_Grid;
with Monitor_Protocol;
with Options;
with Shapes;
with Vision_Mode;

package Image_Cycle with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Image_Cycle);
   --  A claim that GNATprove checks: every subprogram ends

   use type Following.State;
   use type Image_Grid.State;
   use type Options.Drawing_Kind;
   use type Shapes.Arena_Corners;

   subtype Microseconds is Image_Grid.Microseconds;

   type Work is
     (Leave,           --  the camera is closed
      Report_Silence,  --  it has delivered nothing for too long
      Look,            --  for an image to send
      Rest);           --  until the next cycle

   function Work_Of (Mode : Vision_Mode.State; Silent : Boolean) return Work
   is (if not Vision_Mode.Is_Open (Mode) then Leave
       elsif Silent then Report_Silence
       elsif Vision_Mode.Images_Flow (Mode) then Look
       else Rest);

   function Draws_Arena
     (Mode : Vision_Mode.State; Drawing : Options.Drawing_Kind) return Boolean
   is (Vision_Mode.Uses_Arena (Mode) and then Drawing >= Options.Arena);

   function Draws_Robots
     (Mode : Vision_Mode.State; Drawing : Options.Drawing_Kind) return Boolean
   is (Mode.Position_On and then Drawing = Options.All_Of_It);

   type State is record
      Grid   : Image_Grid.State := Image_Grid.Initial;
      Waited : Boolean := False;
      --  for an image, since the last instant of the grid
      Known  : Following.State;
      Arena  : Shapes.Arena_Corners := Shapes.No_Arena;
      --  in which Known were found
   end record;
   --  Initially no image has gone out, and no robot is known

   procedure Take_Image
     (S           : in out State;
      Late        : Microseconds;
      Age         : Microseconds;
      Has_Reserve : Boolean;
      Period      : Image_Grid.Period_Time;
      Length      : out Microseconds)
   with
     Post => Image_Grid.Has_Begun (S.Grid)
       and then Length in Image_Grid.Shortest (Period) .. Period
       and then not S.Waited
       and then S.Known = S'Old.Known
       and then S.Arena = S'Old.Arena;
   --  An image goes out that came Age ago and, where it was waited for, Late
   --  after the last instant; Has_Reserve: a newer one waits. The next
   --  instant is Length after this one

   procedure Look_In
     (S : in out State; Mode : Vision_Mode.State; Arena : Shapes.Arena_Corners)
   with
     Post => S.Grid = S'Old.Grid
       and then S.Waited = S'Old.Waited
       and then
         (if Mode.Position_On and then Arena = S'Old.Arena
          then S.Known = S'Old.Known and then S.Arena = S'Old.Arena
          else Following.Count (S.Known) = 0 and then S.Arena = Arena);
   --  Robots are searched in Arena, if at all: those known elsewhere, or
   --  before the search was off, are known no more

   function Position_Of
     (Robots : Shapes.Robot_Array; Count : Shapes.Robot_Count)
      return Monitor_Protocol.Position
   is (if Count = 0 then Monitor_Protocol.Not_Found
       else
         (Id    => Integer (Robots (1).Id),
          Angle => Monitor_Protocol.Micro (Robots (1).Angle),
          Cx    => Monitor_Protocol.Micro (Robots (1).Centre.X),
          Cy    => Monitor_Protocol.Micro (Robots (1).Centre.Y),
          Dx    => Monitor_Protocol.Micro (Robots (1).Direction.X),
          Dy    => Monitor_Protocol.Micro (Robots (1).Direction.Y)));
   --  What the monitor is told of Robots (1 .. Count): the first

end Image_Cycle;
