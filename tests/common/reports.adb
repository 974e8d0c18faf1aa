--  SPDX-License-Identifier: GPL-3.0-or-later
--  The lines of a benchmark.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

with Expectations;          use Expectations;
with Plain_Numbers;         use Plain_Numbers;

package body Reports is

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

   procedure Put_Members (Text : String) is
   begin
      Put_Line ("{" & Text & "}");
      Flush;
   end Put_Members;

   procedure Begin_Section (Name, Title : String) is
   begin
      Put_Members
        ("""section"": " & Quoted (Name) & ", ""title"": " & Quoted (Title));
   end Begin_Section;

   function List (Times : Samples.Set) return String is
      Text : Unbounded_String;
   begin
      for Place in 1 .. Times.Count loop
         Append
           (Text, (if Place = 1 then "" else ",")
            & Long_Long_Integer'Image
                (Long_Long_Integer'Integer_Value (Times.Element (Place))));
      end loop;
      return "[" & To_String (Text) & "]";
   end List;

   procedure Put
     (Name  : String;
      Times : Samples.Set;
      Floor : Samples.Set := Samples.None;
      More  : String      := "") is
   begin
      Check (Times.Count > 0, Name & ": nothing measured");
      Put_Members
        ("""name"": " & Quoted (Name) & ", ""ns"": " & List (Times)
         & (if Floor.Count = 0 then "" else ", ""floor"": " & List (Floor))
         & More);
   end Put;

   procedure Put_Number
     (Name : String; Value : Float; Unit : String := "") is
   begin
      Put_Members
        ("""name"": " & Quoted (Name) & ", ""value"": " & Rounded (Value, 3)
         & ", ""unit"": " & Quoted (Unit));
   end Put_Number;

   procedure Put_Note (Text : String) is
   begin
      Put_Members ("""note"": " & Quoted (Text));
   end Put_Note;

end Reports;
