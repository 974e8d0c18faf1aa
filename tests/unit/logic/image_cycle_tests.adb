--  SPDX-License-Identifier: GPL-3.0-or-later
--  One cycle of the periodic images.

with AUnit.Assertions;   use AUnit.Assertions;

with Monitor.Positions;
with Options;
with Vision.Following;
with Vision.Image_Cycle; use Vision.Image_Cycle;
with Vision.Image_Grid;
with Vision.Mode;
with Vision.Shapes;
with Unit_Runs; use Unit_Runs;

package body Image_Cycle_Tests is

   use type Monitor.Positions.Position;
   use type Vision.Image_Grid.Microseconds;

   Period : constant := 100_000;

   Arena : constant Vision.Shapes.Arena_Corners := (others => (1, 2));

   Streaming : constant Vision.Mode.State :=
     (Vision.Mode.Streaming, True, True, Arena, others => <>);
   Deciding  : constant Vision.Mode.State :=
     (Vision.Mode.Deciding, True, True, Arena, others => <>);
   Plain     : constant Vision.Mode.State :=
     (Vision.Mode.Streaming, others => <>);
   Closed    : constant Vision.Mode.State := (others => <>);

   Robots : constant Vision.Shapes.Robot_Array :=
     (1      => (Id        => 7,
                 Centre    => (10, 20),
                 Direction => (30, 40),
                 Angle     => 50),
      others => <>);

   procedure Test_Grid is
      S      : State;
      Length : Vision.Image_Grid.Microseconds;
   begin
      Take_Image (S, 9_000, 0, False, Period, Length);
      Assert (Length = Period, "the first image begins the grid");
      Take_Image (S, 9_000, 0, False, Period, Length);
      Assert
        (Vision.Image_Grid.Lost (S.Grid) = 0, "not waited: nothing is lost");
      S.Waited := True;
      Take_Image (S, 9_000, 0, False, Period, Length);
      Assert (Vision.Image_Grid.Lost (S.Grid) = 9_000, "what was waited is");
      Assert (not S.Waited, "and nothing is waited for any more");
   end Test_Grid;

   procedure Test_Known is
      S     : State;
      Other : Vision.Mode.State := Streaming;
   begin
      Look_In (S, Streaming);
      Vision.Following.Begin_Anew (S.Known, Robots, 1);
      Look_In (S, Streaming);
      Assert (Vision.Following.Count (S.Known) = 1, "in the same arena");
      Other.Arena := Vision.Shapes.No_Arena;
      Look_In (S, Other);
      Assert (Vision.Following.Count (S.Known) = 0, "not in another");
      Vision.Following.Begin_Anew (S.Known, Robots, 1);
      Look_In (S, Plain);
      Assert (Vision.Following.Count (S.Known) = 0, "not when nobody looked");
   end Test_Known;

   procedure Test_Position is
   begin
      Assert (Position_Of (Robots, 0) = Monitor.Positions.Not_Found, "none");
      Assert
        (Position_Of (Robots, 2) =
           (Id => 7, Angle => 50, Cx => 10, Cy => 20, Dx => 30, Dy => 40),
         "the first");
   end Test_Position;

   procedure Test_Work is
   begin
      Assert (Work_Of (Closed, True) = Leave, "no camera");
      Assert (Work_Of (Streaming, True) = Report_Silence, "a silent one");
      Assert (Work_Of (Streaming, False) = Look, "images flow");
      Assert (Work_Of (Deciding, True) = Report_Silence, "silent, no images");
      Assert (Work_Of (Deciding, False) = Rest, "none until the decision");
      for Drawing in Options.Drawing_Kind loop
         Assert (not Draws_Arena (Plain, Drawing), "none is confirmed");
         Assert (not Draws_Robots (Plain, Drawing), "none is looked for");
         Assert
           (Draws_Arena (Streaming, Drawing) =
              (Drawing in Options.Arena | Options.All_Of_It),
            "arena: " & Drawing'Image);
         Assert
           (Draws_Robots (Streaming, Drawing) =
              (Drawing in Options.All_Of_It),
            "robots: " & Drawing'Image);
      end loop;
   end Test_Work;

   procedure Add_Tests is
   begin
      Add_Test ("what is done and drawn", Test_Work'Access);
      Add_Test ("an image that was waited for", Test_Grid'Access);
      Add_Test ("which robots are still known", Test_Known'Access);
      Add_Test ("what the monitor is told", Test_Position'Access);
   end Add_Tests;

end Image_Cycle_Tests;
