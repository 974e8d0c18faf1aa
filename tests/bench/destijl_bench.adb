--  SPDX-License-Identifier: GPL-3.0-or-later
--  Prints what the supervisor takes, what the floor is, and the ratio: all
--  sections, or those named on the command line.

with Ada.Calendar.Formatting;
with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Environment_Variables;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;
with GNAT.OS_Lib;
with Interfaces.C;         use Interfaces.C;

with Bench_Settings;
with Both_Ends;
with Child_Processes;
with Deadline_Times;
with Expectations;
with Libc;
with Option_Readers;        use Option_Readers;
with Order_Times;
with Own_Process;
with Plain_Numbers;          use Plain_Numbers;
with Process_Facts;          use Process_Facts;
with Programs;
with Report_Period_Times;
with Report_Task_Times;
with Reports;
with System.Multiprocessors;
with Trace_Responses;

procedure Destijl_Bench is

   type Section is
     (Orders, Answers, Periods, Search, Tasks, Responses);

   Wanted : array (Section) of Boolean := (others => False);
   Folder : Unbounded_String;

   All_Kept    : Boolean := True;
   --  what is demanded of every single case
   Stood_Still : Boolean := False;

   function Attempts return Positive is
     (if Bench_Settings.Only_Checked then 3 else 1);

   LF : Character renames ASCII.LF;

   function Sections (From : Section) return String is
     (" " & To_Lower (From'Image)
      & (if From = Section'Last then "" else Sections (Section'Succ (From))));

   Usage : constant String :=
     "usage: destijl_bench [OPTION]... [SECTION]..." & LF
     & "sections (all of them):" & Sections (Section'First) & LF
     & "   --samples N   of each distribution (2000)" & LF
     & "   --seconds N   of each measurement that lasts (60)" & LF
     & "   --service     tasks, responses: as the unit starts" & LF
     & "                 it; the last from end to end," & LF
     & "                 too; tasks, traces two minutes at most" & LF
     & "   --check       the same, responses from end to end" & LF
     & "                 alone: fails if what is demanded of" & LF
     & "                 every single case is missed" & LF
     & "   --out FOLDER  for bench.json (a temporary one)" & LF
     & "   --file TRACE  for responses (one is made)" & LF
     & "   --supervisor PATH, --emulator PATH" & LF
     & "                 instead of those beside this one";

   procedure Read_Command_Line is
   begin
      while Next loop
         if Name = "--seconds" then
            Bench_Settings.Seconds := Number;
         elsif Name = "--samples" then
            Bench_Settings.Sample_Count := Number;
         elsif Name = "--service" then
            Bench_Settings.As_Service := True;
         elsif Name = "--check" then
            Bench_Settings.As_Service := True;
            Bench_Settings.Only_Checked := True;
         elsif Name = "--file" then
            Bench_Settings.Trace_File := To_Unbounded_String (Value);
         elsif Name = "--out" then
            Folder := To_Unbounded_String (Value);
         elsif (for some S in Section => S'Image = To_Upper (Name)) then
            Wanted (Section'Value (Name)) := True;
         else
            Programs.Read_Option (Usage);
         end if;
      end loop;
      if Bench_Settings.As_Service
        and then (Libc.Geteuid /= 0
                  or else not Own_Process.Real_Time_Allowed)
      then
         raise Bad_Usage with "--service is for root";
      end if;
      if Wanted = (Section => False) then
         Wanted := (others => True);
      end if;
   end Read_Command_Line;

   procedure Report_Machine is
      --  And the privileges of the measurement

      function Known (Text : String) return String is
        (if Text = "" then "none visible" else Text);

      Model : constant String := File_Line ("/proc/cpuinfo", "model name");
      Board : constant String :=
        File_Line ("/sys/firmware/devicetree/base/model");
      Cpu   : constant String := "/sys/devices/system/cpu/";
   begin
      Reports.Put_Fact
        ("machine",
         (if Board /= "" then Board
          elsif Model /= "" then
             Trim (Model (Index (Model, ":") + 1 .. Model'Last), Both)
          else "unknown processor")
         & "," & System.Multiprocessors.Number_Of_CPUs'Image & " cores"
         & (if File_Line ("/proc/cpuinfo", "hypervisor") = "" then ""
            else ", virtual"));
      Reports.Put_Fact
        ("kernel",
         File_Line ("/proc/sys/kernel/osrelease")
         & (if File_Line ("/sys/kernel/realtime", "1") = "1"
            then ", PREEMPT_RT" else ", not PREEMPT_RT"));
      Reports.Put_Fact
        ("governor",
         Known (File_Line (Cpu & "cpu0/cpufreq/scaling_governor"))
         & ", idle states: "
         & Known (File_Line (Cpu & "cpuidle/current_driver")));
      Reports.Put_Fact
        ("user",
         (if Libc.Geteuid = 0 then "root" else "an ordinary user")
         & (if Own_Process.Real_Time_Allowed then ", " else ", no ")
         & "real-time priorities");
      Reports.Put_Fact
        ("sources",
         Ada.Environment_Variables.Value ("DESTIJL_COMMIT", "unknown"));
      Reports.Put_Fact ("samples", Image (Bench_Settings.Sample_Count));
      Reports.Put_Fact ("seconds", Image (Bench_Settings.Seconds));
      Reports.Put_Fact
        ("begun", Ada.Calendar.Formatting.Image (Ada.Calendar.Clock)
         & " UTC");
   end Report_Machine;

   procedure Measure_Searches is
      --  By a program of its own, in the supervisor's language
      Program : Child_Processes.Child;
      Shown   : Natural := 0;
      Ended   : Boolean;
   begin
      Program.Launch
        (Programs.Beside ("image_times"),
         Child_Processes.Words
           ("--out " & Programs.Temporary_Folder & " --samples"
            & Integer'Image
                (Integer'Max (20, Bench_Settings.Sample_Count / 10))));
      loop
         Ended := not Program.Is_Running;
         if Ended then
            Expectations.Check
              (Program.Exit_Status = 0, "image_times has failed");
         end if;
         while Shown < Program.Count (Child_Processes.Output) loop
            Shown := Shown + 1;
            Ada.Text_IO.Put_Line
              (To_String
                 (Program.Element (Child_Processes.Output, Shown).Text));
         end loop;
         exit when Ended;
         delay 0.1;
      end loop;
      Reports.Adopt (Programs.Temporary_Folder & "/bench.json");
   end Measure_Searches;

   procedure Run (Which : Section) is
   begin
      case Which is
         when Orders  => Order_Times.Report_Orders;
         when Answers => Order_Times.Report_Answers;
         when Periods => Report_Period_Times;
         when Search  => Measure_Searches;
         when Tasks   => Report_Task_Times;
         when Responses =>
            if not Bench_Settings.Only_Checked then
               Trace_Responses.Report (To_String (Bench_Settings.Trace_File));
            end if;
      end case;
   end Run;

begin
   Own_Process.Ignore_Broken_Pipes;
   Read_Command_Line;
   Reports.Open
     (if Folder = "" then "/tmp/destijl_bench" else To_String (Folder));
   Report_Machine;
   for Which in Section loop
      if Wanted (Which) then
         Own_Process.Prefer_Real_Time (False);
         Both_Ends.Close_All;
         Run (Which);
         if Which = Responses and then Bench_Settings.As_Service then
            --  once, for it may take hours; a short check again where the
            --  machine stood still
            for Attempt in 1 .. Attempts loop
               Deadline_Times.Report (All_Kept, Stood_Still);
               exit when All_Kept or else not Stood_Still;
            end loop;
         end if;
      end if;
   end loop;
   Reports.Close;
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit
     (if Bench_Settings.Only_Checked and then not All_Kept then 1 else 0);

exception
   when Problem : others =>
      Programs.Give_Up (Problem);
end Destijl_Bench;
