--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark says.

with Ada.Containers.Vectors;
with Ada.Directories;
with Ada.Numerics.Elementary_Functions;
use Ada.Numerics.Elementary_Functions;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

package body Reports is

   type Figure is range 1 .. 4;

   Shares : constant array (Figure) of Float := (0.5, 0.99, 0.999, 1.0);

   subtype Name_Text is String (1 .. 6);
   Titles : constant array (Figure) of Name_Text :=
     ("median", "   p99", " p99.9", "   max");
   Keys   : constant array (Figure) of Name_Text :=
     ("median", "p99   ", "p999  ", "max   ");

   Name_Width : constant := 56;
   Width      : constant := 11;

   type Curve is record
      Name  : Unbounded_String;
      Set   : Samples.Set;
      Floor : Boolean := False;
   end record;

   package Curve_Vectors is new Ada.Containers.Vectors (Positive, Curve);

   type Bar is record
      Name         : Unbounded_String;
      Unit         : Unbounded_String;
      Value, Floor : Float := 0.0;
   end record;

   package Bar_Vectors is new Ada.Containers.Vectors (Positive, Bar);

   Place    : Unbounded_String;
   Facts    : Unbounded_String;  --  JSON
   Sections : Unbounded_String;  --  JSON
   Rows     : Unbounded_String;  --  JSON, of the section that is open
   Section  : Unbounded_String;
   Title    : Unbounded_String;
   Curves   : Curve_Vectors.Vector;
   Bars     : Bar_Vectors.Vector;

   function Number (Value : Float; Digits_After : Natural := 3)
     return String;

   function Column (Text : String) return String is (Tail (Text, Width));

   function Micro (Value : Duration) return Float is
     (Float (Value) * 1.0E6);

   function Quoted (Text : String) return String;
   --  As JSON has it

   function Escaped (Text : String) return String;
   --  As SVG has it

   procedure Next (List : in out Unbounded_String; Item : String);
   --  One more of a list of JSON

   function Figures_Of (Set : Samples.Set) return String;
   --  As members of a JSON object

   procedure Put_Times (Name : String; Set : Samples.Set);
   procedure Put_Goal (Goal : String; Met : Boolean);

   function Goal_Of (Goal : String; Met : Boolean) return String;
   --  As members of a JSON object

   procedure Plot_Curves (File : File_Type);
   procedure Plot_Bars (File : File_Type);

   ------------
   -- Number --
   ------------

   function Number (Value : Float; Digits_After : Natural := 3)
     return String
   is
      package Float_Text is new Ada.Text_IO.Float_IO (Float);
      Text : String (1 .. 40);
   begin
      Float_Text.Put (Text, Value, Aft => Digits_After, Exp => 0);
      return Trim (Text, Both);
   end Number;

   ------------
   -- Quoted --
   ------------

   function Quoted (Text : String) return String is
      Result : Unbounded_String;
   begin
      for C of Text loop
         if C in '"' | '\' then
            Append (Result, '\');
         end if;
         Append (Result, (if C < ' ' then ' ' else C));
      end loop;
      return """" & To_String (Result) & """";
   end Quoted;

   -------------
   -- Escaped --
   -------------

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

   ----------
   -- Next --
   ----------

   procedure Next (List : in out Unbounded_String; Item : String) is
   begin
      if Length (List) > 0 then
         Append (List, "," & ASCII.LF);
      end if;
      Append (List, Item);
   end Next;

   ----------
   -- Open --
   ----------

   procedure Open (Path : String) is
   begin
      Ada.Directories.Create_Path (Path);
      Place := To_Unbounded_String (Ada.Directories.Full_Name (Path));
   end Open;

   function Folder return String is (To_String (Place));

   --------------
   -- Put_Fact --
   --------------

   procedure Put_Fact (Name, Value : String) is
   begin
      Put_Line (Name & ": " & Value);
      Next (Facts, Quoted (Name) & ": " & Quoted (Value));
   end Put_Fact;

   -------------------
   -- Begin_Section --
   -------------------

   procedure Begin_Section (Name, Title : String) is
   begin
      Section := To_Unbounded_String (Name);
      Reports.Title := To_Unbounded_String (Title);
      Rows := Null_Unbounded_String;
      Curves.Clear;
      Bars.Clear;
      New_Line;
      Put_Line (Name & ": " & Title);
      Put (Head ("   times in us", Name_Width) & Column ("n"));
      for F in Figure loop
         Put (Column (Titles (F)));
      end loop;
      New_Line;
   end Begin_Section;

   ----------------
   -- Figures_Of --
   ----------------

   function Figures_Of (Set : Samples.Set) return String is
      Result : Unbounded_String := To_Unbounded_String
        ("""n"": " & Trim (Set.Count'Image, Both));
   begin
      for F in Figure loop
         Append
           (Result,
            ", " & Quoted (Trim (Keys (F), Both)) & ": "
            & Number (Micro (Set.Quantile (Shares (F)))));
      end loop;
      return To_String (Result);
   end Figures_Of;

   -------------
   -- Goal_Of --
   -------------

   function Goal_Of (Goal : String; Met : Boolean) return String is
     (if Goal = "" then ""
      else ", ""goal"": " & Quoted (Goal) & ", ""met"": "
        & (if Met then "true" else "false"));

   ---------------
   -- Put_Times --
   ---------------

   procedure Put_Times (Name : String; Set : Samples.Set) is
   begin
      Put (Head ("   " & Name, Name_Width)
           & Column (Trim (Set.Count'Image, Both)));
      for F in Figure loop
         Put (Column (Number (Micro (Set.Quantile (Shares (F))), 1)));
      end loop;
      New_Line;
   end Put_Times;

   --------------
   -- Put_Goal --
   --------------

   procedure Put_Goal (Goal : String; Met : Boolean) is
   begin
      if Goal /= "" then
         Put_Line
           ("      goal " & Goal & (if Met then ": met" else ": NOT MET"));
      end if;
   end Put_Goal;

   -----------
   -- Ratio --
   -----------

   function Ratio
     (Ours, Floor : Samples.Set; Share : Float) return Float
   is
      Below : constant Float := Float (Floor.Quantile (Share));
   begin
      return (if Below > 0.0 then Float (Ours.Quantile (Share)) / Below
              else 0.0);
   end Ratio;

   -------------
   -- Compare --
   -------------

   procedure Compare
     (Name  : String;
      Ours  : Samples.Set;
      Floor : Samples.Set;
      Goal  : String  := "";
      Met   : Boolean := True)
   is
      Ratios : Unbounded_String;
   begin
      Put (Head (Name & ", ratio", Name_Width) & Column (""));
      for F in Figure loop
         declare
            Value : constant Float := Ratio (Ours, Floor, Shares (F));
         begin
            Put (Column (Number (Value, 2)));
            Next (Ratios, Quoted (Trim (Keys (F), Both)) & ": "
                  & Number (Value));
         end;
      end loop;
      New_Line;
      Put_Times ("this supervisor", Ours);
      Put_Times ("floor", Floor);
      Put_Goal (Goal, Met);
      Next
        (Rows,
         "{""name"": " & Quoted (Name) & ", ""unit"": ""us"", "
         & Figures_Of (Ours) & ", ""floor"": {" & Figures_Of (Floor)
         & "}, ""ratio"": {" & To_String (Ratios) & "}"
         & Goal_Of (Goal, Met) & "}");
      Curves.Append ((To_Unbounded_String (Name), Ours, False));
      Curves.Append
        ((To_Unbounded_String (Name & ", floor"), Floor, True));
   end Compare;

   ---------
   -- Put --
   ---------

   procedure Put
     (Name  : String;
      Ours  : Samples.Set;
      Goal  : String  := "";
      Met   : Boolean := True) is
   begin
      Put_Line (Name);
      Put_Times ("this supervisor", Ours);
      Put_Goal (Goal, Met);
      Next
        (Rows,
         "{""name"": " & Quoted (Name) & ", ""unit"": ""us"", "
         & Figures_Of (Ours) & Goal_Of (Goal, Met) & "}");
      Curves.Append ((To_Unbounded_String (Name), Ours, False));
   end Put;

   ----------------
   -- Put_Number --
   ----------------

   procedure Put_Number
     (Name  : String;
      Value : Float;
      Unit  : String;
      Floor : Float   := 0.0;
      Goal  : String  := "";
      Met   : Boolean := True) is
   begin
      Put_Line
        (Head (Name, Name_Width)
         & Column ((if Floor > 0.0 then Number (Value / Floor, 2) & " x"
                    else ""))
         & Column (Number (Value, 2)) & " " & Unit
         & (if Floor > 0.0 then ", floor " & Number (Floor, 2) else ""));
      Put_Goal (Goal, Met);
      Next
        (Rows,
         "{""name"": " & Quoted (Name) & ", ""unit"": " & Quoted (Unit)
         & ", ""value"": " & Number (Value)
         & (if Floor > 0.0
            then ", ""floor"": " & Number (Floor) & ", ""ratio"": "
              & Number (Value / Floor)
            else "")
         & Goal_Of (Goal, Met) & "}");
      Bars.Append
        ((To_Unbounded_String (Name), To_Unbounded_String (Unit),
          Value, Floor));
   end Put_Number;

   -----------
   -- Adopt --
   -----------

   procedure Adopt (Row : String) is

      function Member (Key : String) return String;
      --  Its value, without quotation marks

      function Member (Key : String) return String is
         Place : constant Natural := Index (Row, """" & Key & """:");
         First : constant Positive := Place + Key'Length + 3;
         Last  : Natural := First;
      begin
         if Place = 0 then
            return "";
         elsif Row (First) = '"' then
            return Row (First + 1 .. Index (Row, """", First + 1) - 1);
         end if;
         while Row (Last + 1) not in ',' | '}' loop
            Last := Last + 1;
         end loop;
         return Row (First .. Last);
      end Member;

      Name  : constant String := Member ("size") & " " & Member ("name");
      Floor : constant String := Member ("floor_median");
   begin
      Put (Head (Name, Name_Width) & Column (Member ("n")));
      for F in Figure loop
         Put (Column (Member (Trim (Keys (F), Both))));
      end loop;
      New_Line;
      if Floor not in "" | "null" then
         Put_Line
           ("   ratio " & Member ("ratio") & ", the floor's median "
            & Floor);
      end if;
      Next (Rows, Row);
      Bars.Append
        ((To_Unbounded_String (Name), To_Unbounded_String ("us"),
          Float'Value (Member ("median")),
          (if Floor in "" | "null" then 0.0 else Float'Value (Floor))));
   end Adopt;

   --------------
   -- Put_Note --
   --------------

   procedure Put_Note (Text : String) is
   begin
      Put_Line ("   " & Text);
      Next (Rows, "{""note"": " & Quoted (Text) & "}");
   end Put_Note;

   -----------------
   -- Plot_Curves --
   -----------------

   procedure Plot_Curves (File : File_Type) is

      --  Across: the time, logarithmic. Up: the share of samples that took
      --  no longer, each step a tenth of those that are left

      Left    : constant := 60.0;
      Right   : constant := 640.0;
      Top     : constant := 40.0;
      Bottom  : constant := 360.0;
      Decades : constant := 3.3;  --  up to 99.95 %
      Steps   : constant := 120;

      Colours : constant array (0 .. 5) of String (1 .. 7) :=
        ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#000000");

      Low, High : Float;

      function X (Value : Duration) return Float is
        (Left + (Right - Left)
         * (Log (Float'Max (Micro (Value), 0.1), 10.0) - Low)
         / (High - Low));

      function Y (Share : Float) return Float is
        (Bottom - (Bottom - Top)
         * Float'Min (1.0, -Log (Float'Max (1.0 - Share, 1.0E-6), 10.0)
                      / Decades));

      Grid : constant array (1 .. 5) of Float :=
        (0.0, 0.5, 0.9, 0.99, 0.999);
      Kind : Natural := 0;
   begin
      Low := 9.0;
      High := 0.0;
      for Item of Curves loop
         Low := Float'Min
           (Low, Float'Floor
              (Log (Float'Max (Micro (Item.Set.Quantile (0.0)), 0.1), 10.0)));
         High := Float'Max
           (High, Float'Ceiling
              (Log (Float'Max (Micro (Item.Set.Quantile (1.0)), 1.0), 10.0)));
      end loop;
      High := Float'Max (High, Low + 1.0);

      for Share of Grid loop
         Put_Line
           (File,
            "<line x1=""60"" x2=""640"" y1=""" & Number (Y (Share), 1)
            & """ y2=""" & Number (Y (Share), 1) & """ class=""g""/>"
            & "<text x=""55"" y=""" & Number (Y (Share) + 4.0, 1)
            & """ text-anchor=""end"">" & Number (Share * 100.0, 1)
            & " %</text>");
      end loop;
      for Decade in Integer (Low) .. Integer (High) loop
         declare
            Value : constant Float := 10.0 ** Decade;
            Along : constant String :=
              Number (X (Duration (Value / 1.0E6)), 1);
         begin
            Put_Line
              (File,
               "<line y1=""40"" y2=""360"" x1=""" & Along & """ x2="""
               & Along & """ class=""g""/><text x=""" & Along
               & """ y=""378"" text-anchor=""middle"">"
               & (if Value < 1.0 then Number (Value, 1)
                  elsif Value < 1000.0 then Number (Value, 0)
                    (1 .. Number (Value, 0)'Length - 2) & " us"
                  else Number (Value / 1000.0, 0)
                    (1 .. Number (Value / 1000.0, 0)'Length - 2) & " ms")
               & "</text>");
         end;
      end loop;

      for I in Curves.First_Index .. Curves.Last_Index loop
         declare
            Item   : constant Curve := Curves (I);
            Wanted : Samples.Share_Array (1 .. Steps);
            Dashes : constant String :=
              (if Item.Floor then " stroke-dasharray=""5 4""" else "");
         begin
            if not Item.Floor then
               Kind := Kind + 1;
            end if;
            for S in Wanted'Range loop
               Wanted (S) := 1.0
                 - 10.0 ** (-Decades * Float (S - 1) / Float (Steps - 1));
            end loop;
            Put (File, "<polyline fill=""none"" stroke="""
                 & Colours ((Kind - 1) mod 6) & """" & Dashes
                 & " points=""");
            declare
               Values : constant Samples.Value_Array :=
                 Item.Set.Quantiles (Wanted);
            begin
               for S in Wanted'Range loop
                  Put (File, Number (X (Values (S)), 1) & ","
                       & Number (Y (Wanted (S)), 1) & " ");
               end loop;
            end;
            Put_Line (File, """/>");
            declare
               Height : constant String :=
                 Number (400.0 + 18.0 * Float (I - 1), 1);
            begin
               Put_Line
                 (File,
                  "<line x1=""60"" x2=""100"" y1=""" & Height & """ y2="""
                  & Height & """ stroke=""" & Colours ((Kind - 1) mod 6)
                  & """" & Dashes & "/><text x=""108"" y=""" & Height
                  & """ dy=""4"">" & Escaped (To_String (Item.Name))
                  & "</text>");
            end;
         end;
      end loop;
   end Plot_Curves;

   ---------------
   -- Plot_Bars --
   ---------------

   procedure Plot_Bars (File : File_Type) is
      Most   : constant := 260.0;
      Height : Float := 400.0 + 18.0 * Float (Curves.Length);
   begin
      if Curves.Is_Empty then
         Height := 50.0;
      end if;
      for Item of Bars loop
         declare
            --  each with its own scale, for units differ
            Whole : constant Float :=
              Float'Max (Float'Max (Item.Value, Item.Floor), 1.0E-6);
         begin
            Put_Line
              (File,
               "<text x=""10"" y=""" & Number (Height + 11.0, 1) & """>"
               & Escaped (To_String (Item.Name)) & "</text>"
               & "<rect x=""300"" height=""12"" y=""" & Number (Height, 1)
               & """ width=""" & Number (Most * Item.Value / Whole, 1)
               & """ fill=""#0072b2""/>"
               & (if Item.Floor > 0.0
                  then "<rect x=""300"" height=""4"" y="""
                    & Number (Height + 12.0, 1) & """ width="""
                    & Number (Most * Item.Floor / Whole, 1)
                    & """ fill=""#999999""/>"
                  else "")
               & "<text x=""565"" y=""" & Number (Height + 11.0, 1) & """>"
               & Number (Item.Value, 2) & " "
               & Escaped (To_String (Item.Unit)) & "</text>");
         end;
         Height := Height + 22.0;
      end loop;
   end Plot_Bars;

   -----------------
   -- End_Section --
   -----------------

   procedure End_Section is
      File   : File_Type;
      Height : constant Natural :=
        60 + 22 * Natural (Bars.Length)
        + (if Curves.Is_Empty then 0
           else 350 + 18 * Natural (Curves.Length));
   begin
      Next
        (Sections,
         "{""name"": " & Quoted (To_String (Section)) & ", ""title"": "
         & Quoted (To_String (Title)) & ", ""rows"": [" & ASCII.LF
         & To_String (Rows) & "]}");
      Create (File, Out_File, Folder & "/" & To_String (Section) & ".svg");
      Put_Line
        (File,
         "<svg xmlns=""http://www.w3.org/2000/svg"" width=""700"" height="""
         & Trim (Height'Image, Both) & """ font-family=""sans-serif"""
         & " font-size=""12"" stroke-width=""1.5"">");
      Put_Line (File, "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->");
      Put_Line (File, "<style>.g { stroke: #ddd; }</style>");
      Put_Line (File, "<rect width=""100%"" height=""100%"" fill=""white""/>");
      Put_Line
        (File,
         "<text x=""10"" y=""22"" font-size=""15"">"
         & Escaped (To_String (Title)) & "</text>");
      if not Curves.Is_Empty then
         Plot_Curves (File);
      end if;
      Plot_Bars (File);
      Put_Line (File, "</svg>");
      Close (File);
   end End_Section;

   -----------
   -- Close --
   -----------

   procedure Close is
      File : File_Type;
   begin
      Create (File, Out_File, Folder & "/bench.json");
      Put_Line
        (File,
         "{" & To_String (Facts) & "," & ASCII.LF & """sections"": ["
         & ASCII.LF & To_String (Sections) & "]}");
      Close (File);
      New_Line;
      Put_Line ("results and plots: " & Folder);
   end Close;

end Reports;
