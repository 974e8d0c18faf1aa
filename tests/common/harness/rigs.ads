--  SPDX-License-Identifier: GPL-3.0-or-later
--  The three parties, connected: emulated robot and camera, supervisor,
--  monitor.

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
      Connected          : Boolean := True;
      Terminal           : Boolean := False);
   --  Camera: with the arena's camera. If Bind is not 127.0.0.1, the caller
   --  connects the monitor.

   procedure Connect (R : in out Rig);
   --  Connects a new monitor; the one before is closed

   procedure Start_Robot (R : in out Rig; Watchdog : Boolean := False);
   --  Opens the line and starts

   procedure Move_Forward (R : in out Rig);
   --  Starts the robot and lets it drive, then clears the journal

   procedure Open_Camera (R : in out Rig; Positions : Boolean := False);
   --  Raises Failed if no image comes

   procedure Search_Arena (R : in out Rig);
   --  CASA, until the last image waits for the decision on it

   procedure Expect_Initial_State (R : in out Rig);
   --  A new session of the monitor: robot and camera must be opened

end Rigs;
