--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor under test, as a separate process, and its log.

with Interfaces.C;    use Interfaces.C;

with Child_Processes; use Child_Processes;
with Instants;        use Instants;

package Supervisors is

   type Supervisor is tagged limited private;
   --  Killed at the end of its scope

   procedure Start
     (Object   : in out Supervisor;
      Options  : String  := "";
      Launcher : String  := "";
      Program  : String  := "";
      Bind     : String  := "127.0.0.1";
      Port     : Natural := 0);
   --  On this port of Bind, 0: a free one; waits until it listens. Options are
   --  separated by blanks. Launcher, such as "setpriv --no-new-privs", runs
   --  it. Program is another copy of it.

   procedure Be_Patient;
   --  From now on Start gives --answer-timeout 300, unless Options have one: a
   --  processor that stands still for 80 ms is no silent robot

   procedure Run
     (Object   : in out Supervisor;
      Options  : String;
      Launcher : String := "";
      Program  : String := "");
   --  The same with only these options, and without waiting

   function Console
     (Options  : String;
      Status   : Integer;
      Launcher : String := "";
      Program  : String := "") return String;
   --  All that one with only these options says. Raises Failed unless it ends
   --  by itself with Status, in time, and has not listened

   procedure Expect_Console
     (Options  : String;
      Status   : Integer;
      Text     : String;
      Launcher : String := "";
      Program  : String := "");
   --  The same; raises Failed unless Text is part of it

   Token : constant String := "correct-horse-battery";

   function Token_File
     (Text : String   := Token & ASCII.LF;
      Mode : unsigned := 8#600#;
      Name : String   := "token") return String;
   --  The path of a file for --token, made anew

   function Own_Address return String;
   --  One of 127.0.0.0/8 that no other running test uses: all ports are free

   function Port (Object : Supervisor) return Positive;

   function Pid (Object : Supervisor) return int;

   function Is_Running (Object : in out Supervisor) return Boolean;

   procedure Send_Signal (Object : Supervisor; Signal : int);

   function Exit_Status (Object : in out Supervisor) return Integer;

   function Log_Length (Object : Supervisor) return Natural;

   function Says
     (Object  : Supervisor;
      Pattern : String;
      Within  : Duration := 0.0;
      After   : Natural  := 0) return Boolean;
   --  Whether a line of the log after number After contains Pattern, now or
   --  within the time

   procedure Expect_Log
     (Object  : Supervisor;
      Pattern : String;
      After   : Natural := 0);
   --  Waits until it Says so; raises Failed if it never does

   function Time_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Instant;
   --  Time when the line with Pattern was read; Never if there is none

   function Count_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Natural;
   --  Number of lines after number After that contain Pattern

   function Log_Text (Object : Supervisor) return String;
   function Output_Text (Object : Supervisor) return String;
   --  All lines of standard error and of standard output

   procedure Ignore_Log (Object : in out Supervisor);
   --  Stops reading it, so that its pipe fills up

   procedure Stop (Object : in out Supervisor);

private

   type Supervisor is tagged limited record
      Process : Child;
      Port    : Natural := 0;
   end record;

end Supervisors;
