--  SPDX-License-Identifier: GPL-3.0-or-later
--  How late the kernel's pseudo-terminals are.
--
--  Between two programs a pseudo-terminal carries the bytes in a kernel
--  thread of ordinary priority. On a loaded machine that thread waits, and
--  an answer that the emulated robot gave in time misses its 80 ms: for the
--  supervisor the robot was silent, and a test that demands its answer
--  fails. A serial line's driver knows no such thing. So a byte is sent
--  through a pseudo-terminal all the time, and its way is measured.

package Line_Watch is

   procedure Start;
   --  Begins to measure; nothing where it has begun already

   procedure Forget;
   --  What was measured so far

   function Worst return Duration;
   --  The slowest byte since; 0.0 where pseudo-terminals cannot be had

   procedure Stop;
   --  Measures no more. For the end of the program

end Line_Watch;
