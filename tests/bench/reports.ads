--  SPDX-License-Identifier: GPL-3.0-or-later
--  The output of the benchmark: a table per section on the terminal, one JSON
--  file for all, and an SVG plot for each.

with Samples;

package Reports is

   procedure Open (Path : String);
   --  The folder for the files, made if missing

   function Folder return String;

   procedure Put_Fact (Name, Value : String);
   --  Facts on the machine, for the heads of table and file

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
   --  Times with those of the floor

   function Ratio
     (Ours, Floor : Samples.Set; Share : Float) return Float;
   --  Of the two quantiles; 0 if the floor has none

   procedure Put_Number
     (Name  : String;
      Value : Float;
      Unit  : String;
      Floor : Float   := 0.0;
      Goal  : String  := "";
      Met   : Boolean := True);
   --  One figure, with the floor's if there is one

   procedure Adopt (Row : String);
   --  A JSON row measured by another program: an object with name, size, n,
   --  median, p99, p999, max, and floor_median and ratio or null

   procedure Put_Note (Text : String);
   --  A line of explanation under the table

   procedure Close;
   --  Writes the JSON and prints the paths of the files

end Reports;
