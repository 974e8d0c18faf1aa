--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor under test.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Directories;
with Ada.Streams.Stream_IO;
with Ada.Strings;             use Ada.Strings;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;

with Expectations;            use Expectations;
with Libc;
with Plain_Numbers;           use Plain_Numbers;
with Programs;

package body Supervisors is

   Listening : constant String := "listening on ";
   Timeout   : constant String := "--answer-timeout";

   Patient : Boolean := False;

   procedure Start_Process
     (Object   : in out Supervisor;
      Options  : Arguments;
      Launcher : String;
      Program  : String)
   is
      use type Arguments;
      Path : constant String :=
        (if Program = "" then Programs.Supervisor else Program);
      All_Words : Arguments := Words
        ((if Index (Launcher, "LD_PRELOAD") > 0 then ""
          else Programs.Preload & " ") & Launcher) & Path & Options;
      First     : constant String := All_Words.First_Element;
   begin
      Object.Port := 0;
      All_Words.Delete_First;
      Object.Process.Start (First, All_Words, "supervisor");
   end Start_Process;

   procedure Start
     (Object   : in out Supervisor;
      Options  : String  := "";
      Launcher : String  := "";
      Program  : String  := "";
      Bind     : String  := "127.0.0.1";
      Port     : Natural := 0)
   is
      use type Arguments;
      Number : Natural;
   begin
      Start_Process (Object,
                     Words ("--port" & Port'Image & " --bind " & Bind
                       & (if Patient and then Index (Options, Timeout) = 0
                          then " " & Timeout & " 300" else ""))
                     & Words (Options),
                     Launcher, Program);
      Number := Object.Process.Awaited (Errors, Listening, Patience);
      Check (Number > 0, "the supervisor does not listen");
      declare
         Line  : constant String :=
           To_String (Object.Process.Element (Errors, Number).Text);
         First : constant Positive := Index (Line, ":", Going => Backward) + 1;
         --  the last one: an address of IPv6 has its own
         Last  : Positive := First;
      begin
         Check (First > 1 and then First <= Line'Last, "no port in: " & Line);
         while Last < Line'Last and then Is_Digit (Line (Last + 1)) loop
            Last := Last + 1;
         end loop;
         Object.Port := Natural'Value (Line (First .. Last));
      end;
   end Start;

   procedure Be_Patient is
   begin
      Patient := True;
   end Be_Patient;

   procedure Run
     (Object   : in out Supervisor;
      Options  : String;
      Launcher : String := "";
      Program  : String := "") is
   begin
      Start_Process (Object, Words (Options), Launcher, Program);
   end Run;

   function Console
     (Options  : String;
      Status   : Integer;
      Launcher : String := "";
      Program  : String := "") return String
   is
      End_Limit   : constant Duration := 1.0;
      --  F1
      Check_Limit : constant Duration := 15.0;
      Start : constant Instant := Now;
      S     : Supervisor;
      Seen  : Integer;
   begin
      S.Run (Options, Launcher, Program);
      Seen := S.Exit_Status;
      Check_Within
        (Now - Start,
         (if Index (Options, "--check") > 0 then Check_Limit else End_Limit),
         Options);
      return Text : constant String := S.Output_Text & S.Log_Text do
         Check (Seen = Status,
                Options & ": exit status" & Seen'Image & ": " & Text);
         Check (Index (Text, Listening) = 0, Options & ": it listens");
      end return;
   end Console;

   procedure Expect_Console
     (Options  : String;
      Status   : Integer;
      Text     : String;
      Launcher : String := "";
      Program  : String := "")
   is
      Said : constant String := Console (Options, Status, Launcher, Program);
   begin
      Check (Index (Said, Text) > 0,
             Options & ": not """ & Text & """, but " & Said);
   end Expect_Console;

   function Token_File
     (Text : String   := Token & ASCII.LF;
      Mode : unsigned := 8#600#;
      Name : String   := "token") return String
   is
      use Ada.Streams.Stream_IO;
      Path : constant String := Programs.Temporary_Folder & "/" & Name;
      File : File_Type;
   begin
      if Ada.Directories.Exists (Path) then
         --  perhaps one that nobody may write
         Ada.Directories.Delete_File (Path);
      end if;
      Create (File, Out_File, Path);
      String'Write (Ada.Streams.Stream_IO.Stream (File), Text);
      Close (File);
      Check (Libc.Chmod (To_C (Path), Mode) = 0, "chmod of " & Path);
      return Path;
   end Token_File;

   function Own_Address return String is
      Process : constant Natural := Natural (Libc.Getpid);
   begin
      return "127." & Image (64 + Process / 65_536) & "."
        & Image (Process / 256 mod 256) & "." & Image (Process mod 256);
   end Own_Address;

   function Port (Object : Supervisor) return Positive is (Object.Port);

   function Pid (Object : Supervisor) return int is
     (Object.Process.Pid);

   function Is_Running (Object : in out Supervisor) return Boolean is
     (Object.Process.Is_Running);

   procedure Send_Signal (Object : Supervisor; Signal : int) is
   begin
      Object.Process.Send_Signal (Signal);
   end Send_Signal;

   function Exit_Status (Object : in out Supervisor) return Integer is
     (Object.Process.Exit_Status);

   function Log_Length (Object : Supervisor) return Natural is
     (Object.Process.Count (Errors));

   function Says
     (Object  : Supervisor;
      Pattern : String;
      Within  : Duration := 0.0;
      After   : Natural  := 0) return Boolean
   is (Object.Process.Awaited (Errors, Pattern, Within, After) > 0);

   procedure Expect_Log
     (Object  : Supervisor;
      Pattern : String;
      After   : Natural := 0) is
   begin
      Check (Object.Says (Pattern, Patience, After),
             "the supervisor's log lacks """ & Pattern & """");
   end Expect_Log;

   function Time_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Instant
   is
      Number : constant Natural :=
        Object.Process.Awaited (Errors, Pattern, After => After);
   begin
      return
        (if Number = 0 then Never
         else Object.Process.Element (Errors, Number).Time);
   end Time_Of;

   function Count_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Natural
   is
      Result : Natural := 0;
      Number : Natural := After;
   begin
      loop
         Number := Object.Process.Awaited (Errors, Pattern, After => Number);
         exit when Number = 0;
         Result := Result + 1;
      end loop;
      return Result;
   end Count_Of;

   function Text_Of (Object : Supervisor; From : Stream) return String is
      Result : Unbounded_String;
   begin
      for Number in 1 .. Object.Process.Count (From) loop
         Append
           (Result, Object.Process.Element (From, Number).Text & ASCII.LF);
      end loop;
      return To_String (Result);
   end Text_Of;

   function Log_Text (Object : Supervisor) return String is
     (Text_Of (Object, Errors));

   function Output_Text (Object : Supervisor) return String is
     (Text_Of (Object, Output));

   procedure Ignore_Log (Object : in out Supervisor) is
   begin
      Object.Process.Ignore (Errors);
   end Ignore_Log;

   procedure Stop (Object : in out Supervisor) is
   begin
      Object.Process.Stop;
   end Stop;

end Supervisors;
