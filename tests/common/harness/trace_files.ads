--  SPDX-License-Identifier: GPL-3.0-or-later
--  The file that the supervisor writes with --trace: read strictly, and
--  returned as events.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes; use Child_Processes;

package Trace_Files is

   type Event is record
      Time    : Duration := 0.0;
      Who     : Unbounded_String;
      What    : Unbounded_String;
      --  such as "wait answer"
      Command : Natural  := 0;
      --  of the monitor, 0: none
   end record;

   package Event_Vectors is new Ada.Containers.Vectors (Positive, Event);

   type Trace is record
      Tasks    : Arguments;
      Events   : Event_Vectors.Vector;
      Recorded : Natural := 0;
   end record;

   function Trace_Of (Path : String) return Trace;
   --  Raises Failed if it is not as docs/trace.md says, has no event, or a
   --  time goes back in a task

   function Count_Of (T : Trace; Who, What : String) return Natural;

end Trace_Files;
