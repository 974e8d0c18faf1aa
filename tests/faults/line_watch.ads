--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measures the delay of the kernel's pseudo-terminals.
--
--  The kernel carries the bytes of a pseudo-terminal in a thread of ordinary
--  priority. On a loaded machine that thread is delayed: an answer that the
--  emulated robot gave in time misses its 80 ms, and a stop order written in
--  time reaches the robot late. The driver of a serial line has no such delay.
--  So bytes are sent continuously through a pseudo-terminal, and their delay
--  is measured.

with Instants; use Instants;

package Line_Watch is

   procedure Start;
   --  Starts the measurement; no effect if started already

   function Worst (From, To : Instant) return Duration;
   --  The largest delay of a byte sent between the two times; 0.0 if
   --  pseudo-terminals are unavailable. The last minute is stored.

   procedure Stop;
   --  Stops the measurement. For the end of the program

end Line_Watch;
