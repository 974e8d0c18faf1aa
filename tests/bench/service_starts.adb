--  SPDX-License-Identifier: GPL-3.0-or-later
--  How the supervisor is started under --service.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Bench_Settings;
with Budgets;
with Child_Processes;   use Child_Processes;
with Expectations;      use Expectations;
with Instants;          use Instants;
with Monitor_Clients;   use Monitor_Clients;
with Programs;
with Reports;
with Supervisors;

package body Service_Starts is

   function Deadlines (Of_Supervisor : Supervisors.Supervisor) return String is
      --  What its log says of them
      Label : constant String := "deadlines: ";
      Log   : constant String :=
        (if Of_Supervisor.Says (Label, Patience)
         then Of_Supervisor.Log_Text else "");
      First : constant Natural := Index (Log, Label) + Label'Length;
   begin
      Check (Log /= "", "the supervisor says nothing of its deadlines");
      return Log (First .. Index (Log, (1 => ASCII.LF), First) - 1);
   end Deadlines;

   function Launcher return String is
      Raised : constant String := "prlimit --memlock=unlimited:unlimited";
      Trial  : Child;
   begin
      Trial.Start ("env", Words (Raised & " true"));
      return
        (if Trial.Exit_Status = 0
         then Raised & " " & Programs.As_Service
         else Programs.As_Service ("+sys_nice,+ipc_lock"));
   end Launcher;

   procedure Assemble
     (R                  : in out Rig;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Connected          : Boolean := True)
   is
      As_Service : Boolean renames Bench_Settings.As_Service;
   begin
      Rigs.Assemble
        (R, Camera => True, Emulator_Options => Emulator_Options,
         Supervisor_Options =>
           (if As_Service then "--cpu auto " else "") & Supervisor_Options,
         Launcher  => (if As_Service then Launcher else ""),
         Program   =>
           (if As_Service then Programs.Copied_Supervisor else ""),
         Connected => Connected);
      if As_Service then
         declare
            Text : constant String := Deadlines (R.Supervisor);
         begin
            Reports.Put_Note
              ("as the service; its deadlines, it says: " & Text);
            Check
              (Index (Text, "as analysed") = Text'First, "deadlines: " & Text);
         end;
      end if;
   end Assemble;

   procedure Drive (R : in out Rig; For_Time : Duration) is
      Pause  : constant Duration :=
        Duration (Budgets.Command_Interval) / 1_000_000;
      Start  : constant Instant := Now;
      Number : Natural := 0;
      Unused : Message;
   begin
      while Now - Start < For_Time loop
         Number := Number + 1;
         Unused := R.Monitor.Ask ((case Number mod 4 is
                                      when 0 => "RMOV:-100",
                                      when 1 => "RTRN:90",
                                      when 2 => "RSTP",
                                      when others => "RGST"));
         delay Pause;
      end loop;
   end Drive;

end Service_Starts;
