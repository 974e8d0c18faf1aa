--  SPDX-License-Identifier: GPL-3.0-or-later
--  The output of the benchmark: a table per section on the terminal, and one
--  JSON file for all.

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
     (Value, Missed_Ran, Median, P99, P999, Max,
      Median_Ratio, P99_Ratio, P999_Ratio, Max_Ratio);
   --  Of a row. Value: of a number; the others: of times, and Missed_Ran of
   --  those that have a deadline

   subtype Ratio_Figure is Figure range Median_Ratio .. Max_Ratio;

   type Goal is record
      Of_What : Figure;
      Most    : Float;
      --  in the unit of the row (times: us), or a ratio
   end record;

   type Goals is array (Positive range <>) of Goal;

   No_Goals : constant Goals (1 .. 0) := (others => (Value, 0.0));

   procedure Put
     (Name : String; Ours : Samples.Set; Wanted : Goals := No_Goals);
   --  Times without a floor. The name of a row is its only one in its section

   procedure Compare
     (Name   : String;
      Ours   : Samples.Set;
      Floor  : Samples.Set;
      Wanted : Goals := No_Goals);
   --  Times with those of the floor

   --  Times that have deadlines

   type Deadline is record
      Bound       : Duration := 0.0;
      --  of the analysis, 0.0: none
      Longer      : Natural  := 0;
      --  how many times are above it
      Longer_Ran  : Natural  := 0;
      --  of these, how many would be if the machine had not stood still
      Limit       : Duration := 0.0;
      --  what is demanded, 0.0: nothing
      Of_All      : Boolean  := False;
      --  of every single one
      Missed      : Natural  := 0;
      Missed_Ran  : Natural  := 0;
      --  the same for the limit
   end record;

   procedure Put_Deadline (Name : String; Ours : Samples.Set; Kept : Deadline);
   --  Missed_Ran has the goal 0 where Kept.Of_All; otherwise the p99.9 has
   --  that of the limit

   procedure Put_Number
     (Name   : String;
      Value  : Float;
      Unit   : String;
      Wanted : Goals := No_Goals);
   --  One figure

   procedure Adopt (Path : String);
   --  The sections in the file of another program, which has printed them

   procedure Put_Note (Text : String);
   --  A line of explanation under the table

   procedure Close;
   --  Prints the path of the file. The JSON is written at the end of each
   --  section

end Reports;
