--  SPDX-License-Identifier: GPL-3.0-or-later
--  Programs started by a test: their output is always read, so that they never
--  block on a full pipe, and they end with the object.

with Ada.Containers.Indefinite_Vectors;
private with Ada.Finalization;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants;              use Instants;
with Interfaces.C;          use Interfaces.C;

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

   procedure Launch
     (Object  : in out Child;
      Program : String;
      Options : Arguments;
      Name    : String := "");
   --  Runs Program (searched in PATH unless it has a slash). Name is used in
   --  messages. To be called by the environment task: the kernel ends the
   --  program with the thread that started it.

   procedure Launch
     (Object : in out Child; Command : String; Separator : Character := ' ');
   --  The same; Command has the program, which is also the name, and its
   --  options

   function Status_Of
     (Command : String; Separator : Character := ' ') return Integer;
   --  Runs it to its end: its exit status

   function Pid (Object : Child) return int;

   function Is_Running (Object : in out Child) return Boolean;

   procedure Send_Signal (Object : Child; Signal : int);

   procedure Put_Line (Object : Child; Text : String);
   --  Writes to the program's standard input

   procedure Close_Input (Object : in out Child);

   function Count (Object : Child; From : Stream := Errors) return Natural;
   --  Number of lines so far

   function Element
     (Object : Child; From : Stream; Number : Positive) return Line;

   function Text (Object : Child; From : Stream := Errors) return String;
   --  All lines so far

   function Awaited
     (Object  : Child;
      From    : Stream;
      Pattern : String;
      Within  : Duration := 0.0;
      After   : Natural  := 0) return Natural;
   --  Number of the first line after number After that contains Pattern; waits
   --  for it Within seconds; 0 if it did not come

   function Says
     (Object  : Child;
      Pattern : String;
      Within  : Duration := 0.0;
      After   : Natural  := 0;
      From    : Stream   := Errors) return Boolean
   is (Object.Awaited (From, Pattern, Within, After) > 0);
   --  Whether such a line came

   procedure Ignore_Errors (Object : in out Child);
   --  Stops reading standard error while it runs, so that its pipe fills up

   function Exit_Status (Object : in out Child) return Integer;
   --  Waits for the end: the exit status, or 128 + signal. Raises Failed if it
   --  does not end

   procedure Expect_Exit (Object : in out Child; Status : Integer);
   --  The same; raises Failed unless it is Status

   procedure Stop (Object : in out Child);
   --  Kills it if it still runs, and waits for its end

   procedure Print_Last_Lines;
   --  Prints the last output of the programs stopped last, for the report of a
   --  failed test

private

   type Parts;
   type Parts_Access is access Parts;

   type Child is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
   end record;

   overriding procedure Finalize (Object : in out Child);

end Child_Processes;
