--  SPDX-License-Identifier: GPL-3.0-or-later
--  How late the kernel's pseudo-terminals are.
--
--  Between two programs a pseudo-terminal carries the bytes in a kernel
--  thread of ordinary priority. On a loaded machine that thread waits: an
--  answer that the emulated robot gave in time misses its 80 ms, and for the
--  supervisor the robot was silent; a stop order that was written in time
--  reaches the robot late. A serial line's driver knows no such thing. So a
--  byte is sent through a pseudo-terminal all the time, and its way is
--  measured.

with Instants; use Instants;

package Line_Watch is

   procedure Start;
   --  Begins to measure; nothing where it has begun already

   function Worst (From, To : Instant) return Duration;
   --  The slowest byte that was on its way between the two; 0.0 where
   --  pseudo-terminals cannot be had. The last minute is remembered.

   procedure Stop;
   --  Measures no more. For the end of the program

end Line_Watch;
