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

   type Figure is
     (Value, Ratio, Median, P99, P999, Max,
      Median_Ratio, P99_Ratio, P999_Ratio, Max_Ratio);
   --  Of a row. Value and Ratio: of a number; the others: of times

   subtype Ratio_Figure is Figure range Median_Ratio .. Max_Ratio;

   type Goal is record
      Of_What  : Figure;
      Limit    : Float;
      --  in the unit of the row (times: us), or a ratio
      At_Least : Boolean := False;
      --  otherwise at most
   end record;

   type Goals is array (Positive range <>) of Goal;

   No_Goals : constant Goals (1 .. 0) := (others => (Value, 0.0, False));

   procedure Put
     (Name : String; Ours : Samples.Set; Wanted : Goals := No_Goals);
   --  Times without a floor. The name of a row is its only one in its section

   procedure Compare
     (Name   : String;
      Ours   : Samples.Set;
      Floor  : Samples.Set;
      Wanted : Goals := No_Goals);
   --  Times with those of the floor

   No_Floor : constant Float := -1.0;

   procedure Put_Number
     (Name   : String;
      Value  : Float;
      Unit   : String;
      Floor  : Float := No_Floor;
      Wanted : Goals := No_Goals);
   --  One figure, with the floor's if there is one

   procedure Adopt (Row : String; Wanted : Goals := No_Goals);
   --  A JSON row measured by another program: an object with name, size, unit
   --  and either n, median, p99, p999, max, and floor_median or null; or value
   --  and floor

   procedure Put_Note (Text : String);
   --  A line of explanation under the table

   procedure Close;
   --  Writes the JSON and prints the paths of the files

end Reports;
