--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor under test.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings;             use Ada.Strings;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;

with Expectations;            use Expectations;
with Libc;
with Plain_Numbers;           use Plain_Numbers;
with Process_Facts;

package body Supervisors is

   use type Arguments;

   Listening : constant String := "listening on ";
   Timeout   : constant String := "--answer-timeout";

   procedure Run
     (Object   : in out Supervisor;
      Options  : String;
      Launcher : String := "";
      Program  : String := "")
   is
      Path      : constant String :=
        (if Program = "" then Programs.Supervisor else Program);
      All_Words : Arguments := Words
        ((if Index (Launcher, "LD_PRELOAD") > 0 then ""
          else Programs.Preload & " ") & Launcher) & Path & Words (Options);
      First     : constant String := All_Words.First_Element;
   begin
      Object.Port := 0;
      All_Words.Delete_First;
      Object.Launch
        (First, All_Words, "supervisor " & Launcher & " " & Options);
   end Run;

   procedure Start
     (Object   : in out Supervisor;
      Options  : String  := "";
      Launcher : String  := "";
      Program  : String  := "";
      Bind     : String  := "127.0.0.1";
      Port     : Natural := 0)
   is
      Number : Natural;
   begin
      Object.Run ("--port" & Port'Image & " --bind " & Bind
                  & (if Patient and then Index (Options, Timeout) = 0
                     then " " & Timeout & " 300 " else " ") & Options,
                  Launcher, Program);
      Number := Object.Awaited (Errors, Listening, Patience);
      Check (Number > 0, "the supervisor does not listen");
      declare
         Line  : constant String :=
           To_String (Object.Element (Errors, Number).Text);
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
   begin
      S.Run (Options, Launcher, Program);
      S.Expect_Exit (Status);
      Check_Within
        (Now - Start,
         (if Index (Options, "--check") > 0 then Check_Limit else End_Limit),
         Options);
      return Text : constant String := S.Text (Output) & S.Text do
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

   function Own_Address return String is
      Process : constant Natural := Natural (Libc.Getpid);
   begin
      return "127." & Image (64 + Process / 65_536) & "."
        & Image (Process / 256 mod 256) & "." & Image (Process mod 256);
   end Own_Address;

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
        Object.Awaited (Errors, Pattern, After => After);
   begin
      return
        (if Number = 0 then Never else Object.Element (Errors, Number).Time);
   end Time_Of;

   function Count_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Natural
   is
      Result : Natural := 0;
      Number : Natural := After;
   begin
      loop
         Number := Object.Awaited (Errors, Pattern, After => Number);
         exit when Number = 0;
         Result := Result + 1;
      end loop;
      return Result;
   end Count_Of;

   procedure Expect_End (Object : in out Supervisor) is
   begin
      Object.Send_Signal (Libc.Sigterm);
      Object.Expect_Exit (0);
   end Expect_End;

   procedure Fail (Object : in out Supervisor; Thread : String) is
   begin
      Check
        (Libc.Tgkill
           (Object.Pid, Process_Facts.Thread_Named (Object.Pid, Thread),
            Libc.Sigsegv) = 0,
         "the thread cannot be signalled");
      Object.Expect_Exit (3);
   end Fail;

   procedure Start_Monitor
     (Tool : in out Child; Port : Positive; Lines : String;
      Options : String := "") is
   begin
      Tool.Launch
        (Programs.Monitor,
         Words ("--script - --port" & Port'Image & " " & Options),
         "console monitor " & Options);
      for Line of Words (Lines, '|') loop
         Tool.Put_Line (Line);
      end loop;
   end Start_Monitor;

   procedure Expect_Monitor
     (Port : Positive; Lines, Options : String; Status : Integer)
   is
      Tool : Child;
   begin
      Start_Monitor (Tool, Port, Lines, Options);
      Tool.Close_Input;
      Tool.Expect_Exit (Status);
   end Expect_Monitor;

end Supervisors;
