--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Image_Grid with SPARK_Mode is

   function Elapsed (First, Last : Time) return Microseconds is
      Longest : constant Integer := Integer (Microseconds'Last);
   begin
      return Microseconds
        (if Last - First >= Ada.Real_Time.Microseconds (Longest) then Longest
         else Integer'Max
           (0, Integer'Min
                 (Longest, (Last - First) / Ada.Real_Time.Microseconds (1))));
   end Elapsed;

   procedure Step
     (S           : in out State;
      Age         : Microseconds;
      Has_Reserve : Boolean;
      Period      : Period_Time;
      Length      : out Microseconds)
   is
      Made_Up : Microseconds := 0;
   begin
      S.Begun := True;
      S.Early :=
        (if Age < Early (Period) then 0
         else Natural'Min (Enough_Early, S.Early + 1));
      if Has_Reserve or else S.Early = Enough_Early then
         Made_Up := Microseconds'Min (S.Lost, Most_Made_Up (Period));
      end if;
      S.Lost := S.Lost - Made_Up;
      Length := Period - Made_Up;
   end Step;

   procedure Wait_Ended
     (S : in out State; Late : Microseconds; Period : Period_Time) is
   begin
      if S.Begun then
         S.Lost := Microseconds'Min (Most_Lost (Period), S.Lost + Late);
      end if;
      S.Early := 0;
   end Wait_Ended;

end Vision.Image_Grid;
