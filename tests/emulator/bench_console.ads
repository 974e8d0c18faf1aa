--  SPDX-License-Identifier: GPL-3.0-or-later
--  The commands on standard input, each answered on standard output. The
--  end of the input ends only this, not the emulator.

package Bench_Console is

   procedure Say (Line : String);
   --  One line to standard output, at once

   procedure Start;
   --  From now on commands are read. Once.

end Bench_Console;
