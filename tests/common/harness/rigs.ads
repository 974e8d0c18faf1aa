--  SPDX-License-Identifier: GPL-3.0-or-later
--  The three parties, connected: emulated robot and camera, supervisor,
--  monitor; and scripts for them: what the monitor sends and what the emulator
--  is told, step by step, and what must come of it.

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

   procedure Start
     (R                          : in out Rig;
      Options, Launcher, Program : String := "");
   --  Only a supervisor with these options, and a monitor

   procedure Connect (R : in out Rig);
   --  Connects a new monitor; the one before is closed

   procedure Play
     (R     : in out Rig;
      Steps : String;
      Times : Positive := 1;
      Each  : String   := "");
   --  Times times, or for each of the words Each, which replaces '$' in Steps.
   --  Steps are separated by ", ". Raises Failed at the first that fails:
   --
   --  RMOV:5 AACK         the monitor sends RMOV:5, the answer is AACK
   --  send RPIN|what      it sends these lines at once, and waits for nothing
   --  soon 0.5 RPIN       some answer to RPIN comes within 0.5 s
   --  answer ATIM|ANAK AACK   the next answer is one of the first two, that
   --                      after it AACK
   --  comes MSSG:text     the next MSSG comes, its text begins like this
   --  silence 0.5 RBLV    no message RBLV comes for 0.5 s
   --  tell drop 3         a command to the emulator
   --  status state run    the emulator's status, awaited
   --  clear               the emulator's record of the wire
   --  wire M=5 M=0        all movements on the wire since then
   --  sent w 1            how often this was on the wire since then
   --  seen M=0            whether it was, awaited
   --  unused              nothing at all was
   --  log robot lost      the log says so, in this round
   --  said robot lost     it says so, or has said so before
   --  unsaid robot lost   it has never said so
   --  wait 0.5            for nothing
   --  part RG             it sends this, and ends no line
   --  close, reset, half-close   the monitor leaves like this
   --  connect             another comes
   --  pause               the monitor reads nothing any more
   --  signal 15           to the supervisor, if it runs
   --  freeze, thaw        the emulator's program
   --  stops               M=0 is on the wire 0.5 s at most after the last
   --                      signal or leaving
   --  over                the session, 3 s at most after it
   --  closed              the supervisor has closed the connection
   --  ends 0              it ends with this status, 3 s at most after it

   Started : constant String := "ROPN AACK, RSOW AACK";
   Guarded : constant String := "ROPN AACK, RSWW AACK";
   --  With the watchdog

   Forward : constant String :=
     Started & ", RGFW AACK, status moving 1, clear";

   With_Images : constant String := "COPN AACK, comes CIMG";

   With_Positions : constant String :=
     "COPN AACK, CPCO AACK, comes CPOS, comes CIMG";

   Arena_Searched : constant String :=
     "CASA CIMG, silence 1 AACK, silence 0.5 CIMG CPOS AACK";
   --  The last image waits for the decision on it; images and positions may
   --  have been under way

   Initial : constant String :=
     "RPIN ANAK, RSOW ANAK, RGFW ANAK, CPCO ANAK, CASA ANAK,"
     & " silence 0.7 CIMG CPOS RBLV ATIM";
   --  A new session of the monitor: robot and camera must be opened

   Works_Again : constant String :=
     "RPIN ANAK, RGFW ANAK, RSOW ANAK, " & Started & ", RGFW AACK, RSTP AACK";
   --  F9: a robot that was lost is closed, and works at once when opened

   Renewed : constant String := "said session closed, connect, " & Initial;
   --  The session of the next monitor, without a message from the one before

end Rigs;
