--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the tasks take of the processors, with two busy loops: under full
--  load, for single commands, and beside missions.

with Bench_Settings;
with Busy_Loops;
with Child_Processes;
with Expectations;    use Expectations;
with Floods;
with Instants;        use Instants;
with Libc;
with Monitor_Clients; use Monitor_Clients;
with Reports;
with Rigs;            use Rigs;
with Loads;
with Task_Times;

procedure Report_Task_Times is

   Pause : constant Duration := 0.02;
   --  between two commands: no task has anything left to do

   procedure Say (R : in out Rig; Script : String) is
      --  Commands, one after the other, each answered AACK. Behind it: + the
      --  supervisor asks the robot once; = ACER, ! an image, ? any answer, .
      --  none
      Unused : Message;
   begin
      for Word of Child_Processes.Words (Script) loop
         declare
            Command : constant String := Word (Word'First .. Word'Last - 1);
         begin
            case Word (Word'Last) is
               when '+' =>
                  Task_Times.Begin_Exchange;
                  R.Monitor.Expect (Command, "AACK");
                  delay Pause;
                  Task_Times.End_Exchange;
               when '!' =>
                  R.Monitor.Skip_To_Now;
                  R.Monitor.Send_Line (Command);
                  Unused := R.Monitor.Next_Of ("CIMG");
                  Check (Unused.Size > 0, Command & " is not answered");
                  delay 10 * Pause;
                  --  the image may have been one on its way
               when '?' =>
                  Unused := R.Monitor.Ask (Command);
               when '.' =>
                  R.Monitor.Send_Line (Command);
               when '=' =>
                  R.Monitor.Expect (Command, "ACER");
               when others =>
                  R.Monitor.Expect (Word, "AACK");
            end case;
            delay Pause;
         end;
      end loop;
   end Say;

   procedure Ask_Robot (R : in out Rig) is
   begin
      for Round in 1 .. 4 loop
         Say (R, "ROPN RSOW+ RGFW+ RMOV:100+ RTRN:-90+ RSTP+ RPIN+ RLDW RGBT?"
              & " RGST? MSSG:alone. what= RRST RSWW+ RRST RCLS");
      end loop;
   end Ask_Robot;

   procedure Ask_Camera (R : in out Rig) is
   begin
      Say (R, "COPN CASA! CAIN. CASA! CACO. CPCO");
      delay 0.5;
      Say (R, "CPST CCLS");
   end Ask_Camera;

   procedure Turn_Away (R : in out Rig) is
      --  One by one, then more at once than are seen to in a turn
      Crowd : Floods.Crowd (40);
   begin
      for Number in 1 .. 5 loop
         declare
            Newcomer : Client;
         begin
            Newcomer.Connect (R.Supervisor.Port);
            Check (Newcomer.Closed_By_Peer /= Open,
                   "a second monitor is not turned away");
         end;
         delay Pause;
      end loop;
      Crowd.Come (R.Supervisor.Port, Floods.Address (1));
      delay 5 * Pause;
   end Turn_Away;

   procedure Lose_Monitor (R : in out Rig) is
   begin
      for Abortive in Boolean loop
         Play (R, Forward);
         if Abortive then
            R.Monitor.Reset;
         else
            R.Monitor.Close;
         end if;
         R.Emulator.Await_Status ("moving", "0");
         delay 10 * Pause;
         Connect (R);
      end loop;
   end Lose_Monitor;

   procedure Stop_Driving (R : in out Rig) is
      --  The orderly stop
   begin
      Play (R, Forward);
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "the orderly stop fails");
   end Stop_Driving;

   procedure Measure_Single is
      --  What a session seldom has: every command by itself, newcomers who are
      --  turned away, monitors that are lost, and the orderly stop
      R    : Rig;
      Load : Busy_Loops.Load;
   begin
      Loads.Assemble (R);
      Load.Start;
      Task_Times.Start (R.Supervisor.Pid, Except => "th_camera");
      --  which opens cameras here. The analysis knows nothing of that:
      --  nothing but the log is less urgent
      Ask_Robot (R);
      Ask_Camera (R);
      Turn_Away (R);
      Lose_Monitor (R);
      Stop_Driving (R);
      Task_Times.Stop;
   end Measure_Single;

   procedure Measure_Load (Missions : Boolean) is
      R : Rig;

      procedure Watch is
      begin
         Task_Times.Start (R.Supervisor.Pid);
      end Watch;

   begin
      Loads.Carry_Out (R, Missions, Begun => Watch'Access);
      Task_Times.Stop;
   end Measure_Load;

   Start : Instant;

begin
   Reports.Begin_Section
     ("tasks", "what one activity of a task takes: images with positions, 20"
      & " commands a second, and two busy loops; single commands; missions");
   Measure_Load (Missions => False);
   Start := Now;
   loop
      Measure_Single;
      exit when Now - Start >= Duration (Bench_Settings.Short_Seconds);
   end loop;
   Measure_Load (Missions => True);
   Task_Times.Print;
end Report_Task_Times;
