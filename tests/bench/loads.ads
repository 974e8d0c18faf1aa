--  SPDX-License-Identifier: GPL-3.0-or-later
--  The loads that the analysis of the deadlines takes for granted, and how the
--  supervisor is started for them. Under --service: by an ordinary user with
--  CAP_SYS_NICE, memory locked without a limit, --cpu auto, as by its unit
--  (script/systemd/destijl.service). Where nobody may raise that limit, as in
--  some containers, CAP_IPC_LOCK has the same effect.

with Rigs; use Rigs;

package Loads is

   procedure Assemble
     (R                  : in out Rig;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Connected          : Boolean := True);
   --  With the arena's camera. Under --service as the service; raises Failed
   --  unless it says that its deadlines are as analysed

   procedure Carry_Out
     (R        : in out Rig;
      Missions : Boolean;
      Options  : String := "";
      Begun    : access procedure := null);
   --  For Bench_Settings.Short_Seconds, from nothing, with these options of
   --  the supervisor; two busy loops beside. Watchdog, images with positions
   --  and a command each 50 ms, or missions: through random points, one after
   --  the other, every third ended by hand, with questions of the monitor, one
   --  of them for another mission of as many points as there may be. How many
   --  there were is reported. Begun is called when all is ready.

end Loads;
