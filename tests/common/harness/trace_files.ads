--  SPDX-License-Identifier: GPL-3.0-or-later
--  The file that the supervisor writes with --trace: read strictly, and
--  returned as events.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Trace_Files is

   Bad_Trace : exception;
   --  It is not as docs/trace.md says

   type Nanoseconds is range -2 ** 63 .. 2 ** 63 - 1;

   subtype Name_Length is Natural range 0 .. 24;
   subtype Thread_Number is Positive range 1 .. 32;

   type Event is record
      Phase   : Character     := ' ';
      --  B, E: a job or a wait begins, ends; i: an instant
      Thread  : Thread_Number := 1;
      Time    : Nanoseconds   := 0;
      Command : Natural       := 0;     --  of the monitor, 0: none
      Text    : String (1 .. Name_Length'Last) := (others => ' ');
      Length  : Name_Length   := 0;
   end record;

   function Name (Item : Event) return String is
     (Item.Text (1 .. Item.Length));

   package Event_Vectors is new Ada.Containers.Vectors (Positive, Event);

   type Thread is record
      Name     : Unbounded_String;
      Priority : Natural := 0;
   end record;

   type Thread_Array is array (Thread_Number) of Thread;

   type Trace is limited record
      Events   : Event_Vectors.Vector;
      Threads  : Thread_Array;
      Recorded : Natural := 0;
   end record;

   procedure Read (Path : String; Result : out Trace);

   function Thread_Of (T : Trace; Name : String) return Thread_Number;
   --  Raises Bad_Trace if no task has that name

end Trace_Files;
