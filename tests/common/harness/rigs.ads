--  SPDX-License-Identifier: GPL-3.0-or-later
--  The three parties together: emulated robot and camera, supervisor,
--  monitor, connected with each other.

with Emulators;
with Monitor_Clients;
with Supervisors;

package Rigs is

   type Rig is limited record
      Emulator   : Emulators.Emulator;
      Supervisor : Supervisors.Supervisor;
      Monitor    : Monitor_Clients.Client;
   end record;

   procedure Assemble
     (R                  : in out Rig;
      Camera             : Boolean := False;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Launcher           : String  := "";
      Program            : String  := "";
      Bind               : String  := "127.0.0.1";
      Connected          : Boolean := True);
   --  Camera: with the arena's camera. Bind other than 127.0.0.1: the
   --  monitor is left to the caller.

   procedure Connect (R : in out Rig);
   --  The monitor, anew; the one before is closed

   procedure Start_Robot (R : in out Rig; Watchdog : Boolean := False);
   --  Opens the line and starts

   procedure Move_Forward (R : in out Rig);
   --  Starts the robot and lets it drive, then clears the journal

   procedure Open_Camera (R : in out Rig; Positions : Boolean := False);
   --  Raises Failed when no image comes

   procedure Expect_Initial_State (R : in out Rig);
   --  Of the monitor's session: robot and camera have to be opened

end Rigs;
