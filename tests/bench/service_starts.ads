--  SPDX-License-Identifier: GPL-3.0-or-later
--  How the supervisor is started under --service: by an ordinary user with
--  CAP_SYS_NICE, memory locked without a limit, --cpu auto, as by its unit
--  (script/systemd/destijl.service). Where nobody may raise that limit, as in
--  some containers, CAP_IPC_LOCK has the same effect.

with Rigs; use Rigs;

package Service_Starts is

   procedure Assemble
     (R                  : in out Rig;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Connected          : Boolean := True);
   --  With the arena's camera. Under --service as the service; puts what the
   --  supervisor says of its deadlines into the report, and raises Failed
   --  unless they are as analysed

   procedure Drive (R : in out Rig; For_Time : Duration);
   --  The load that the analysis takes for granted: the robot is started and
   --  the camera opened before, a command each 50 ms

end Service_Starts;
