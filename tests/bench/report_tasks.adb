--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the tasks take of the processors under full load: images with
--  positions, 30 commands a second, two busy loops; for single commands; and
--  beside missions.

with Ada.Numerics.Float_Random;

with Bench_Settings;
with Busy_Loops;
with Instants;        use Instants;
with Mission_Drives;
with Own_Process;
with Plain_Numbers;   use Plain_Numbers;
with Reports;
with Rigs;            use Rigs;
with Service_Starts;
with Single_Commands;
with Task_Times;

procedure Report_Tasks is
   --  Compared with the budgets of the deadline analysis

   procedure Measure is
      use Ada.Numerics.Float_Random;

      R      : Rig;
      Load   : Busy_Loops.Load;
      Source : Generator;
      Start  : Instant;
      Amount : Natural := 0;

      procedure Ask (Command, Answer : String) is
         --  The next 15 to 45 ms after its answer
      begin
         R.Monitor.Expect (Command, Answer);
         delay 0.015 + 0.03 * Duration (Random (Source));
      end Ask;

   begin
      Service_Starts.Assemble (R, "--baud 9600");
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Load.Start;
      delay 2.0;

      Own_Process.Prefer_Real_Time (True);
      Reset (Source, 5544);
      Task_Times.Start (R.Supervisor.Pid);
      Start := Now;
      while Now - Start < Duration (Bench_Settings.Short_Seconds) loop
         Amount := Amount + 1;
         declare
            Value : constant String := Image (1 + Amount mod 9_000);
         begin
            case Amount mod 4 is
               when 0 =>
                  Ask ("RMOV:-" & Value, "AACK");
                  Ask ("RGST", "RCST");
               when 1 =>
                  Ask ("RTRN:" & Value, "AACK");
               when 2 =>
                  Ask ("RMOV:" & Value, "AACK");
                  Ask ("what", "ACER");
               when others =>
                  Ask ("RSTP", "AACK");
            end case;
         end;
      end loop;
      Own_Process.Prefer_Real_Time (False);
      Task_Times.Stop;
   end Measure;

begin
   Reports.Begin_Section
     ("tasks", "what one activity of a task takes under full load, for"
      & " single commands, and beside missions");
   Measure;
   Single_Commands.Measure_Tasks;
   Mission_Drives.Measure_Tasks;
   Task_Times.Print;
   Reports.End_Section;
end Report_Tasks;
