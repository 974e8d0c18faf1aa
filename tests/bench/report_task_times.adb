--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the tasks take of the processors: under full load, for single
--  commands, and beside missions.

with Bench_Settings;
with Busy_Loops;
with Mission_Drives;
with Own_Process;
with Reports;
with Rigs; use Rigs;
with Service_Starts;
with Single_Commands;
with Task_Times;

procedure Report_Task_Times is

   procedure Measure_Full_Load is
      R    : Rig;
      Load : Busy_Loops.Load;
   begin
      Service_Starts.Assemble (R, "--baud 9600");
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Load.Start;
      Own_Process.Prefer_Real_Time (True);
      Task_Times.Start (R.Supervisor.Pid);
      Service_Starts.Drive (R, Duration (Bench_Settings.Short_Seconds));
      Own_Process.Prefer_Real_Time (False);
      Task_Times.Stop;
   end Measure_Full_Load;

begin
   Reports.Begin_Section
     ("tasks", "what one activity of a task takes: images with positions, 20"
      & " commands a second, and two busy loops; single commands; missions");
   Measure_Full_Load;
   Single_Commands;
   Mission_Drives.Measure_Tasks;
   Task_Times.Print;
   Reports.End_Section;
end Report_Task_Times;
