--  SPDX-License-Identifier: GPL-3.0-or-later
--  The option --check: reports what would work on this machine and what would
--  not, with advice.

with Options;

package Checks with SPARK_Mode is

   procedure Run (Chosen : Options.Values; All_Well : out Boolean);
   --  Tries privileges, serial line, camera, token file, trace file and port,
   --  and reports each, and memory and kernel, in a line on standard output.
   --  Changes nothing

end Checks;
