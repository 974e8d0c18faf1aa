--  SPDX-License-Identifier: GPL-3.0-or-later
--  One injection: a session in a random state, a fault or two at random
--  moments, and the five invariants afterwards.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;

with Worlds;                use Worlds;

package Trials is

   type Outcome is (Held, Violated, Impossible_Here);

   type Result is record
      Ends_As  : Outcome := Held;
      Figures  : Figure_Set;
      Account  : Unbounded_String;
      --  what was violated and in which state of the world, or why this
      --  machine does not allow it; several lines
   end record;

   function Name (First : Positive; Second : Natural) return String;
   --  Of the faults with these numbers; Second 0: the first alone

   procedure Run
     (First      : Positive;
      Second     : Natural;
      Seed       : Natural;
      Repetition : Positive;
      Outcome    : out Result);
   --  In the world of this process, which is built anew where it does not
   --  fit

   --  For a soak, which does other things with the same supervisor in
   --  between

   procedure Build;
   --  The world as most faults need it. From now on a violation, unless it
   --  is its end, does not end its supervisor.

   function Process return Interfaces.C.int;
   --  The supervisor of now, -1 where a violation has ended it

   function Port return Positive;
   --  Where it listens

   procedure Finish;
   --  Leaves nothing running

end Trials;
