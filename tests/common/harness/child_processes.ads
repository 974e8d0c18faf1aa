--  SPDX-License-Identifier: GPL-3.0-or-later
--  Programs started by a test: their output is always read, so that they never
--  block on a full pipe, and they end with the object.

with Ada.Containers.Indefinite_Vectors;
private with Ada.Finalization;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants;   use Instants;
with Interfaces.C;

package Child_Processes is

   package String_Vectors is new Ada.Containers.Indefinite_Vectors
     (Positive, String);
   subtype Arguments is String_Vectors.Vector;

   function Words
     (Text : String; Separator : Character := ' ') return Arguments;
   --  The parts of Text that are not empty

   type Stream is (Output, Errors);
   --  Standard output and standard error of the program

   type Line is record
      Time : Instant;
      --  when it was read
      Text : Unbounded_String;
   end record;

   type Child is tagged limited private;
   --  Killed at the end of its scope

   procedure Start
     (Object    : in out Child;
      Program   : String;
      Options   : Arguments := String_Vectors.Empty_Vector;
      Name      : String := "");
   --  Runs Program (searched in PATH unless it has a slash). Name is used in
   --  messages. To be called by the environment task: the kernel ends the
   --  program with the thread that started it.

   function Pid (Object : Child) return Interfaces.C.int;

   function Is_Running (Object : in out Child) return Boolean;

   procedure Send_Signal (Object : Child; Signal : Interfaces.C.int);

   procedure Put_Line (Object : Child; Text : String);
   --  Writes to the program's standard input

   procedure Close_Input (Object : in out Child);

   function Count (Object : Child; From : Stream) return Natural;
   --  Number of lines so far

   function Element
     (Object : Child; From : Stream; Number : Positive) return Line;

   function Awaited
     (Object  : Child;
      From    : Stream;
      Pattern : String;
      Within  : Duration := 0.0;
      After   : Natural  := 0) return Natural;
   --  Number of the first line after number After that contains Pattern; waits
   --  for it Within seconds; 0 if it did not come

   procedure Ignore (Object : in out Child; From : Stream);
   --  Stops reading its output while it runs: a program whose reader has
   --  stopped

   function Exit_Status (Object : in out Child) return Integer;
   --  Waits for the end: the exit status, or 128 + signal. Raises Failed if it
   --  does not end

   procedure Stop (Object : in out Child);
   --  Kills it if it still runs, and waits for its end

   procedure Stop_All;
   --  The same for all programs still running: for an abort

   procedure Print_Last_Lines;
   --  Prints the last output of the programs stopped since Forget_Last_Lines,
   --  for the report of a failed test

   procedure Forget_Last_Lines;

private

   type Parts;
   type Parts_Access is access Parts;

   type Child is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
   end record;

   overriding procedure Finalize (Object : in out Child);

end Child_Processes;
