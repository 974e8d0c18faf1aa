--  SPDX-License-Identifier: GPL-3.0-or-later
--  How the supervisor is started under --service: by an ordinary user with
--  CAP_SYS_NICE, memory locked without a limit, --cpu auto, as by its unit
--  (script/systemd/destijl.service). Where nobody may raise that limit, as in
--  some containers, CAP_IPC_LOCK has the same effect.

with Bench_Settings;
with Programs;
with Supervisors;

package Service_Starts is

   --  For Rigs.Assemble; without --service all are empty

   function Launcher return String;

   function Program return String is
     (if Bench_Settings.As_Service then Programs.Copied_Supervisor else "");

   function Options return String is
     (if Bench_Settings.As_Service then "--cpu auto" else "");

   function Deadlines (Of_Supervisor : Supervisors.Supervisor) return String;
   --  What its log says of them. Raises Failed if nothing

   procedure Look_At (Item : Supervisors.Supervisor);
   --  Under --service, puts Deadlines into the report. Raises Failed unless
   --  they are as analysed

end Service_Starts;
