--  SPDX-License-Identifier: GPL-3.0-or-later
--  Injects faults into the real supervisor and checks what must hold
--  nevertheless.

with Ada.Command_Line;      use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;
with System;

with Fault_List;
with Fault_Records;
with Fault_Runs;            use Fault_Runs;
with Fault_Tables;
with Faults;
with Instants;
with Libc;
with Programs;
with Raw_Probes;
with Tolerances;
with Worlds;

procedure Destijl_Faults is

   Usage_Error : exception;

   Program  : constant String := Programs.Beside ("destijl_faults");
   S        : Scope;
   Jobs     : Positive := 12;
   Figures  : Worlds.Figure_Set;
   Markdown : Unbounded_String;
   Is_Job   : Boolean := False;
   Is_List  : Boolean := False;
   Place    : Positive := 1;
   Unused   : System.Address;

   function Value return String;
   --  Of the option at Place, which moves on

   function Plain (Number : Natural) return String is
     (Trim (Number'Image, Both));

   procedure Read_Options;

   procedure Print_Help;

   -----------
   -- Value --
   -----------

   function Value return String is
   begin
      if Place = Argument_Count then
         raise Usage_Error with Argument (Place) & " needs a value";
      end if;
      Place := Place + 1;
      return Argument (Place);
   end Value;

   ----------------
   -- Print_Help --
   ----------------

   procedure Print_Help is
   begin
      Put_Line ("bin/destijl_faults [OPTION ...]");
      Put_Line ("  --seed N        of everything random (1)");
      Put_Line ("  --times N       of each fault alone (100)");
      Put_Line ("  --pairs N       each in so many pairs, at random (100)");
      Put_Line ("  --only PART     faults and pairs with this in their name");
      Put_Line ("  --at N          only the repetition N");
      Put_Line ("  --jobs N        worlds side by side (12)");
      Put_Line ("  --short         each fault once, some pairs");
      Put_Line ("  --markdown FILE the table, as a file");
      Put_Line ("  --record FILE   each result; begun again with the same");
      Put_Line ("                  file, what is in it is not repeated");
      Put_Line ("  --supervisor, --emulator PATH  other programs");
      Put_Line ("  --list          the faults' names");
   end Print_Help;

   ------------------
   -- Read_Options --
   ------------------

   procedure Read_Options is
   begin
      while Place <= Argument_Count loop
         declare
            Name : constant String := Argument (Place);
         begin
            if Name = "--seed" then
               S.Seed := Natural'Value (Value);
            elsif Name = "--times" then
               S.Times := Natural'Value (Value);
            elsif Name = "--pairs" then
               S.Pairs := Natural'Value (Value);
            elsif Name = "--only" then
               S.Only := To_Unbounded_String (Value);
            elsif Name = "--at" then
               S.At_Repetition := Positive'Value (Value);
            elsif Name = "--jobs" then
               Jobs := Positive'Value (Value);
               if Jobs > Most_Jobs then
                  raise Usage_Error with "at most" & Most_Jobs'Image;
               end if;
            elsif Name = "--short" then
               S.Times := 1;
               S.Pairs := 1;
            elsif Name = "--markdown" then
               Markdown := To_Unbounded_String (Value);
            elsif Name = "--record" then
               S.Record_File := To_Unbounded_String (Value);
            elsif Name = "--supervisor" then
               Programs.Set_Supervisor (Value);
            elsif Name = "--emulator" then
               Programs.Set_Emulator (Value);
            elsif Name = "--list" then
               Is_List := True;
            elsif Name = "--work" then
               --  a job of Fault_Runs.Run
               Is_Job := True;
               S.Seed := Natural'Value (Value);
            elsif Name = "--help" then
               Print_Help;
               GNAT.OS_Lib.OS_Exit (0);
            else
               raise Usage_Error with "unknown option " & Name;
            end if;
         exception
            when Constraint_Error =>
               raise Usage_Error with Name & " needs another value";
         end;
         Place := Place + 1;
      end loop;
   end Read_Options;

begin
   Unused := Libc.Signal (Libc.Sigpipe, Libc.Ignored);
   Raw_Probes.Allow_Descriptors;
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
        (Plain (Figures.Stops) & " stops of a moving robot after a close or"
         & " a reset: the slowest after "
         & Instants.Milliseconds (Figures.Slowest_Stop) & ", "
         & Plain (Figures.Late_Stops) & " later than the "
         & Instants.Milliseconds
             (Tolerances.Loss_Limit + Tolerances.Stop_Limit)
         & " demanded");
      Put_Line ("memory grew by" & Figures.Growth'Image & " kB at most");
      if Figures.Repeated > 0 then
         Put_Line
           (Plain (Figures.Repeated)
            & " sessions were begun again: the emulated line was late");
      end if;
      if Figures.Interrupted > 0 then
         Put_Line
           (Plain (Figures.Interrupted)
            & " injections were made again: the machine's host had taken"
            & " its processors");
      end if;
      Put_Line
        (Plain (Fault_Tables.Injections) & " injections, "
         & Plain (Fault_Tables.Violations) & " violations");
      if Fault_Tables.Violations > 0 or else Fault_Tables.Injections = 0
      then
         Set_Exit_Status (1);
      end if;
   end if;
   Programs.Remove_Temporary_Folder;

exception
   when Occurrence : Usage_Error | Fault_Records.Wrong_Record =>
      Put_Line
        (Standard_Error,
         "destijl_faults: " & Ada.Exceptions.Exception_Message (Occurrence)
         & " (--help)");
      Set_Exit_Status (2);
   when Occurrence : others =>
      Programs.Give_Up (Ada.Exceptions.Exception_Information (Occurrence));
end Destijl_Faults;
