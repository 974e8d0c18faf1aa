--  SPDX-License-Identifier: GPL-3.0-or-later
--  Images and searches.

with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;

with Bench_Settings;
with Child_Processes;   use Child_Processes;
with Expectations;      use Expectations;
with Programs;
with Reports;

package body Vision_Times is

   Measured : Boolean := False;

   function Results return String is
     (Programs.Temporary_Folder & "/image_times.json");

   procedure Measure is
      Program : Child;
   begin
      if not Measured then
         Program.Start
           (Programs.Beside ("image_times"),
            Words
              ("--json " & Results & " --samples"
               & Integer'Image
                   (Integer'Max (20, Bench_Settings.Sample_Count / 10))));
         while Program.Is_Running loop
            delay 0.1;
         end loop;
         Check (Program.Exit_Status = 0, "image_times has failed");
         Measured := True;
      end if;
   end Measure;

   function Goals_Of (Row : String) return Reports.Goals is
     (if Index (Row, """encode + base64 + send""") > 0
      then (1 => (Reports.Median_Ratio, 1.15, False))
      elsif Index (Row, """camera's JPEG passed through""") > 0
      then (1 => (Reports.Median, 100.0, False))
      elsif Index (Row, """search: following""") > 0
      then (1 => (Reports.Median_Ratio, 0.2, False))
      else Reports.No_Goals);

   procedure Report (Section, Title : String) is
      File : File_Type;
   begin
      Reports.Begin_Section (Section, Title);
      Measure;
      Open (File, In_File, Results);
      while not End_Of_File (File) loop
         declare
            Row : constant String := Get_Line (File);
         begin
            if Index (Row, """section"":""" & Section & """") > 0 then
               Reports.Adopt (Trim (Row, Both), Goals_Of (Row));
            end if;
         end;
      end loop;
      Close (File);
      Reports.End_Section;
   end Report;

   procedure Report_Images is
   begin
      Report
        ("images", "an image's way, from the camera to the socket");
   end Report_Images;

   procedure Report_Search is
   begin
      Report ("search", "robots and arena in an image");
   end Report_Search;

end Vision_Times;
