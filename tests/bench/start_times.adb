--  SPDX-License-Identifier: GPL-3.0-or-later
--  Start, readiness and memory.

with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;

with Bench_Settings;
with Both_Ends;         use Both_Ends;
with Child_Processes;   use Child_Processes;
with Expectations;      use Expectations;
with Instants;          use Instants;
with Machines;
with Programs;
with Reports;
with Samples;
with Supervisors;

package body Start_Times is

   procedure Time_Start
     (Program : String; Options : String; Set : in out Samples.Set);
   --  To the line that says that it listens

   function Megabytes
     (Process : Interfaces.C.int; Keys : String) return Float;
   --  The sum of these of the kernel's account of its memory

   procedure Report_Memory;
   procedure Report_Readiness;

   ----------------
   -- Time_Start --
   ----------------

   procedure Time_Start
     (Program : String; Options : String; Set : in out Samples.Set)
   is
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

   ---------------
   -- Megabytes --
   ---------------

   function Megabytes
     (Process : Interfaces.C.int; Keys : String) return Float
   is
      Path   : constant String :=
        "/proc/" & Trim (Process'Image, Both) & "/smaps_rollup";
      Result : Float := 0.0;
   begin
      for Key of Words (Keys) loop
         declare
            Line : constant String :=
              Trim (Machines.File_Line (Path, Key & ":"), Both);
         begin
            Result := Result + Float'Value
              (Line (Index (Line, ":") + 1 .. Line'Last - 3));
         end;
      end loop;
      return Result / 1024.0;
   end Megabytes;

   -------------------
   -- Report_Memory --
   -------------------

   procedure Report_Memory is
      Supervisor : Supervisors.Supervisor;
      Libraries  : Child;

      procedure Put (Name, Keys : String; Goal : String := "");

      procedure Put (Name, Keys : String; Goal : String := "") is
         Value : constant Float := Megabytes (Supervisor.Pid, Keys);
      begin
         Reports.Put_Number
           (Name, Value, "MB", Megabytes (Libraries.Pid, Keys),
            Goal, Value < 20.0);
      end Put;

   begin
      Supervisor.Start;
      Libraries.Start (Programs.Beside ("libraries_alone"));
      Check
        (Libraries.Awaited (Errors, "listening", 10.0) > 0,
         "libraries_alone does not start");
      delay 0.5;
      Put ("memory without camera, resident", "Rss", "< 20 MB");
      Put ("the same, shared pages divided", "Pss");
      Put ("the same, its own alone", "Private_Clean Private_Dirty");
      Reports.Put_Number
        ("the same, beyond what the libraries take",
         Megabytes (Supervisor.Pid, "Rss")
         - Megabytes (Libraries.Pid, "Rss"), "MB");
   end Report_Memory;

   ----------------------
   -- Report_Readiness --
   ----------------------

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
            Send (Ours, "what" & ASCII.LF);
            Await_Message (Ours, "ACER " & Gone);
            exit when Messages (Ours).Last_Element.Text = "ACER";
            --  too early: the first counts as connected still
         end loop;
         Ready.Add (Messages (Ours).Last_Element.Ended - Begun);
      end loop;
      Close_All;
      Reports.Put
        ("monitor lost while driving, to the next one's first answer",
         Ready, "max < 200 ms", Ready.Quantile (1.0) < 0.200);
   end Report_Readiness;

   ------------
   -- Report --
   ------------

   procedure Report is
      Ours, Bare, Libraries : Samples.Set;
   begin
      Reports.Begin_Section
        ("start", "start, readiness and memory");
      for Number in 1 .. Integer'Max (10, Bench_Settings.Sample_Count / 40)
      loop
         Time_Start
           (Programs.Supervisor, "--port 0 --bind 127.0.0.1", Ours);
         Time_Start (Programs.Beside ("forwarder"), "start", Bare);
         Time_Start (Programs.Beside ("libraries_alone"), "", Libraries);
      end loop;
      Reports.Compare
        ("start, to the same libraries alone", Ours, Libraries,
         "median < 50 ms", Ours.Quantile (0.5) < 0.050);
      Reports.Compare ("start, to the bare forwarder", Ours, Bare);
      Report_Readiness;
      Report_Memory;
      Reports.End_Section;
   end Report;

end Start_Times;
