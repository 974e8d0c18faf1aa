--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Robot_Sightings with SPARK_Mode is

   procedure Note
     (S      : in out Sighting;
      Came   : Ada.Real_Time.Time;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count) is
   begin
      S.Number := (if S.Number = Natural'Last then 1 else S.Number + 1);
      S.Came := Came;
      S.Seen := Count = 1;
      if S.Seen then
         S.Robot := Robots (1);
      end if;
   end Note;

end Vision.Robot_Sightings;
