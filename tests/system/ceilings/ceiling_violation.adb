--  SPDX-License-Identifier: GPL-3.0-or-later
--  Do ceilings act here? Says what a task sees that calls an object whose
--  ceiling is below its priority, and one whose ceiling is above. Exit status
--  0 where that is what Process.Privileges says.

with Ada.Text_IO;        use Ada.Text_IO;
with GNAT.OS_Lib;
with Process.Privileges; use Process.Privileges;
with Schedule;
with Violators;

procedure Ceiling_Violation with Priority => Schedule.Main_Priority is
   Granted : Scheduling;
   Raised  : Boolean;
   Inside  : Integer;
   Good    : Boolean;
begin
   Get (Granted);
   Violators.Await (Raised, Inside);
   Put_Line ("said: " & Image (Granted) & "; seen: "
             & (if Raised then "Program_Error" else "no exception")
             & ", priority inside" & Inside'Image);
   Flush;
   --  GNAT's priorities are Linux's less one
   Good :=
     (if Granted = Fifo_With_Ceilings
      then Raised and then Inside = Schedule.Stop_Priority + 1
      else not Raised and then Inside <= Schedule.Move_Priority + 1);
   GNAT.OS_Lib.OS_Exit (if Good then 0 else 1);
end Ceiling_Violation;
