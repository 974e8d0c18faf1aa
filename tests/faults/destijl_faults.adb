--  SPDX-License-Identifier: GPL-3.0-or-later
--  Injects faults into the real supervisor and checks what must hold
--  nevertheless.

with Ada.Command_Line;      use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

with Fault_List;
with Fault_Records;
with Fault_Runs;            use Fault_Runs;
with Fault_Tables;
with Faults;
with Instants;
with Option_Readers;        use Option_Readers;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Tolerances;
with Worlds;

procedure Destijl_Faults is

   Program  : constant String := Programs.Beside ("destijl_faults");
   S        : Scope;
   Jobs     : Positive := 12;
   Figures  : Worlds.Figure_Set;
   Markdown : Unbounded_String;
   Is_Job   : Boolean := False;
   Is_List  : Boolean := False;

   LF    : Character renames ASCII.LF;
   Usage : constant String :=
     "bin/destijl_faults [OPTION ...]" & LF
     & "  --seed N        of everything random (1)" & LF
     & "  --times N       of each fault alone (100)" & LF
     & "  --pairs N       each in so many pairs, at random (100)" & LF
     & "  --only PART     faults and pairs with this in their name" & LF
     & "  --at N          only the repetition N" & LF
     & "  --jobs N        worlds side by side (12)" & LF
     & "  --short         each fault once, some pairs" & LF
     & "  --markdown FILE the table, as a file" & LF
     & "  --record FILE   each result; begun again with the same" & LF
     & "                  file, what is in it is not repeated" & LF
     & "  --supervisor, --emulator PATH  other programs" & LF
     & "  --list          the faults' names";

   procedure Read_Options is
   begin
      while Next loop
         if Name = "--seed" then
            S.Seed := Number (Low => 0);
         elsif Name = "--times" then
            S.Times := Number (Low => 0);
         elsif Name = "--pairs" then
            S.Pairs := Number (Low => 0);
         elsif Name = "--only" then
            S.Only := To_Unbounded_String (Value);
         elsif Name = "--at" then
            S.At_Repetition := Number;
         elsif Name = "--jobs" then
            Jobs := Number (1, Most_Jobs);
         elsif Name = "--short" then
            S.Times := 1;
            S.Pairs := 1;
         elsif Name = "--markdown" then
            Markdown := To_Unbounded_String (Value);
         elsif Name = "--record" then
            S.Record_File := To_Unbounded_String (Value);
         elsif Name = "--list" then
            Is_List := True;
         elsif Name = "--work" then
            --  a job of Fault_Runs.Run
            Is_Job := True;
            S.Seed := Number (Low => 0);
         else
            Programs.Read_Option (Usage);
         end if;
      end loop;
   end Read_Options;

begin
   Own_Process.Ignore_Broken_Pipes;
   Own_Process.Allow_Descriptors;
   Fault_List.Register;
   Read_Options;

   if Is_List then
      for Number in 1 .. Faults.Count loop
         Put_Line (To_String (Faults.Element (Number).Name));
      end loop;

   elsif Is_Job then
      Fault_Runs.Work (S.Seed);

   else
      Put_Line ("seed" & S.Seed'Image);
      Flush;
      Fault_Runs.Run (S, Jobs, Program, Figures);
      Fault_Tables.Print;
      if Markdown /= "" then
         Fault_Tables.Print (To_String (Markdown));
      end if;
      Put_Line
        (Image (Figures.Stops) & " stops of a moving robot after a close or"
         & " a reset: the slowest after "
         & Instants.Milliseconds (Figures.Slowest_Stop) & ", "
         & Image (Figures.Late_Stops) & " later than the "
         & Instants.Milliseconds
             (Tolerances.Loss_Limit + Tolerances.Stop_Limit)
         & " demanded");
      Put_Line ("memory grew by" & Figures.Growth'Image & " kB at most");
      if Figures.Repeated > 0 then
         Put_Line
           (Image (Figures.Repeated)
            & " sessions were begun again: the emulated line was late");
      end if;
      if Figures.Interrupted > 0 then
         Put_Line
           (Image (Figures.Interrupted)
            & " injections were made again: the machine's host had taken"
            & " its processors");
      end if;
      Put_Line
        (Image (Fault_Tables.Injections) & " injections, "
         & Image (Fault_Tables.Violations) & " violations");
      if Fault_Tables.Violations > 0 or else Fault_Tables.Injections = 0
      then
         Set_Exit_Status (1);
      end if;
   end if;
   Programs.Remove_Temporary_Folder;

exception
   when Occurrence : Fault_Records.Wrong_Record =>
      Programs.Give_Up (Ada.Exceptions.Exception_Message (Occurrence), 2);
   when Occurrence : others =>
      Programs.Give_Up (Occurrence);
end Destijl_Faults;
