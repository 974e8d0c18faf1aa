--  SPDX-License-Identifier: GPL-3.0-or-later
--  The machine and the privileges of the measurement.

with Ada.Calendar.Formatting;
with Ada.Environment_Variables;
with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Interfaces.C;      use Interfaces.C;
with System.Multiprocessors;

with Bench_Settings;
with Libc;
with Own_Process;
with Plain_Numbers; use Plain_Numbers;
with Process_Facts; use Process_Facts;
with Reports;

procedure Report_Machine is

   function Known (Text, Otherwise : String) return String is
     (if Text = "" then Otherwise else Text);

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
   Reports.Put_Fact ("kernel",
                     File_Line ("/proc/sys/kernel/osrelease")
                     & (if File_Line ("/sys/kernel/realtime", "1") = "1"
                        then ", PREEMPT_RT" else ", not PREEMPT_RT"));
   Reports.Put_Fact ("governor",
                     Known (File_Line (Cpu & "cpu0/cpufreq/scaling_governor"),
                            "none visible")
                     & ", idle states: "
                     & Known (File_Line (Cpu & "cpuidle/current_driver"),
                              "none visible"));
   Reports.Put_Fact ("user",
                     (if Libc.Geteuid = 0 then "root" else "an ordinary user")
                     & (if Own_Process.Real_Time_Allowed
                        then ", real-time priorities"
                        else ", no real-time priorities"));
   Reports.Put_Fact
     ("sources",
      Ada.Environment_Variables.Value ("DESTIJL_COMMIT", "unknown"));
   Reports.Put_Fact ("samples", Image (Bench_Settings.Sample_Count));
   Reports.Put_Fact ("seconds", Image (Bench_Settings.Seconds));
   Reports.Put_Fact
     ("begun", Ada.Calendar.Formatting.Image (Ada.Calendar.Clock)
      & " UTC");
end Report_Machine;
