--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark says.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Directories;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

with Expectations;          use Expectations;
with Json_Texts;            use Json_Texts;
with Plain_Numbers;         use Plain_Numbers;

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

   Head_Of_Sections : constant String := """sections"": [" & ASCII.LF;
   End_Of_Sections  : constant String := "]}";
   --  In the file

   Place    : Unbounded_String;
   Facts    : Unbounded_String;  --  JSON
   Sections : Unbounded_String;  --  JSON
   Rows     : Unbounded_String;  --  JSON, of the section that is open
   Row      : Unbounded_String;  --  JSON, of the row that is open
   Known    : array (Figure) of Float;  --  of that row
   Section  : Unbounded_String;
   Title    : Unbounded_String;

   function Column (Text : String) return String is (Tail (Text, Width));

   function Micro (Value : Duration) return Float is
     (Float (Value) * 1.0E6);

   function Key (Of_What : Figure) return String is
     (To_Lower (Of_What'Image));

   procedure Note (Name : String; Value : Float) is
      --  One more member of the row
   begin
      Append (Row, ", """ & Name & """: " & Rounded (Value, 3));
   end Note;

   procedure Next (List : in out Unbounded_String; Item : String) is
      --  One more of a list of JSON
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

   procedure Note (Of_What : Figure; Value : Float) is
      --  The same, for a goal to be compared with
   begin
      Note (Key (Of_What), Value);
      Known (Of_What) := Value;
   end Note;

   procedure Begin_Times (Name : String; Set : Samples.Set) is
      --  A row of times
   begin
      Check (Set.Count > 0, Name & ": nothing measured");
      Begin_Row (Name, "us");
      Append (Row, ", ""n"": " & Image (Set.Count));
      for F in Time_Figure loop
         Note (F, Micro (Set.Quantile (Shares (F))));
      end loop;
   end Begin_Times;

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
      --  Says which goals are met
      List : Unbounded_String;
      Met  : Boolean;
   begin
      for G of Wanted loop
         Met := Known (G.Of_What) <= G.Most;
         Put_Line
           ("      goal " & Key (G.Of_What) & " <= " & Rounded (G.Most)
            & (if Met then ": met" else ": NOT MET"));
         Append (List,
                 (if Length (List) = 0 then "" else ", ")
                 & """" & Key (G.Of_What) & """: {""at most"": "
                 & Rounded (G.Most, 3) & ", ""met"": "
                 & (if Met then "true" else "false") & "}");
      end loop;
      if Wanted'Length > 0 then
         Append (Row, ", ""goals"": {" & List & "}");
      end if;
      Next (Rows, To_String (Row) & "}");
   end End_Row;

   procedure Put_Times (Name : String; Set : Samples.Set) is
   begin
      Put (Head ("   " & Name, Name_Width) & Column (Image (Set.Count)));
      for F in Time_Figure loop
         Put (Column (Rounded (Micro (Set.Quantile (Shares (F))), 1)));
      end loop;
      New_Line;
   end Put_Times;

   procedure Compare
     (Name   : String;
      Ours   : Samples.Set;
      Floor  : Samples.Set;
      Wanted : Goals := No_Goals) is
   begin
      Begin_Times (Name, Ours);
      Note_Floor (Floor);
      Put (Head (Name & ", ratio", Name_Width) & Column (""));
      for F in Time_Figure loop
         Put (Column (Rounded (Known (Ratio_Of (F)))));
      end loop;
      New_Line;
      Put_Times ("this supervisor", Ours);
      Put_Times ("floor", Floor);
      End_Row (Wanted);
   end Compare;

   procedure Put
     (Name : String; Ours : Samples.Set; Wanted : Goals := No_Goals) is
   begin
      Begin_Times (Name, Ours);
      Put_Line (Name);
      Put_Times ("this supervisor", Ours);
      End_Row (Wanted);
   end Put;

   procedure Put_Deadline
     (Name : String; Ours : Samples.Set; Kept : Deadline)
   is

      procedure Put_Excess
        (Key, Excess : String; Limit : Duration; Count, Ran : Natural) is
      begin
         if Limit > 0.0 then
            Append (Row, ", """ & Key & """: " & Rounded (Micro (Limit), 0)
                    & ", """ & Excess & """: " & Image (Count)
                    & ", """ & Excess & "_ran"": " & Image (Ran));
            Put_Line ("      " & Key & " " & Rounded (Micro (Limit), 0)
                      & ": " & Image (Count) & " are longer, "
                      & Image (Ran) & " if stand-stills are taken out");
         end if;
      end Put_Excess;

   begin
      Begin_Times (Name, Ours);
      Put_Line (Name);
      Put_Times ("this supervisor", Ours);
      Put_Excess ("bound", "longer", Kept.Bound, Kept.Longer, Kept.Longer_Ran);
      Put_Excess ("limit", "missed", Kept.Limit, Kept.Missed, Kept.Missed_Ran);
      if Kept.Limit = 0.0 then
         End_Row (No_Goals);
      elsif Kept.Of_All then
         Known (Missed_Ran) := Float (Kept.Missed_Ran);
         End_Row ((1 => (Missed_Ran, 0.0)));
      else
         End_Row ((1 => (P999, Micro (Kept.Limit))));
      end if;
   end Put_Deadline;

   procedure Put_Number
     (Name   : String;
      Value  : Float;
      Unit   : String;
      Wanted : Goals := No_Goals) is
   begin
      Begin_Row (Name, Unit);
      Note (Reports.Value, Value);
      Put_Line (Head (Name, Name_Width) & Column ("")
                & Column (Rounded (Value)) & " " & Unit);
      End_Row (Wanted);
   end Put_Number;

   procedure Adopt (Path : String) is
      File  : File_Type;
      Lines : Unbounded_String;
      First : Positive;
   begin
      Open (File, In_File, Path);
      while not End_Of_File (File) loop
         Append (Lines, Get_Line (File) & ASCII.LF);
      end loop;
      Close (File);
      First := Index (Lines, Head_Of_Sections) + Head_Of_Sections'Length;
      Next (Sections,
            Slice
              (Lines, First, Length (Lines) - End_Of_Sections'Length - 1));
   end Adopt;

   procedure Put_Note (Text : String) is
   begin
      Put_Line ("   " & Text);
      Next (Rows, "{""note"": " & Quoted (Text) & "}");
   end Put_Note;

   procedure Write_Sections is
      --  The JSON, as far as it goes
      File : File_Type;
   begin
      Create (File, Out_File, Folder & "/bench.json");
      Put_Line (File,
                "{" & To_String (Facts) & "," & ASCII.LF & Head_Of_Sections
                & To_String (Sections) & End_Of_Sections);
      Close (File);
   end Write_Sections;

   procedure End_Section is
   begin
      Next (Sections,
            "{""name"": " & Quoted (To_String (Section)) & ", ""title"": "
            & Quoted (To_String (Title)) & ", ""rows"": [" & ASCII.LF
            & To_String (Rows) & "]}");
      Write_Sections;
   end End_Section;

   procedure Close is
   begin
      Write_Sections;
      New_Line;
      Put_Line ("results: " & Folder & "/bench.json");
   end Close;

end Reports;
