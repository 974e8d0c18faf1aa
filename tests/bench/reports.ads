--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the benchmark says: a table for each section on the terminal, all of
--  them in one file of JSON, and a plot for each in SVG.

with Samples;

package Reports is

   procedure Open (Path : String);
   --  The folder for the files, made where it is not there

   function Folder return String;

   procedure Put_Fact (Name, Value : String);
   --  Of the machine, for the head of table and file

   procedure Begin_Section (Name, Title : String);
   procedure End_Section;

   procedure Put
     (Name  : String;
      Ours  : Samples.Set;
      Goal  : String  := "";
      Met   : Boolean := True);
   --  Times without a floor

   procedure Compare
     (Name  : String;
      Ours  : Samples.Set;
      Floor : Samples.Set;
      Goal  : String  := "";
      Met   : Boolean := True);
   --  Times beside those of the floor

   function Ratio
     (Ours, Floor : Samples.Set; Share : Float) return Float;
   --  Of the two quantiles; 0 where the floor has none

   procedure Put_Number
     (Name  : String;
      Value : Float;
      Unit  : String;
      Floor : Float   := 0.0;
      Goal  : String  := "";
      Met   : Boolean := True);
   --  One figure, beside the floor's where there is one

   procedure Adopt (Row : String);
   --  A row of JSON that another program has measured: an object with name,
   --  size, n, median, p99, p999, max, and floor_median and ratio or null

   procedure Put_Note (Text : String);
   --  A line of explanation under the table

   procedure Close;
   --  Writes the JSON and says where the files are

end Reports;
