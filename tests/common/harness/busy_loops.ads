--  SPDX-License-Identifier: GPL-3.0-or-later
--  Load on the machine: two processes in a busy loop.

with Child_Processes;

package Busy_Loops is

   type Load is tagged limited private;
   --  Ends at the end of its scope

   procedure Start (Object : in out Load; Yielding : Boolean := False);
   --  Yielding: of the least weight, also as a session of its own, so that
   --  kernel threads, which carry the bytes of a pseudo-terminal, go first

   procedure Stop (Object : in out Load);

private

   type Children is array (1 .. 2) of Child_Processes.Child;

   type Load is tagged limited record
      Loops : Children;
   end record;

end Busy_Loops;
