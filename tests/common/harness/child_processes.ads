--  SPDX-License-Identifier: GPL-3.0-or-later
--  Programs started by a test: their lines are collected all the time, so
--  that they never block on a full pipe, and they end with the object.

with Ada.Containers.Indefinite_Vectors;
private with Ada.Finalization;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants;   use Instants;
with Interfaces.C;

package Child_Processes is

   package String_Vectors is new Ada.Containers.Indefinite_Vectors
     (Positive, String);
   subtype Arguments is String_Vectors.Vector;

   function Words (Text : String) return Arguments;
   --  The parts of Text between blanks

   type Stream is (Output, Errors);
   --  Standard output and standard error of the program

   type Line is record
      Time : Instant;
      --  when it was read
      Text : Unbounded_String;
   end record;

   type Child is tagged limited private;
   --  Killed when it leaves its scope

   procedure Start
     (Object    : in out Child;
      Program   : String;
      Options   : Arguments := String_Vectors.Empty_Vector;
      Name      : String := "";
      Real_Time : Boolean := False);
   --  Runs Program (searched in PATH unless it has a slash). Name is for
   --  messages. Real_Time: at the lowest real-time priority where that is
   --  allowed, before all ordinary load. To be called from the environment
   --  task: the kernel ends the program with the thread that started it.

   function Pid (Object : Child) return Interfaces.C.int;

   function Is_Running (Object : in out Child) return Boolean;

   procedure Send_Signal (Object : Child; Signal : Interfaces.C.int);

   procedure Put_Line (Object : Child; Text : String);
   --  To the program's standard input

   procedure Close_Input (Object : in out Child);

   function Count (Object : Child; From : Stream) return Natural;
   --  Lines so far

   function Element
     (Object : Child; From : Stream; Number : Positive) return Line;

   function Awaited
     (Object  : Child;
      From    : Stream;
      Pattern : String;
      Within  : Duration;
      After   : Natural := 0) return Natural;
   --  Number of the first line past line After that contains Pattern; waits
   --  for it Within seconds; 0 when it did not come

   procedure Ignore (Object : in out Child; From : Stream);
   --  Reads no more of it while the program runs: what a program does whose
   --  reader has stopped

   function Exit_Status
     (Object : in out Child; Within : Duration) return Integer;
   --  Waits for the end: the exit status, or 128 + signal. Raises Failed
   --  when it has not ended in time.

   procedure Stop (Object : in out Child);
   --  Kills it if it still runs, and waits for its end

   procedure Stop_All;
   --  The same for every program still running: for an emergency end

   procedure Print_Last_Lines;
   --  Prints what the programs that were stopped since Forget_Last_Lines
   --  said last, for the account of a failed test

   function Any_Has_Failed return Boolean;
   --  Whether one of these has ended after an internal failure (exit status
   --  3) or by the signal of a fault

   procedure Forget_Last_Lines;

private

   type Parts;
   type Parts_Access is access Parts;

   type Child is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
   end record;

   overriding procedure Finalize (Object : in out Child);

end Child_Processes;
