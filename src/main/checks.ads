--  SPDX-License-Identifier: GPL-3.0-or-later
--  What would work here and what would not, and how to mend it: the option
--  --check.

with Options;

package Checks with SPARK_Mode is

   procedure Run (Chosen : Options.Values; All_Well : out Boolean);
   --  Tries privileges, serial line, camera, token file, trace file and
   --  port, and reports each in a line on standard output. Leaves all as it
   --  was

end Checks;
