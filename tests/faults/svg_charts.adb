--  SPDX-License-Identifier: GPL-3.0-or-later
--  Curves over time as an SVG file.

with Ada.Numerics.Elementary_Functions;
use  Ada.Numerics.Elementary_Functions;

package body Svg_Charts is

   use Svg_Files;

   --  Pixels
   Left          : constant := 64.0;
   Width         : constant := 720.0;
   Right_Margin  : constant := 16.0;
   Top           : constant := 40.0;
   Panel_Height  : constant := 120.0;
   Panel_Gap     : constant := 46.0;
   Character_Gap : constant := 8.0;

   Float_Steps : constant array (1 .. 3) of Float := (1.0, 2.0, 5.0);

   function Round_Step (Span : Float) return Float;
   --  1, 2 or 5 times a power of ten, some four of it in Span

   function Across (C : Chart; X : Float) return Float;
   function Down (C : Chart; Y : Float) return Float;
   --  Pixels

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

   function Across (C : Chart; X : Float) return Float is
     (Left + Width * X / C.Last_X);

   function Down (C : Chart; Y : Float) return Float is
      Part : constant Float :=
        (case C.Kind is
            when Linear      => (Y - C.Low) / (C.High - C.Low),
            when Logarithmic =>
               Log (Float'Max (Y, C.Low) / C.Low) / Log (C.High / C.Low));
   begin
      return C.Bottom - Panel_Height * Part;
   end Down;

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
      C.Last_X := Last_X;
      C.Panels := 0;
      --  of middling lightness, for no page has the same
      Create
        (C.File, Path, Title, Total_Width, Height,
         "text{font:12px sans-serif;fill:#808890}"
         & ".h{font-size:14px}"
         & ".g{stroke:#808890;stroke-opacity:.3}"
         & ".a{stroke:#808890;fill:none}"
         & ".c{fill:none;stroke-width:1.4;stroke-linejoin:round}"
         & ".blue{stroke:#3d8bfd}.orange{stroke:#e08600}"
         & ".green{stroke:#2da44e}"
         & ".t-blue{fill:#3d8bfd}.t-orange{fill:#e08600}"
         & ".t-green{fill:#2da44e}");
      Put_Text (C.File, Left, 20.0, Title, Class => "h");
      Put_Text
        (C.File, Left + Width, Height - 8.0, "time, " & Unit_X, Last);
   end Start;

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
         Place : constant Float := Down (C, Y);
      begin
         Put_Stroke (C.File, Left, Place, Left + Width, Place, "g");
         Put_Text (C.File, Left - 6.0, Place + 4.0, Decimal (Y, 3), Last);
      end Grid;

   begin
      C.Panels := C.Panels + 1;
      C.Bottom := Top
        + Float (C.Panels) * (Panel_Height + Panel_Gap) - Panel_Gap / 2.0;
      C.Kind   := Kind;
      C.Legend := Left + Width;
      Put_Text (C.File, Left, C.Bottom - Panel_Height - 8.0, Title);
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
      Begin_Curve (C.File, "a");
      Go_On (C.File, Left, C.Bottom - Panel_Height);
      Go_On (C.File, Left, C.Bottom);
      Go_On (C.File, Left + Width, C.Bottom);
      End_Curve (C.File);
      Value := 0.0;
      while Value < C.Last_X + Step / 2.0 loop
         if Value <= C.Last_X then
            Put_Stroke
              (C.File, Across (C, Value), C.Bottom, Across (C, Value),
               C.Bottom + 4.0, "a");
            Put_Text
              (C.File, Across (C, Value), C.Bottom + 16.0, Decimal (Value),
               Middle);
         end if;
         Value := Value + Step;
      end loop;
   end Begin_Panel;

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
      Before : Float := 0.0;
      --  the height of the point drawn last

      function On_The_Way (Number : Positive) return Boolean;
      --  It need not be drawn

      function On_The_Way (Number : Positive) return Boolean is
      begin
         return Number > 1
           and then Number < Curve.Last_Index
           and then Curve (Number - 1).Y = Curve (Number).Y
           and then Curve (Number + 1).Y = Curve (Number).Y;
      end On_The_Way;

   begin
      Begin_Curve (C.File, "c " & Class);
      for Number in 1 .. Curve.Last_Index loop
         if not On_The_Way (Number) then
            if Stepped and then Number > 1 then
               Go_On (C.File, Across (C, Curve (Number).X), Before);
            end if;
            Before := Down (C, Curve (Number).Y);
            Go_On (C.File, Across (C, Curve (Number).X), Before);
         end if;
      end loop;
      End_Curve (C.File);
      Put_Text
        (C.File, C.Legend, C.Bottom - Panel_Height - 8.0, Name, Last,
         "t-" & Class);
      C.Legend := C.Legend - Character_Gap * Float (Name'Length) - 16.0;
   end Draw;

   procedure Mark (C : in out Chart; X : Float) is
   begin
      Put_Stroke
        (C.File, Across (C, X), C.Bottom, Across (C, X), C.Bottom - 5.0,
         "a");
   end Mark;

   procedure Finish (C : in out Chart) is
   begin
      Close (C.File);
   end Finish;

end Svg_Charts;
