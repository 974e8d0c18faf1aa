--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out random missions, real and simulated, and prints one line of
--  JSON for each.

with Ada.Exceptions;
with Ada.Text_IO;     use Ada.Text_IO;
with GNAT.OS_Lib;

with Child_Processes;
with Expectations;
with Mission_Judges;
with Mission_Lines;   use Mission_Lines;
with Mission_Plans;   use Mission_Plans;
with Option_Readers;  use Option_Readers;
with Own_Process;
with Programs;
with Real_Missions;

procedure Destijl_Missions is

   Real      : Natural  := 0;
   First     : Positive := 1;
   Step      : Positive := 1;
   Seed      : Natural  := 1;

   procedure Read_Command_Line;

   procedure Print_Usage (To : File_Type);

   procedure Run_Real (P : Plan);

   procedure Say (Text : String);

   procedure Print_Usage (To : File_Type) is
   begin
      Put_Line (To, "usage: destijl_missions [OPTION]...");
      Put_Line (To, "   --real N        missions of the supervisor (0)");
      Put_Line (To, "   --seed N        others (1)");
      Put_Line (To, "   --first N       the first one's number (1)");
      Put_Line (To, "   --step N        to the next one's number (1)");
      Put_Line (To, "   --supervisor PATH, --emulator PATH");
      Put_Line (To, "                   instead of those beside this one");
   end Print_Usage;

   procedure Read_Command_Line is
   begin
      while Next loop
         if Name = "--real" then
            Real := Number (0);
         elsif Name = "--seed" then
            Seed := Number (0);
         elsif Name = "--first" then
            First := Number;
         elsif Name = "--step" then
            Step := Number;
         elsif Programs.Read_Option then
            null;
         elsif Name = "--help" then
            Print_Usage (Standard_Output);
            GNAT.OS_Lib.OS_Exit (0);
         else
            Refuse;
         end if;
      end loop;
   end Read_Command_Line;

   procedure Run_Real (P : Plan) is
      V : Mission_Judges.Verdict;
   begin
      Real_Missions.Run (P, V);
      Say (Line ("real", P, V));
   exception
      when Problem : Expectations.Failed =>
         Say (Line ("real", P, Ada.Exceptions.Exception_Message (Problem)));
   end Run_Real;

   procedure Say (Text : String) is
   begin
      Put_Line (Text);
      Flush;
   end Say;

begin
   Own_Process.Ignore_Broken_Pipes;
   Read_Command_Line;
   for K in 0 .. Real - 1 loop
      Run_Real (Random (Seed, First + K * Step));
   end loop;
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit (0);

exception
   when Problem : Bad_Usage =>
      Put_Line
        (Standard_Error,
         "destijl_missions: " & Ada.Exceptions.Exception_Message (Problem));
      Print_Usage (Standard_Error);
      GNAT.OS_Lib.OS_Exit (2);
   when Problem : others =>
      Child_Processes.Stop_All;
      Put_Line
        (Standard_Error,
         "destijl_missions: "
         & Ada.Exceptions.Exception_Information (Problem));
      Programs.Remove_Temporary_Folder;
      GNAT.OS_Lib.OS_Exit (1);
end Destijl_Missions;
