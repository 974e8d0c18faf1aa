--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long the supervisor takes to listen, and to be ready again when a
--  monitor has gone; how much memory it has.

with Ada.Directories;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;

with Bench_Settings;
with Both_Ends;         use Both_Ends;
with Child_Processes;   use Child_Processes;
with Emulators;
with Expectations;      use Expectations;
with Instants;          use Instants;
with Plain_Numbers;     use Plain_Numbers;
with Process_Facts;
with Programs;
with Reports;
with Samples;
with Supervisors;

procedure Report_Start_Times is

   function Recording return String is
     ("--trace " & Programs.Temporary_Folder & "/start.txt");

   procedure Time_Start
     (Program : String; Options : String; Set : in out Samples.Set)
   is
      --  To the line that says that it listens
      Process : Child;
      Begun   : constant Instant := Now;
      Line    : Natural;
   begin
      Process.Start (Program, Words (Options));
      Line := Process.Awaited (Errors, "listening", 10.0);
      Check (Line > 0, Program & " does not listen");
      Set.Add (Process.Element (Errors, Line).Time - Begun);
      Process.Stop;
   end Time_Start;

   function Megabytes
     (Process : Interfaces.C.int; Keys : String) return Float
   is
      --  The sum of these of the kernel's account of its memory
      Path   : constant String :=
        "/proc/" & Image (Integer (Process)) & "/smaps_rollup";
      Result : Float := 0.0;
   begin
      for Key of Words (Keys) loop
         declare
            Line : constant String :=
              Trim (Process_Facts.File_Line (Path, Key & ":"), Both);
         begin
            Result := Result + Float'Value
              (Line (Index (Line, ":") + 1 .. Line'Last - 3));
         end;
      end loop;
      return Result / 1024.0;
   end Megabytes;

   function Picture return String is
      --  An image of the arena in a file
      Path   : constant String := Programs.Temporary_Folder & "/start.jpg";
      Camera : Emulators.Emulator;
   begin
      if not Ada.Directories.Exists (Path) then
         Camera.Start (Camera => True);
         Camera.Save_Snapshot (Path);
      end if;
      return Path;
   end Picture;

   procedure Report_Memory is
      Supervisor : Supervisors.Supervisor;

      Plain, Recorded : Float;

      function Resident return Float is
        (Megabytes (Supervisor.Pid, "Rss"));

   begin
      Supervisor.Start (Recording);
      delay 0.5;
      Recorded := Resident;
      Supervisor.Stop;
      Supervisor.Start ("--camera " & Picture);
      delay 0.5;
      Plain := Resident;
      Reports.Put_Number ("memory without camera, resident", Plain, "MB",
                          Wanted => (1 => (Reports.Value, 20.0, False)));
      Reports.Put_Number
        ("memory without camera, resident, with --trace", Recorded, "MB",
         Floor  => Plain,
         Wanted => (1 => (Reports.Value, 20.0, False)));
      Reports.Put_Number
        ("memory without camera, its own alone",
         Megabytes (Supervisor.Pid, "Private_Clean Private_Dirty"), "MB");
      Connect (Ours, Supervisor.Port, By_Lines => True);
      Send (Ours, "COPN" & ASCII.LF);
      Await_Message (Ours, "AACK");
      delay 0.5;
      Reports.Put_Number
        ("memory with an image file as camera, resident", Resident, "MB");
      Close_All;
   end Report_Memory;

   procedure Report_Readiness is
      --  The robot drives; the monitor goes, and the next one has its first
      --  answer
      Supervisor : Supervisors.Supervisor;
      Ready      : Samples.Set;
      Begun      : Instant;
   begin
      Open_Line (Ours);
      Supervisor.Start ("--serial " & Device (Ours));
      Connect (Ours, Supervisor.Port, By_Lines => True);
      for Number in 1 .. Integer'Max (20, Bench_Settings.Sample_Count / 20)
      loop
         Forget (Ours);
         Send (Ours, "ROPN" & ASCII.LF & "RSOW" & ASCII.LF & "RGFW"
               & ASCII.LF);
         Await_Message (Ours, "AACK", Count => 3);
         Forget (Ours);
         Begun := Now;
         Disconnect (Ours);
         loop
            Connect (Ours, Supervisor.Port, By_Lines => True);
            Forget (Ours);
            Send (Ours, "RPIN" & ASCII.LF);
            Await_Message (Ours, "ANAK " & Gone);
            exit when Messages (Ours).Last_Element.Text = "ANAK";
            --  too early: the first counts as connected still
         end loop;
         Ready.Add (Messages (Ours).Last_Element.Ended - Begun);
      end loop;
      Close_All;
      Reports.Put
        ("monitor lost while driving, to the next one's first answer",
         Ready, (1 => (Reports.Max, 200_000.0, False)));
   end Report_Readiness;

   Listening : constant String := "--port 0 --bind 127.0.0.1";

   Ours, Bare, Recorded : Samples.Set;
begin
   Reports.Begin_Section ("start", "start, readiness and memory");
   for Number in 1 .. Integer'Max (10, Bench_Settings.Sample_Count / 40) loop
      Time_Start (Programs.Supervisor, Listening, Ours);
      Time_Start (Programs.Beside ("forwarder"), "start", Bare);
      Time_Start (Programs.Supervisor, Listening & " " & Recording, Recorded);
   end loop;
   Reports.Compare ("start to listening, to the bare forwarder", Ours, Bare,
                    (1 => (Reports.Median, 50_000.0, False)));
   Reports.Compare ("start to listening, with --trace", Recorded, Ours,
                    (1 => (Reports.Median_Ratio, 1.02, False)));
   Report_Readiness;
   Report_Memory;
   Reports.End_Section;
end Report_Start_Times;
