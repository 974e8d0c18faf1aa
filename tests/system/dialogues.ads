--  SPDX-License-Identifier: GPL-3.0-or-later
--  Tests as scripts: what the monitor sends and what the emulator is told,
--  step by step, and what must come of it.

with Rigs; use Rigs;

package Dialogues is

   procedure Play (R : in out Rig; Steps : String; Times : Positive := 1);
   --  Steps are separated by ", ". Raises Failed at the first that fails:
   --
   --  RMOV:5 AACK         the monitor sends RMOV:5, the answer is AACK
   --  send RPIN           it sends RPIN, and waits for nothing
   --  answer ATIM|ANAK    the next answer is one of these
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
   --  unsaid robot lost   the log has never said so
   --  wait 0.5            for nothing
   --  part RG             it sends this, and ends no line
   --  close, reset, half-close   the monitor leaves like this
   --  connect             another comes
   --  initial             all must be opened anew
   --  pause               the monitor reads nothing any more
   --  signal 15           to the supervisor, if it runs
   --  stops               M=0 is on the wire 0.5 s at most after the last
   --                      signal or leaving
   --  over                the session, 3 s at most after it
   --  closed              the supervisor has closed the connection
   --  ends 0              it ends with this status, 3 s at most after it

   procedure Script
     (Name               : String;
      Steps              : String;
      Emulator_Options   : String   := "";
      Supervisor_Options : String   := "";
      Camera             : Boolean  := False;
      Terminal           : Boolean  := False;
      Times              : Positive := 1;
      Timed, In_Time     : Boolean  := False);
   --  Adds a test (Scenarios.Add) that assembles a rig and plays Steps

   Works_Again : constant String :=
     "RPIN ANAK, RGFW ANAK, RSOW ANAK, ROPN AACK, RSOW AACK, RGFW AACK,"
     & " RSTP AACK";
   --  F9: a robot that was lost is closed, and works at once when opened

   Forward : constant String :=
     "ROPN AACK, RSOW AACK, RGFW AACK, status moving 1, clear";

   With_Images : constant String := "COPN AACK, comes CIMG";

   With_Positions : constant String :=
     "COPN AACK, CPCO AACK, comes CPOS, comes CIMG";

end Dialogues;
