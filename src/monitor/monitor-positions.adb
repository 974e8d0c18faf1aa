--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Positions with SPARK_Mode is

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
      Append_Number (Line, Numbers.Number (Size / 1_000_000));
      Append (Line, ".");
      Append_Number (Line, Numbers.Number (Size mod 1_000_000), 6);
   end Append;

   function Position_Line (P : Position) return Short_Text is
      Line : Short_Text;
   begin
      Append
        (Line, Position_Label & Separator & (if P.Id < 0 then "-" else ""));
      Append_Number (Line, abs P.Id);
      Append (Line, P.Angle);
      Append (Line, P.Cx);
      Append (Line, P.Cy);
      Append (Line, P.Dx);
      Append (Line, P.Dy);
      Append (Line, (1 => Line_Feed));
      return Line;
   end Position_Line;

   function Ground
     (Size   : Missions.Arena_Size;
      Margin : Natural;
      Where  : Corners) return Short_Text
   is
      Line : Short_Text;
   begin
      Append (Line, Ground_Label & Separator);
      Append_Number (Line, Size.Width);
      Append (Line, (1 => Field_Separator));
      Append_Number (Line, Size.Height);
      Append (Line, (1 => Field_Separator));
      Append_Number (Line, Margin);
      for I in Where'Range loop
         Append (Line, Where (I));
         pragma Loop_Invariant (Line.Length <= 16 + 13 * I);
      end loop;
      Append (Line, (1 => Line_Feed));
      return Line;
   end Ground;

end Monitor.Positions;
