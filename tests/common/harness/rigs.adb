--  SPDX-License-Identifier: GPL-3.0-or-later
--  The three parties together.

with Monitor_Clients; use Monitor_Clients;

package body Rigs is

   procedure Assemble
     (R                  : in out Rig;
      Camera             : Boolean := False;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Launcher           : String  := "";
      Program            : String  := "";
      Bind               : String  := "127.0.0.1";
      Connected          : Boolean := True;
      Terminal           : Boolean := False)
   is
      Unused : Emulators.Note;
   begin
      R.Emulator.Start (Camera, Emulator_Options, Terminal);
      R.Supervisor.Start
        ("--serial " & R.Emulator.Device
         & (if Camera then " --camera " & R.Emulator.Camera_Url else "")
         & " " & Supervisor_Options,
         Launcher, Program, Bind);
      --  each supervisor begins with a stop
      Unused := R.Emulator.Await_On_Wire ("M=0");
      R.Emulator.Clear_Journal;
      if Connected and then Bind = "127.0.0.1" then
         Connect (R);
      end if;
   end Assemble;

   procedure Connect (R : in out Rig) is
   begin
      R.Monitor.Connect (R.Supervisor.Port);
   end Connect;

   procedure Start_Robot (R : in out Rig; Watchdog : Boolean := False) is
   begin
      R.Monitor.Expect ("ROPN", "AACK");
      R.Monitor.Expect ((if Watchdog then "RSWW" else "RSOW"), "AACK");
   end Start_Robot;

   procedure Move_Forward (R : in out Rig) is
   begin
      Start_Robot (R);
      R.Monitor.Expect ("RGFW", "AACK");
      R.Emulator.Await_Status ("moving", "1");
      R.Emulator.Clear_Journal;
   end Move_Forward;

   procedure Open_Camera (R : in out Rig; Positions : Boolean := False) is
      Unused : Message;
   begin
      R.Monitor.Expect ("COPN", "AACK");
      if Positions then
         R.Monitor.Expect ("CPCO", "AACK");
         Unused := R.Monitor.Next_Of ("CPOS");
      end if;
      Unused := R.Monitor.Next_Of ("CIMG");
   end Open_Camera;

   procedure Search_Arena (R : in out Rig) is
   begin
      R.Monitor.Expect ("CASA", "CIMG");
      --  images and positions may have been under way
      R.Monitor.Expect_Silence ("AACK", For_Time => 1.0);
      R.Monitor.Expect_Silence ("CIMG CPOS AACK", For_Time => 0.5);
   end Search_Arena;

   procedure Expect_Initial_State (R : in out Rig) is
   begin
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Monitor.Expect ("RSOW", "ANAK");
      R.Monitor.Expect ("RGFW", "ANAK");
      R.Monitor.Expect ("CPCO", "ANAK");
      R.Monitor.Expect ("CASA", "ANAK");
      R.Monitor.Expect_Silence ("CIMG CPOS RBLV ATIM", For_Time => 0.7);
   end Expect_Initial_State;

end Rigs;
