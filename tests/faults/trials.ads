--  SPDX-License-Identifier: GPL-3.0-or-later
--  One injection: a session in a random state, one or two faults at random
--  times, and afterwards the five invariants.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;

with Worlds;                use Worlds;

package Trials is

   type Outcome is (Held, Violated, Impossible_Here);

   type Result is record
      Ends_As  : Outcome := Held;
      Figures  : Figure_Set;
      Account  : Unbounded_String;
      --  the violations with the state of the world, or why this machine does
      --  not permit it; several lines
   end record;

   function Name (First : Positive; Second : Natural) return String;
   --  The faults with these numbers; Second 0: only the first

   procedure Run
     (First      : Positive;
      Second     : Natural;
      Seed       : Natural;
      Repetition : Positive;
      Outcome    : out Result);
   --  In the world of this process, which is rebuilt if it does not match

   --  For a soak test, which uses the same supervisor in between

   procedure Build;
   --  The world as most faults need it. From now on a violation does not end
   --  its supervisor, unless it is its end.

   function Process return Interfaces.C.int;
   --  The current supervisor, -1 if ended by a violation

   function Port return Positive;
   --  Its port

   procedure Finish;
   --  Stops all programs

end Trials;
