--  SPDX-License-Identifier: GPL-3.0-or-later
--  The commands on standard input, each answered on standard output. End of
--  input ends only this, not the emulator.

package Bench_Console is

   procedure Say (Line : String);
   --  One line to standard output, at once

   procedure Start;
   --  Starts to read commands. Call once.

end Bench_Console;
