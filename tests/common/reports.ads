--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a benchmark has measured: raw values, a line of JSON each on standard
--  output, for tests/bench/report.py, which makes figures of them.

with Samples;

package Reports is

   procedure Begin_Section (Name, Title : String);
   --  What is put from now on belongs to it

   procedure Put
     (Name  : String;
      Times : Samples.Set;
      Floor : Samples.Set := Samples.None;
      More  : String      := "");
   --  A row, whose name is its only one in its section. Floor: times to be
   --  compared with. More: more members of the JSON object

   procedure Put_Number
     (Name : String; Value : Float; Unit : String := "");
   --  A row of one figure

   procedure Put_Note (Text : String);
   --  A line of explanation under the table

   function Quoted (Text : String) return String;
   --  As JSON has it; a blank for each control character

   procedure Put_Members (Text : String);
   --  A line with these members of a JSON object

   function Member (Name : String; Time : Duration) return String is
     (", """ & Name & """:" & Integer'Image (Integer (1.0E6 * Time)));
   --  A member of a JSON object, in microseconds

end Reports;
