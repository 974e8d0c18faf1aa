--  SPDX-License-Identifier: GPL-3.0-or-later
--  Curves over time as an SVG file.

with Ada.Float_Text_IO;
with Ada.Numerics.Elementary_Functions;
use  Ada.Numerics.Elementary_Functions;
with Ada.Strings;               use Ada.Strings;
with Ada.Strings.Fixed;         use Ada.Strings.Fixed;
with Ada.Text_IO;               use Ada.Text_IO;

package body Svg_Charts is

   --  Pixels
   Left          : constant := 64.0;
   Width         : constant := 720.0;
   Right_Margin  : constant := 16.0;
   Top           : constant := 40.0;
   Panel_Height  : constant := 120.0;
   Panel_Gap     : constant := 46.0;
   Character_Gap : constant := 8.0;

   Float_Steps : constant array (1 .. 3) of Float := (1.0, 2.0, 5.0);

   function Decimal (Value : Float; Aft : Natural := 1) return String;
   --  As short as it goes

   function Round_Step (Span : Float) return Float;
   --  1, 2 or 5 times a power of ten, some four of it in Span

   function Across (C : Chart; X : Float) return Float;
   function Down (C : Chart; Y : Float) return Float;
   --  Pixels

   function Escaped (Text : String) return String;

   procedure Put_Text
     (C : Chart; X, Y : Float; Anchor, Text : String; Class : String := "");

   -------------
   -- Decimal --
   -------------

   function Decimal (Value : Float; Aft : Natural := 1) return String is
      Text : String (1 .. 40);
      Last : Natural := Text'Last;
   begin
      Ada.Float_Text_IO.Put (Text, Value, Aft => Natural'Max (Aft, 1),
                             Exp => 0);
      while Text (Last) = '0' loop
         Last := Last - 1;
      end loop;
      if Text (Last) = '.' then
         Last := Last - 1;
      end if;
      return Trim (Text (1 .. Last), Both);
   end Decimal;

   ----------------
   -- Round_Step --
   ----------------

   function Round_Step (Span : Float) return Float is
      Power : constant Float := 10.0 ** Float'Floor (Log (Span / 4.0, 10.0));
   begin
      for Factor of Float_Steps loop
         if Factor * Power >= Span / 5.0 then
            return Factor * Power;
         end if;
      end loop;
      return 10.0 * Power;
   end Round_Step;

   ------------
   -- Across --
   ------------

   function Across (C : Chart; X : Float) return Float is
     (Left + Width * X / C.Last_X);

   ----------
   -- Down --
   ----------

   function Down (C : Chart; Y : Float) return Float is
      Part : constant Float :=
        (case C.Kind is
            when Linear      => (Y - C.Low) / (C.High - C.Low),
            when Logarithmic =>
               Log (Float'Max (Y, C.Low) / C.Low) / Log (C.High / C.Low));
   begin
      return C.Bottom - Panel_Height * Part;
   end Down;

   -------------
   -- Escaped --
   -------------

   function Escaped (Text : String) return String is
      Place : constant Natural := Index (Text, "<");
   begin
      return
        (if Place = 0 then Text
         else Text (Text'First .. Place - 1) & "&lt;"
           & Escaped (Text (Place + 1 .. Text'Last)));
   end Escaped;

   --------------
   -- Put_Text --
   --------------

   procedure Put_Text
     (C : Chart; X, Y : Float; Anchor, Text : String; Class : String := "")
   is
   begin
      Put_Line
        (C.File,
         "<text x=""" & Decimal (X) & """ y=""" & Decimal (Y)
         & """ text-anchor=""" & Anchor & """"
         & (if Class = "" then "" else " class=""" & Class & """")
         & ">" & Escaped (Text) & "</text>");
   end Put_Text;

   -----------
   -- Start --
   -----------

   procedure Start
     (C      : in out Chart;
      Path   : String;
      Title  : String;
      Last_X : Float;
      Unit_X : String;
      Panels : Positive)
   is
      Total_Width : constant Float := Left + Width + Right_Margin;
      Height      : constant Float :=
        Top + Float (Panels) * (Panel_Height + Panel_Gap) + 16.0;
   begin
      Create (C.File, Out_File, Path);
      C.Last_X := Last_X;
      C.Panels := 0;
      Put_Line
        (C.File,
         "<svg xmlns=""http://www.w3.org/2000/svg"" viewBox=""0 0 "
         & Decimal (Total_Width) & " " & Decimal (Height) & """ width="""
         & Decimal (Total_Width) & """ height=""" & Decimal (Height)
         & """ role=""img"">");
      Put_Line (C.File, "<title>" & Escaped (Title) & "</title>");
      --  of middling lightness, for no page has the same
      Put_Line
        (C.File,
         "<style>text{font:12px sans-serif;fill:#808890}"
         & ".h{font-size:14px}"
         & ".g{stroke:#808890;stroke-opacity:.3}"
         & ".a{stroke:#808890;fill:none}"
         & ".c{fill:none;stroke-width:1.4;stroke-linejoin:round}"
         & ".blue{stroke:#3d8bfd}.orange{stroke:#e08600}"
         & ".green{stroke:#2da44e}"
         & ".t-blue{fill:#3d8bfd}.t-orange{fill:#e08600}"
         & ".t-green{fill:#2da44e}</style>");
      Put_Text (C, Left, 20.0, "start", Title, "h");
      Put_Text
        (C, Left + Width, Height - 8.0, "end", "time, " & Unit_X);
   end Start;

   -----------------
   -- Begin_Panel --
   -----------------

   procedure Begin_Panel
     (C         : in out Chart;
      Title     : String;
      Low, High : Float;
      Kind      : Scale := Linear)
   is
      Step  : constant Float := Round_Step (C.Last_X);
      Value : Float;

      procedure Grid (Y : Float);

      procedure Grid (Y : Float) is
         Place : constant String := Decimal (Down (C, Y));
      begin
         Put_Line
           (C.File,
            "<path class=""g"" d=""M" & Decimal (Left) & " " & Place & "h"
            & Decimal (Width) & """/>");
         Put_Text (C, Left - 6.0, Down (C, Y) + 4.0, "end", Decimal (Y, 3));
      end Grid;

   begin
      C.Panels := C.Panels + 1;
      C.Bottom := Top
        + Float (C.Panels) * (Panel_Height + Panel_Gap) - Panel_Gap / 2.0;
      C.Kind   := Kind;
      C.Legend := Left + Width;
      Put_Text
        (C, Left, C.Bottom - Panel_Height - 8.0, "start", Title);
      case Kind is
         when Linear =>
            declare
               Step_Y : constant Float := Round_Step (High - Low);
            begin
               C.Low  := Float'Floor (Low / Step_Y) * Step_Y;
               C.High := Float'Ceiling (High / Step_Y) * Step_Y;
               Value  := C.Low;
               while Value < C.High + Step_Y / 2.0 loop
                  Grid (Value);
                  Value := Value + Step_Y;
               end loop;
            end;
         when Logarithmic =>
            C.Low  := 10.0 ** Float'Floor (Log (Low, 10.0));
            C.High := 10.0 ** Float'Ceiling (Log (High, 10.0));
            Value  := C.Low;
            while Value < C.High * 2.0 loop
               Grid (Value);
               Value := Value * 10.0;
            end loop;
      end case;
      Put_Line
        (C.File,
         "<path class=""a"" d=""M" & Decimal (Left) & " "
         & Decimal (C.Bottom - Panel_Height) & "v" & Decimal (Panel_Height)
         & "h" & Decimal (Width) & """/>");
      Value := 0.0;
      while Value < C.Last_X + Step / 2.0 loop
         if Value <= C.Last_X then
            Put_Line
              (C.File,
               "<path class=""a"" d=""M" & Decimal (Across (C, Value)) & " "
               & Decimal (C.Bottom) & "v4""/>");
            Put_Text
              (C, Across (C, Value), C.Bottom + 16.0, "middle",
               Decimal (Value));
         end if;
         Value := Value + Step;
      end loop;
   end Begin_Panel;

   ----------
   -- Draw --
   ----------

   procedure Draw
     (C       : in out Chart;
      Curve   : Points;
      Name    : String;
      As      : Colour;
      Stepped : Boolean := False)
   is
      Class : constant String :=
        (case As is
            when Blue   => "blue",
            when Orange => "orange",
            when Green  => "green");
      Begun  : Boolean := False;

      function On_The_Way (Number : Positive) return Boolean;
      --  It need not be drawn

      procedure Put_Point (P : Point);

      function On_The_Way (Number : Positive) return Boolean is
      begin
         return Number > 1
           and then Number < Curve.Last_Index
           and then Curve (Number - 1).Y = Curve (Number).Y
           and then Curve (Number + 1).Y = Curve (Number).Y;
      end On_The_Way;

      procedure Put_Point (P : Point) is
      begin
         if not Begun then
            Put (C.File, "M");
         elsif Stepped then
            Put (C.File, "H" & Decimal (Across (C, P.X)));
            Put (C.File, "V" & Decimal (Down (C, P.Y)));
            return;
         else
            Put (C.File, "L");
         end if;
         Put (C.File, Decimal (Across (C, P.X)) & " "
              & Decimal (Down (C, P.Y)));
      end Put_Point;

   begin
      Put (C.File, "<path class=""c " & Class & """ d=""");
      for Number in 1 .. Curve.Last_Index loop
         if not On_The_Way (Number) then
            Put_Point (Curve (Number));
            Begun := True;
            if Number mod 8 = 0 then
               New_Line (C.File);
            end if;
         end if;
      end loop;
      Put_Line (C.File, """/>");
      Put_Text
        (C, C.Legend, C.Bottom - Panel_Height - 8.0, "end", Name,
         "t-" & Class);
      C.Legend := C.Legend - Character_Gap * Float (Name'Length) - 16.0;
   end Draw;

   ----------
   -- Mark --
   ----------

   procedure Mark (C : in out Chart; X : Float) is
   begin
      Put_Line
        (C.File,
         "<path class=""a"" d=""M" & Decimal (Across (C, X)) & " "
         & Decimal (C.Bottom) & "v-5""/>");
   end Mark;

   ------------
   -- Finish --
   ------------

   procedure Finish (C : in out Chart) is
   begin
      Put_Line (C.File, "</svg>");
      Close (C.File);
   end Finish;

end Svg_Charts;
