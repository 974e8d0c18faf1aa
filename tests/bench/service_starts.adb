--  SPDX-License-Identifier: GPL-3.0-or-later
--  How the supervisor is started under --service.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Child_Processes;   use Child_Processes;
with Expectations;      use Expectations;
with Reports;

package body Service_Starts is

   function Deadlines (Of_Supervisor : Supervisors.Supervisor) return String
   is
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
      if not Bench_Settings.As_Service then
         return "";
      end if;
      Trial.Start ("env", Words (Raised & " true"));
      return
        (if Trial.Exit_Status = 0
         then Raised & " " & Programs.As_Service
         else Programs.As_Service ("+sys_nice,+ipc_lock"));
   end Launcher;

   procedure Look_At (Item : Supervisors.Supervisor) is
   begin
      if Bench_Settings.As_Service then
         declare
            Text : constant String := Deadlines (Item);
         begin
            Reports.Put_Note
              ("as the service; its deadlines, it says: " & Text);
            Check
              (Index (Text, "as analysed") = Text'First, "deadlines: " & Text);
         end;
      end if;
   end Look_At;

end Service_Starts;
