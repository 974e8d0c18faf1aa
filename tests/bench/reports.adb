--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark says.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Containers.Vectors;
with Ada.Directories;
with Ada.Numerics.Elementary_Functions;
use Ada.Numerics.Elementary_Functions;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

with Expectations;          use Expectations;
with Json_Texts;            use Json_Texts;
with Plain_Numbers;         use Plain_Numbers;
with Svg_Files;             use Svg_Files;

package body Reports is

   subtype Time_Figure is Figure range Median .. Max;

   Shares : constant array (Time_Figure) of Float := (0.5, 0.99, 0.999, 1.0);

   subtype Name_Text is String (1 .. 6);
   Titles : constant array (Time_Figure) of Name_Text :=
     ("median", "   p99", " p99.9", "   max");

   Ratio_Of : constant array (Time_Figure) of Ratio_Figure :=
     (Median_Ratio, P99_Ratio, P999_Ratio, Max_Ratio);

   Name_Width : constant := 56;
   Width      : constant := 11;

   type Curve is record
      Name  : Unbounded_String;
      Set   : Samples.Set;
      Floor : Boolean := False;
      Again : Boolean := False;
      --  a second floor of the same times
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
   Row      : Unbounded_String;  --  JSON, of the row that is open
   Known    : array (Figure) of Float;  --  of that row
   Section  : Unbounded_String;
   Title    : Unbounded_String;
   Curves   : Curve_Vectors.Vector;
   Bars     : Bar_Vectors.Vector;

   function Column (Text : String) return String is (Tail (Text, Width));

   function Micro (Value : Duration) return Float is
     (Float (Value) * 1.0E6);

   procedure Next (List : in out Unbounded_String; Item : String);
   --  One more of a list of JSON

   function Key (Of_What : Figure) return String is
     (To_Lower (Of_What'Image));

   procedure Begin_Row (Name, Unit : String);

   procedure Note (Name : String; Value : Float);
   --  One more member of the row

   procedure Note (Of_What : Figure; Value : Float);
   --  The same, for a goal to be compared with

   procedure Note_Times (Set : Samples.Set);
   procedure Note_Floor (Set : Samples.Set);

   procedure End_Row (Wanted : Goals);
   --  Says which goals are met

   procedure Put_Times (Name : String; Set : Samples.Set);

   procedure Write_Sections;
   --  The JSON, as far as it goes

   procedure Plot_Curves (Drawing : in out Svg_File);
   procedure Plot_Bars (Drawing : in out Svg_File);

   procedure Next (List : in out Unbounded_String; Item : String) is
   begin
      if Length (List) > 0 then
         Append (List, "," & ASCII.LF);
      end if;
      Append (List, Item);
   end Next;

   procedure Open (Path : String) is
   begin
      Ada.Directories.Create_Path (Path);
      Place := To_Unbounded_String (Ada.Directories.Full_Name (Path));
   end Open;

   function Folder return String is (To_String (Place));

   procedure Put_Fact (Name, Value : String) is
   begin
      Put_Line (Name & ": " & Value);
      Next (Facts, Quoted (Name) & ": " & Quoted (Value));
   end Put_Fact;

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
      for F in Time_Figure loop
         Put (Column (Titles (F)));
      end loop;
      New_Line;
   end Begin_Section;

   procedure Begin_Row (Name, Unit : String) is
   begin
      Row := To_Unbounded_String
        ("{""name"": " & Quoted (Name) & ", ""unit"": " & Quoted (Unit));
   end Begin_Row;

   procedure Note (Name : String; Value : Float) is
   begin
      Append (Row, ", """ & Name & """: " & Rounded (Value, 3));
   end Note;

   procedure Note (Of_What : Figure; Value : Float) is
   begin
      Note (Key (Of_What), Value);
      Known (Of_What) := Value;
   end Note;

   procedure Note_Times (Set : Samples.Set) is
   begin
      Append (Row, ", ""n"": " & Image (Set.Count));
      for F in Time_Figure loop
         Note (F, Micro (Set.Quantile (Shares (F))));
      end loop;
   end Note_Times;

   procedure Note_Floor (Set : Samples.Set) is
   begin
      for F in Time_Figure loop
         declare
            Floor : constant Float := Micro (Set.Quantile (Shares (F)));
         begin
            Note ("floor_" & Key (F), Floor);
            Note
              (Ratio_Of (F), (if Floor > 0.0 then Known (F) / Floor else 0.0));
         end;
      end loop;
   end Note_Floor;

   procedure End_Row (Wanted : Goals) is
      List : Unbounded_String;
      Met  : Boolean;
   begin
      for G of Wanted loop
         Met := (if G.At_Least then Known (G.Of_What) >= G.Limit
                 else Known (G.Of_What) <= G.Limit);
         Put_Line
           ("      goal " & Key (G.Of_What)
            & (if G.At_Least then " >= " else " <= ") & Rounded (G.Limit)
            & (if Met then ": met" else ": NOT MET"));
         Append
           (List,
            (if Length (List) = 0 then "" else ", ")
            & """" & Key (G.Of_What) & """: {"""
            & (if G.At_Least then "at least" else "at most") & """: "
            & Rounded (G.Limit, 3) & ", ""met"": "
            & (if Met then "true" else "false") & "}");
      end loop;
      if Wanted'Length > 0 then
         Append (Row, ", ""goals"": {" & List & "}");
      end if;
      Next (Rows, To_String (Row) & "}");
   end End_Row;

   procedure Put_Times (Name : String; Set : Samples.Set) is
   begin
      Put (Head ("   " & Name, Name_Width)
           & Column (Image (Set.Count)));
      for F in Time_Figure loop
         Put (Column (Rounded (Micro (Set.Quantile (Shares (F))), 1)));
      end loop;
      New_Line;
   end Put_Times;

   procedure Compare
     (Name   : String;
      Ours   : Samples.Set;
      Floor  : Samples.Set;
      Wanted : Goals := No_Goals)
   is
      use type Samples.Set;
      Again  : constant Boolean :=
        (for some Item of Curves => not Item.Floor and then Item.Set = Ours);
   begin
      Check (Ours.Count > 0, Name & ": nothing measured");
      Begin_Row (Name, "us");
      Note_Times (Ours);
      Note_Floor (Floor);
      Put (Head (Name & ", ratio", Name_Width) & Column (""));
      for F in Time_Figure loop
         Put (Column (Rounded (Known (Ratio_Of (F)))));
      end loop;
      New_Line;
      Put_Times ("this supervisor", Ours);
      Put_Times ("floor", Floor);
      End_Row (Wanted);
      if not Again then
         Curves.Append ((To_Unbounded_String (Name), Ours, others => False));
      end if;
      Curves.Append
        ((To_Unbounded_String (Name & ", floor"), Floor, True, Again));
   end Compare;

   procedure Put
     (Name : String; Ours : Samples.Set; Wanted : Goals := No_Goals) is
   begin
      Check (Ours.Count > 0, Name & ": nothing measured");
      Begin_Row (Name, "us");
      Note_Times (Ours);
      Put_Line (Name);
      Put_Times ("this supervisor", Ours);
      End_Row (Wanted);
      Curves.Append ((To_Unbounded_String (Name), Ours, others => False));
   end Put;

   procedure Put_Deadline
     (Name : String; Ours : Samples.Set; Kept : Deadline)
   is
      procedure Put_Excess
        (Key, Excess : String; Limit : Duration; Count, Ran : Natural);

      procedure Put_Excess
        (Key, Excess : String; Limit : Duration; Count, Ran : Natural) is
      begin
         if Limit > 0.0 then
            Append
              (Row, ", """ & Key & """: " & Rounded (Micro (Limit), 0)
               & ", """ & Excess & """: " & Image (Count)
               & ", """ & Excess & "_ran"": " & Image (Ran));
            Put_Line
              ("      " & Key & " " & Rounded (Micro (Limit), 0)
               & ": " & Image (Count) & " are longer, "
               & Image (Ran) & " if stand-stills are taken out");
         end if;
      end Put_Excess;

   begin
      Check (Ours.Count > 0, Name & ": nothing measured");
      Begin_Row (Name, "us");
      Note_Times (Ours);
      Put_Line (Name);
      Put_Times ("this supervisor", Ours);
      Put_Excess
        ("bound", "longer", Kept.Bound, Kept.Longer, Kept.Longer_Ran);
      Put_Excess
        ("limit", "missed", Kept.Limit, Kept.Missed, Kept.Missed_Ran);
      if Kept.Limit = 0.0 then
         End_Row (No_Goals);
      elsif Kept.Of_All then
         Known (Missed_Ran) := Float (Kept.Missed_Ran);
         End_Row ((1 => (Missed_Ran, 0.0, False)));
      else
         End_Row ((1 => (P999, Micro (Kept.Limit), False)));
      end if;
      Curves.Append ((To_Unbounded_String (Name), Ours, others => False));
   end Put_Deadline;

   procedure Put_Number
     (Name   : String;
      Value  : Float;
      Unit   : String;
      Floor  : Float := No_Floor;
      Wanted : Goals := No_Goals) is
   begin
      Begin_Row (Name, Unit);
      Note (Reports.Value, Value);
      if Floor >= 0.0 then
         Note ("floor", Floor);
      end if;
      if Floor > 0.0 then
         Note (Ratio, Value / Floor);
      end if;
      Put_Line
        (Head (Name, Name_Width)
         & Column ((if Floor > 0.0 then Rounded (Value / Floor) & " x"
                    else ""))
         & Column (Rounded (Value)) & " " & Unit
         & (if Floor >= 0.0 then ", floor " & Rounded (Floor) else ""));
      End_Row (Wanted);
      Bars.Append
        ((To_Unbounded_String (Name), To_Unbounded_String (Unit),
          Value, Float'Max (Floor, 0.0)));
   end Put_Number;

   procedure Adopt (Row : String; Wanted : Goals := No_Goals) is

      function Member (Key : String) return String;
      --  Its value, without quotation marks

      function Number (Key : String) return Float is
        (Float'Value (Member (Key)));

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
      Floor : constant Float :=
        (if Member ("floor_median") in "" | "null" then No_Floor
         else Number ("floor_median"));
   begin
      if Member ("value") /= "" then
         Put_Number
           (Name, Number ("value"), Member ("unit"), Number ("floor"), Wanted);
         return;
      end if;
      Begin_Row (Name, "us");
      Append (Reports.Row, ", ""n"": " & Member ("n"));
      Put (Head (Name, Name_Width) & Column (Member ("n")));
      for F in Time_Figure loop
         Note (F, Number (Key (F)));
         Put (Column (Member (Key (F))));
      end loop;
      New_Line;
      if Floor > 0.0 then
         Note ("floor_median", Floor);
         Note (Median_Ratio, Known (Median) / Floor);
         Put_Line
           ("   ratio " & Rounded (Known (Median_Ratio))
            & ", the floor's median " & Rounded (Floor));
      end if;
      End_Row (Wanted);
      Bars.Append
        ((To_Unbounded_String (Name), To_Unbounded_String ("us"),
          Known (Median), Float'Max (Floor, 0.0)));
   end Adopt;

   procedure Put_Note (Text : String) is
   begin
      Put_Line ("   " & Text);
      Next (Rows, "{""note"": " & Quoted (Text) & "}");
   end Put_Note;

   procedure Plot_Curves (Drawing : in out Svg_File) is

      --  Across: the time, logarithmic. Up: the share of samples that took
      --  no longer, each step a tenth of those that are left

      Left    : constant := 60.0;
      Right   : constant := 640.0;
      Top     : constant := 40.0;
      Bottom  : constant := 360.0;
      Decades : constant := 3.3;  --  up to 99.95 %
      Steps   : constant := 120;

      Low, High : Float;

      function X (Value : Duration) return Float is
        (Left + (Right - Left)
         * (Log (Float'Max (Micro (Value), 0.1), 10.0) - Low)
         / (High - Low));

      function Y (Share : Float) return Float is
        (Bottom - (Bottom - Top)
         * Float'Min (1.0, -Log (Float'Max (1.0 - Share, 1.0E-6), 10.0)
                      / Decades));

      Grid   : constant array (1 .. 5) of Float :=
        (0.0, 0.5, 0.9, 0.99, 0.999);
      Wanted : Samples.Share_Array (1 .. Steps);
      Kind   : Natural := 0;
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
         Put_Stroke (Drawing, Left, Y (Share), Right, Y (Share), "g");
         Put_Text
           (Drawing, Left - 5.0, Y (Share) + 4.0,
            Rounded (Share * 100.0, 1) & " %", Last);
      end loop;
      for Decade in Integer (Low) .. Integer (High) loop
         declare
            Value : constant Float := 10.0 ** Decade;
            Along : constant Float := X (Duration (Value / 1.0E6));
         begin
            Put_Stroke (Drawing, Along, Top, Along, Bottom, "g");
            Put_Text
              (Drawing, Along, Bottom + 18.0,
               (if Value < 1000.0 then Decimal (Value) & " us"
                else Decimal (Value / 1000.0) & " ms"),
               Middle);
         end;
      end loop;

      for S in Wanted'Range loop
         Wanted (S) := 1.0
           - 10.0 ** (-Decades * Float (S - 1) / Float (Steps - 1));
      end loop;
      for I in Curves.First_Index .. Curves.Last_Index loop
         if not Curves (I).Floor then
            Kind := Kind + 1;
         end if;
         declare
            Item   : constant Curve := Curves (I);
            Values : constant Samples.Value_Array :=
              Item.Set.Quantiles (Wanted);
            Class  : constant String :=
              "c c" & Image ((Kind - 1) mod 6)
              & (if Item.Again then " again"
                 elsif Item.Floor then " floor" else "");
            Height : constant Float := 400.0 + 18.0 * Float (I - 1);
         begin
            Begin_Curve (Drawing, Class);
            for S in Wanted'Range loop
               Go_On (Drawing, X (Values (S)), Y (Wanted (S)));
            end loop;
            End_Curve (Drawing);
            Put_Stroke (Drawing, 60.0, Height, 100.0, Height, Class);
            Put_Text
              (Drawing, 108.0, Height + 4.0, To_String (Item.Name));
         end;
      end loop;
   end Plot_Curves;

   procedure Plot_Bars (Drawing : in out Svg_File) is
      Left   : constant := 300.0;
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
            Put_Text (Drawing, 10.0, Height + 11.0, To_String (Item.Name));
            Put_Box
              (Drawing, Left, Height, Most * Item.Value / Whole, 12.0, "ours");
            if Item.Floor > 0.0 then
               Put_Box
                 (Drawing, Left, Height + 12.0, Most * Item.Floor / Whole,
                  4.0, "below");
            end if;
            Put_Text
              (Drawing, Left + 265.0, Height + 11.0,
               Rounded (Item.Value) & " " & To_String (Item.Unit));
         end;
         Height := Height + 22.0;
      end loop;
   end Plot_Bars;

   procedure End_Section is
      Drawing : Svg_File;
      Width   : constant := 700.0;
      Height  : constant Float :=
        60.0 + 22.0 * Float (Bars.Length)
        + (if Curves.Is_Empty then 0.0
           else 350.0 + 18.0 * Float (Curves.Length));
   begin
      Next
        (Sections,
         "{""name"": " & Quoted (To_String (Section)) & ", ""title"": "
         & Quoted (To_String (Title)) & ", ""rows"": [" & ASCII.LF
         & To_String (Rows) & "]}");
      Create
        (Drawing, Folder & "/" & To_String (Section) & ".svg",
         To_String (Title), Width, Height,
         "text{font:12px sans-serif}.h{font-size:15px}"
         & ".page{fill:white}.g{stroke:#ddd;stroke-width:1.5}"
         & ".c{fill:none;stroke-width:1.5}"
         & ".floor{stroke-dasharray:5 4}.again{stroke-dasharray:2 3}"
         & ".c0{stroke:#0072b2}.c1{stroke:#d55e00}.c2{stroke:#009e73}"
         & ".c3{stroke:#cc79a7}.c4{stroke:#e69f00}.c5{stroke:#000000}"
         & ".ours{fill:#0072b2}.below{fill:#999999}");
      Put_Box (Drawing, 0.0, 0.0, Width, Height, "page");
      Put_Text (Drawing, 10.0, 22.0, To_String (Title), Class => "h");
      if not Curves.Is_Empty then
         Plot_Curves (Drawing);
      end if;
      Plot_Bars (Drawing);
      Close (Drawing);
      Write_Sections;
   end End_Section;

   procedure Write_Sections is
      File : File_Type;
   begin
      Create (File, Out_File, Folder & "/bench.json");
      Put_Line
        (File,
         "{" & To_String (Facts) & "," & ASCII.LF & """sections"": ["
         & ASCII.LF & To_String (Sections) & "]}");
      Close (File);
   end Write_Sections;

   procedure Close is
   begin
      Write_Sections;
      New_Line;
      Put_Line ("results and plots: " & Folder);
   end Close;

end Reports;
