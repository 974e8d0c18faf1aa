--  SPDX-License-Identifier: GPL-3.0-or-later

with Commands;

package body Monitor.Notices with SPARK_Mode is

   function Image (Value : Percent) return String is
      Line : Short_Text;
   begin
      Numbers.Append (Value, 1, Line.Data, Line.Length);
      return Line.Data (1 .. Line.Length);
   end Image;

   function Progress_Line
     (Leg, Of_Legs : Point_Number; Distance : Millimetres) return Short_Text
   is
      Line : Short_Text;
   begin
      Append (Line, Progress_Label & Separator);
      Numbers.Append (Leg, 1, Line.Data, Line.Length);
      Append (Line, (1 => Field_Separator));
      Numbers.Append (Of_Legs, 1, Line.Data, Line.Length);
      Append (Line, (1 => Field_Separator));
      Numbers.Append (Distance, 1, Line.Data, Line.Length);
      Append (Line, (1 => Line_Feed));
      return Line;
   end Progress_Line;

   procedure Append (Line : in out Short_Text; Value : Micro)
   with
     Pre  => Line.Length <= Max_Short_Line - 19,
     Post => Line.Length
       <= Line.Length'Old + (if Value in Coordinate then 13 else 17)
   is
      --  A separator, and Value with six decimals
      Size : constant Micro := abs Value;
   begin
      Append (Line, Field_Separator & (if Value < 0 then "-" else ""));
      Numbers.Append
        (Numbers.Number (Size / 1_000_000), 1, Line.Data, Line.Length);
      Append (Line, ".");
      Numbers.Append
        (Numbers.Number (Size mod 1_000_000), 6, Line.Data, Line.Length);
   end Append;

   function Position_Line (P : Position) return Short_Text is
      Line : Short_Text;
   begin
      Append
        (Line, Position_Label & Separator & (if P.Id < 0 then "-" else ""));
      Numbers.Append (abs P.Id, 1, Line.Data, Line.Length);
      Append (Line, P.Angle);
      Append (Line, P.Cx);
      Append (Line, P.Cy);
      Append (Line, P.Dx);
      Append (Line, P.Dy);
      Append (Line, (1 => Line_Feed));
      return Line;
   end Position_Line;

   function Ground
     (Size   : Arena_Size;
      Margin : Natural;
      Where  : Corners) return Short_Text
   is
      Line : Short_Text;
   begin
      Append (Line, Commands.Table (Commands.Get_Ground).Label & Separator);
      Numbers.Append (Size.Width, 1, Line.Data, Line.Length);
      Append (Line, (1 => Field_Separator));
      Numbers.Append (Size.Height, 1, Line.Data, Line.Length);
      Append (Line, (1 => Field_Separator));
      Numbers.Append (Margin, 1, Line.Data, Line.Length);
      for I in Where'Range loop
         Append (Line, Where (I));
         pragma Loop_Invariant (Line.Length <= 16 + 13 * I);
      end loop;
      Append (Line, (1 => Line_Feed));
      return Line;
   end Ground;

end Monitor.Notices;
