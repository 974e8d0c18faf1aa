--  SPDX-License-Identifier: GPL-3.0-or-later

with Commands;

package body Missions.Texts with SPARK_Mode is

   procedure Put_Number
     (Value  : Millimetres;
      Ending : Character;
      Line   : in out Short_Line;
      Last   : in out Natural)
   with
     Pre  => Last in 5 .. 32,
     Post => Last in Last'Old + 2 .. Last'Old + 9
       and then (for all I in 1 .. Last'Old => Line (I) = Line'Old (I))
       and then (for all I in Last'Old + 1 .. Last - 1 =>
                   Line (I) in '0' .. '9')
       and then Line (Last) = Ending;
   --  Appends Value and Ending

   procedure Begin_Line
     (Label : Commands.Label_Text; Line : out Short_Line; Last : out Natural)
   with
     Post => Last = 5
       and then Begins_With (Line, Label)
       and then Line (5) = Separator
   is
   begin
      Line := (others => ' ');
      Line (1 .. 4) := Label;
      Line (5) := Separator;
      Last := 5;
   end Begin_Line;

   procedure Format_End
     (Why      : Ending;
      Measured : Percent;
      Line     : out Short_Line;
      Last     : out Natural)
   is
      Text : constant String := Text_Of (Why, Measured);
   begin
      Begin_Line (End_Label, Line, Last);
      Line (Last + 1 .. Last + Text'Length) := Text;
      Last := Last + Text'Length + 1;
      Line (Last) := Line_Feed;
   end Format_End;

   procedure Format_Progress
     (Leg, Of_Legs : Point_Number;
      Distance     : Millimetres;
      Line         : out Short_Line;
      Last         : out Natural) is
   begin
      Begin_Line (Progress_Label, Line, Last);
      Put_Number (Leg, Field_Separator, Line, Last);
      Put_Number (Of_Legs, Field_Separator, Line, Last);
      Put_Number (Distance, Line_Feed, Line, Last);
   end Format_Progress;

   procedure Put_Number
     (Value  : Millimetres;
      Ending : Character;
      Line   : in out Short_Line;
      Last   : in out Natural) is
   begin
      Numbers.Append (Value, 1, Line, Last);
      Last := Last + 1;
      Line (Last) := Ending;
   end Put_Number;

end Missions.Texts;
