--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Positions with SPARK_Mode is

   procedure Append (Value : Micro; Line : in out Short_Line;
                     Last : in out Natural)
   with
     Pre  => Last in 6 .. Max_Short_Line - 21,
     Post => Last in Last'Old + 9 .. Last'Old + 17
       and then (for all I in 1 .. Last'Old => Line (I) = Line'Old (I))
       and then (for all I in Last'Old + 1 .. Last =>
                   Line (I) in '-' | '.' | '0' .. '9' | Field_Separator)
   is
      --  A separator, and Value with six decimals
      Size : constant Micro := abs Value;
   begin
      Last := Last + 1;
      Line (Last) := Field_Separator;
      if Value < 0 then
         Last := Last + 1;
         Line (Last) := '-';
      end if;
      Numbers.Append (Numbers.Number (Size / 1_000_000), 1, Line, Last);
      Last := Last + 1;
      Line (Last) := '.';
      Numbers.Append (Numbers.Number (Size mod 1_000_000), 6, Line, Last);
   end Append;

   procedure Format (P : Position; Line : out Short_Line; Last : out Natural)
   is
   begin
      Line := (others => ' ');
      Line (1 .. 4) := Position_Label;
      Line (5) := Separator;
      Last := 5;
      if P.Id < 0 then
         Line (6) := '-';
         Last := 6;
      end if;
      Numbers.Append (abs P.Id, 1, Line, Last);
      Append (P.Angle, Line, Last);
      Append (P.Cx, Line, Last);
      Append (P.Cy, Line, Last);
      Append (P.Dx, Line, Last);
      Append (P.Dy, Line, Last);
      Last := Last + 1;
      Line (Last) := Line_Feed;
   end Format;

end Monitor.Positions;
