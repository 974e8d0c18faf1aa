--  SPDX-License-Identifier: GPL-3.0-or-later
--  How late the kernel's pseudo-terminals are just now: it carries their
--  bytes in threads of ordinary priority, and on a loaded machine a stop
--  order that was written in time reaches the emulated robot late.

with Instants; use Instants;

package Line_Probes is

   procedure Start;
   --  A pseudo-terminal of its own is probed from now on, twenty times a
   --  second, by a task with real-time priority where that is allowed

   procedure Stop;
   --  Before the end of the program

   function Worst (From, To : Instant) return Duration;
   --  The greatest delay that was seen between the two; half a minute is
   --  remembered

end Line_Probes;
