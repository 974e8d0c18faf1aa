--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Positions with SPARK_Mode is

   procedure Append (Value : Micro; Line : in out Short_Line;
                     Last : in out Natural)
   with
     Pre  => Last in 6 .. Max_Short_Line - 19
       and then (Last <= Max_Short_Line - 21 or else Value in Coordinate),
     Post => Last in Last'Old + 9
                  .. Last'Old + (if Value in Coordinate then 13 else 17)
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

   function Ground
     (Size   : Missions.Arena_Size;
      Margin : Natural;
      Where  : Corners) return Short_Text
   is
      Line : Short_Line := (others => ' ');
      Last : Natural    := 5;
   begin
      Line (1 .. 4) := Ground_Label;
      Line (5) := Separator;
      Numbers.Append (Size.Width, 1, Line, Last);
      Last := Last + 1;
      Line (Last) := Field_Separator;
      Numbers.Append (Size.Height, 1, Line, Last);
      Last := Last + 1;
      Line (Last) := Field_Separator;
      Numbers.Append (Margin, 1, Line, Last);
      for I in Where'Range loop
         Append (Where (I), Line, Last);
         pragma Loop_Invariant (Last in 10 + 9 * I .. 16 + 13 * I);
      end loop;
      Last := Last + 1;
      Line (Last) := Line_Feed;
      return (Line, Last);
   end Ground;

end Monitor.Positions;
