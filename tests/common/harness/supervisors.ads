--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor under test, as a separate process, and its log, which is its
--  standard error; and the project's own monitor.

with Interfaces.C;    use Interfaces.C;

with Child_Processes; use Child_Processes;
with Instants;        use Instants;
with Programs;

package Supervisors is

   type Supervisor is new Child with record
      Port : Natural := 0;
   end record;
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

   Patient : Boolean := False;
   --  Start gives --answer-timeout 300, unless Options have one: a processor
   --  that stands still for 80 ms is no silent robot

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
      Name : String   := "token") return String
   is (Programs.New_File (Name, Text, Mode));
   --  The path of a file for --token

   function Own_Address return String;
   --  One of 127.0.0.0/8 that no other running test uses: all ports are free

   procedure Expect_Log
     (Object  : Supervisor;
      Pattern : String;
      After   : Natural := 0);
   --  Waits until its log says so; raises Failed if it never does

   function Time_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Instant;
   --  Time when the line with Pattern was read; Never if there is none

   function Count_Of
     (Object : Supervisor; Pattern : String; After : Natural := 0)
      return Natural;
   --  Number of lines after number After that contain Pattern

   procedure Expect_End (Object : in out Supervisor);
   --  Sends SIGTERM; raises Failed unless it ends with status 0

   procedure Fail (Object : in out Supervisor; Thread : String);
   --  Makes a task fail, by a signal that the run time turns into an
   --  exception; raises Failed unless the supervisor ends with status 3

   procedure Start_Monitor
     (Tool : in out Child; Port : Positive; Lines : String;
      Options : String := "");
   --  The project's own monitor, with a script of Lines, which '|' separates;
   --  it can be given more

   procedure Expect_Monitor
     (Port : Positive; Lines, Options : String; Status : Integer);
   --  The same, to its end; raises Failed unless that is with Status

end Supervisors;
