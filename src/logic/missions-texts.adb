--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Texts with SPARK_Mode is

   function Image (Value : Percent) return String is
      Line : Short_Text;
   begin
      Numbers.Append (Value, 1, Line.Data, Line.Length);
      return Line.Data (1 .. Line.Length);
   end Image;

   procedure Put_Number
     (Line : in out Short_Text; Value : Millimetres; Ending : Character)
   with
     Pre  => Line.Length in 5 .. 32,
     Post => Line.Length in Line.Length'Old + 2 .. Line.Length'Old + 9
       and then (for all I in 1 .. Line.Length'Old =>
                   Line.Data (I) = Line.Data'Old (I))
       and then (for all I in Line.Length'Old + 1 .. Line.Length - 1 =>
                   Line.Data (I) in '0' .. '9')
       and then Line.Data (Line.Length) = Ending
   is
      --  Appends Value and Ending
   begin
      Numbers.Append (Value, 1, Line.Data, Line.Length);
      Line.Length := Line.Length + 1;
      Line.Data (Line.Length) := Ending;
   end Put_Number;

   function Progress_Line
     (Leg, Of_Legs : Point_Number; Distance : Millimetres) return Short_Text
   is
      Line : Short_Text;
   begin
      Line.Data (1 .. 5) := Progress_Label & Separator;
      Line.Length := 5;
      Put_Number (Line, Leg, Field_Separator);
      Put_Number (Line, Of_Legs, Field_Separator);
      Put_Number (Line, Distance, Line_Feed);
      return Line;
   end Progress_Line;

end Missions.Texts;
