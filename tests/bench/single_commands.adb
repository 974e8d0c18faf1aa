--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a session seldom has: every command by itself, newcomers who are
--  turned away, monitors that are lost, and the orderly stop. Adds to
--  Task_Times what the tasks take for it, with two busy loops, in one
--  supervisor after the other, about Bench_Settings.Seconds in all.

with Bench_Settings;
with Busy_Loops;
with Expectations;    use Expectations;
with Floods;
with Instants;        use Instants;
with Libc;
with Monitor_Clients; use Monitor_Clients;
with Rigs;            use Rigs;
with Service_Starts;
with Task_Times;

procedure Single_Commands is

   Pause : constant Duration := 0.02;
   --  between two commands: no task has anything left to do

   procedure Ask (R : in out Rig; Command : String; Answer : String) is
   begin
      R.Monitor.Expect (Command, Answer);
      delay Pause;
   end Ask;

   procedure Ask_One_Exchange (R : in out Rig; Command : String) is
      --  One for which the supervisor asks the robot once
   begin
      Task_Times.Begin_Exchange;
      Ask (R, Command, "AACK");
      Task_Times.End_Exchange;
   end Ask_One_Exchange;

   procedure Ask_For_Image (R : in out Rig; Command : String) is
      --  Whose answer is one
      Item : Message;
   begin
      R.Monitor.Skip_To_Now;
      R.Monitor.Send_Line (Command);
      Item := R.Monitor.Next_Of ("CIMG");
      Check (Item.Size > 0, Command & " is not answered");
      delay 10 * Pause;
      --  the image may have been one on its way
   end Ask_For_Image;

   procedure Tell (R : in out Rig; Command : String) is
      --  That has no answer
   begin
      R.Monitor.Send_Line (Command);
      delay Pause;
   end Tell;

   procedure Ask_Robot (R : in out Rig) is
      Unused : Message;
   begin
      for Round in 1 .. 4 loop
         Ask (R, "ROPN", "AACK");
         Ask_One_Exchange (R, "RSOW");
         Ask_One_Exchange (R, "RGFW");
         Ask_One_Exchange (R, "RMOV:100");
         Ask_One_Exchange (R, "RTRN:-90");
         Ask_One_Exchange (R, "RSTP");
         Ask_One_Exchange (R, "RPIN");
         Ask (R, "RLDW", "AACK");
         Unused := R.Monitor.Ask ("RGBT");
         delay Pause;
         Unused := R.Monitor.Ask ("RGST");
         delay Pause;
         Tell (R, "MSSG:one at a time");
         Ask (R, "what", "ACER");
         Ask (R, "RRST", "AACK");
         Ask_One_Exchange (R, "RSWW");
         Ask (R, "RRST", "AACK");
         Ask (R, "RCLS", "AACK");
      end loop;
   end Ask_Robot;

   procedure Ask_Camera (R : in out Rig) is
   begin
      Ask (R, "COPN", "AACK");
      Ask_For_Image (R, "CASA");
      Tell (R, "CAIN");
      Ask_For_Image (R, "CASA");
      Tell (R, "CACO");
      Ask (R, "CPCO", "AACK");
      delay 0.5;
      Ask (R, "CPST", "AACK");
      Ask (R, "CCLS", "AACK");
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
         Move_Forward (R);
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
      Move_Forward (R);
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "the orderly stop fails");
   end Stop_Driving;

   procedure Measure_Once is
      R    : Rig;
      Load : Busy_Loops.Load;
   begin
      Service_Starts.Assemble (R, "--baud 9600");
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
   end Measure_Once;

   Start : constant Instant := Now;

begin
   loop
      Measure_Once;
      exit when Now - Start >= Duration (Bench_Settings.Short_Seconds);
   end loop;
end Single_Commands;
