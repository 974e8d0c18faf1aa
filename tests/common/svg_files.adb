--  SPDX-License-Identifier: GPL-3.0-or-later
--  Drawings as SVG files.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

with Plain_Numbers;

package body Svg_Files is

   function Escaped (Text : String) return String;

   function Place (Name : String; Value : Float) return String is
     (" " & Name & "=""" & Decimal (Value) & """");
   --  An attribute

   function Of_Class (Class : String) return String is
     (if Class = "" then "" else " class=""" & Class & """");

   function Decimal (Value : Float; Most : Positive := 1) return String is
      Text : constant String := Plain_Numbers.Rounded (Value, Most);
      Last : Natural := Text'Last;
   begin
      while Text (Last) = '0' loop
         Last := Last - 1;
      end loop;
      if Text (Last) = '.' then
         Last := Last - 1;
      end if;
      return Text (Text'First .. Last);
   end Decimal;

   function Escaped (Text : String) return String is
      Result : Unbounded_String;
   begin
      for C of Text loop
         case C is
            when '<'    => Append (Result, "&lt;");
            when '>'    => Append (Result, "&gt;");
            when '&'    => Append (Result, "&amp;");
            when others => Append (Result, C);
         end case;
      end loop;
      return To_String (Result);
   end Escaped;

   procedure Create
     (Drawing       : in out Svg_File;
      Path          : String;
      Title         : String;
      Width, Height : Float;
      Style         : String) is
   begin
      Create (Drawing.File, Out_File, Path);
      Put_Line
        (Drawing.File,
         "<svg xmlns=""http://www.w3.org/2000/svg"" viewBox=""0 0 "
         & Decimal (Width) & " " & Decimal (Height) & """"
         & Place ("width", Width) & Place ("height", Height)
         & " role=""img"">");
      Put_Line
        (Drawing.File, "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->");
      Put_Line (Drawing.File, "<title>" & Escaped (Title) & "</title>");
      Put_Line (Drawing.File, "<style>" & Style & "</style>");
   end Create;

   procedure Put_Text
     (Drawing : in out Svg_File;
      X, Y    : Float;
      Text    : String;
      Anchor  : Anchor_Kind := First;
      Class   : String      := "") is
   begin
      Put_Line
        (Drawing.File,
         "<text" & Place ("x", X) & Place ("y", Y)
         & (case Anchor is
               when First  => "",
               when Middle => " text-anchor=""middle""",
               when Last   => " text-anchor=""end""")
         & Of_Class (Class) & ">" & Escaped (Text) & "</text>");
   end Put_Text;

   procedure Put_Stroke
     (Drawing : in out Svg_File; X1, Y1, X2, Y2 : Float; Class : String) is
   begin
      Put_Line
        (Drawing.File,
         "<line" & Place ("x1", X1) & Place ("y1", Y1) & Place ("x2", X2)
         & Place ("y2", Y2) & Of_Class (Class) & "/>");
   end Put_Stroke;

   procedure Put_Box
     (Drawing : in out Svg_File; X, Y, Width, Height : Float; Class : String)
   is
   begin
      Put_Line
        (Drawing.File,
         "<rect" & Place ("x", X) & Place ("y", Y) & Place ("width", Width)
         & Place ("height", Height) & Of_Class (Class) & "/>");
   end Put_Box;

   procedure Begin_Curve (Drawing : in out Svg_File; Class : String) is
   begin
      Put (Drawing.File, "<path" & Of_Class (Class) & " d=""");
      Drawing.Points := 0;
   end Begin_Curve;

   procedure Go_On (Drawing : in out Svg_File; X, Y : Float) is
      In_A_Line : constant := 8;
   begin
      Put
        (Drawing.File,
         (if Drawing.Points = 0 then "M" else "L") & Decimal (X) & " "
         & Decimal (Y));
      Drawing.Points := Drawing.Points + 1;
      if Drawing.Points mod In_A_Line = 0 then
         New_Line (Drawing.File);
      end if;
   end Go_On;

   procedure End_Curve (Drawing : in out Svg_File) is
   begin
      Put_Line (Drawing.File, """/>");
   end End_Curve;

   procedure Close (Drawing : in out Svg_File) is
   begin
      Put_Line (Drawing.File, "</svg>");
      Close (Drawing.File);
   end Close;

end Svg_Files;
