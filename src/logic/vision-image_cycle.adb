--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Image_Cycle with SPARK_Mode is

   procedure Take_Image
     (S           : in out State;
      Late        : Microseconds;
      Age         : Microseconds;
      Has_Reserve : Boolean;
      Period      : Vision.Image_Grid.Period_Time;
      Length      : out Microseconds) is
   begin
      if S.Waited then
         Vision.Image_Grid.Wait_Ended (S.Grid, Late, Period);
         S.Waited := False;
      end if;
      Vision.Image_Grid.Step (S.Grid, Age, Has_Reserve, Period, Length);
   end Take_Image;

   procedure Look_In (S : in out State; Mode : Vision.Mode.State) is
   begin
      if not Mode.Position_On or else Mode.Arena /= S.Arena then
         Vision.Following.Forget (S.Known);
         S.Arena := Mode.Arena;
      end if;
   end Look_In;

end Vision.Image_Cycle;
