--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line of this run. Read at elaboration, before any task starts,
--  so tasks read it without a lock.

with Command_Lines;

package Settings with SPARK_Mode is

   pragma Elaborate_Body;

   Command_Line : Command_Lines.Reading
     with Constant_After_Elaboration;
   --  The request and the options, or why the line is rejected

end Settings;
