--  SPDX-License-Identifier: GPL-3.0-or-later
--  One cycle of the periodic images.

with AUnit.Assertions;   use AUnit.Assertions;

with Vision.Image_Cycle; use Vision.Image_Cycle;
with Vision.Image_Grid;
with Unit_Runs; use Unit_Runs;

procedure Image_Cycle_Tests is

   use type Vision.Image_Grid.Microseconds;

   Period : constant := 100_000;

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

begin
   Run_Test ("an image that was waited for", Test_Grid'Access);
end Image_Cycle_Tests;
