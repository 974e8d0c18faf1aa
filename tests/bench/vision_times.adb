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

   procedure Measure;

   procedure Report (Section, Key, Title : String);
   --  Key: what the program calls the section

   procedure Measure is
      Program : Child;
      Limit   : constant Duration := 1_800.0;
   begin
      if not Measured then
         Measured := True;
         Program.Start
           (Programs.Beside ("image_times"),
            Words
              ("--json " & Results & " --samples"
               & Integer'Image
                   (Integer'Max (20, Bench_Settings.Sample_Count / 10))));
         Check
           (Program.Exit_Status (Within => Limit) = 0,
            "image_times has failed");
      end if;
   end Measure;

   procedure Report (Section, Key, Title : String) is
      File : File_Type;
   begin
      Reports.Begin_Section (Section, Title);
      Measure;
      Open (File, In_File, Results);
      while not End_Of_File (File) loop
         declare
            Row : constant String := Get_Line (File);
         begin
            if Index (Row, """section"":""" & Key & """") > 0 then
               Reports.Adopt (Trim (Row, Both));
            end if;
         end;
      end loop;
      Close (File);
      Reports.End_Section;
   end Report;

   procedure Report_Images is
   begin
      Report
        ("images", "image", "an image's way, from the camera to the socket");
   end Report_Images;

   procedure Report_Search is
   begin
      Report ("search", "search", "robots and arena in an image");
   end Report_Search;

end Vision_Times;
