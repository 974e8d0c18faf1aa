--  SPDX-License-Identifier: GPL-3.0-or-later
--  The options of this run, shared by all tasks: set once by the main
--  procedure before it lets the server begin.

with Options;

package Settings with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Settings);
   --  A claim that GNATprove checks: every subprogram ends

   procedure Set (Chosen : Options.Values);

   procedure Get (Chosen : out Options.Values);

end Settings;
