--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line of this run, read while the program is elaborated: before
--  any task begins, so that all may read it without a lock.

with Command_Lines;

package Settings with SPARK_Mode is

   pragma Elaborate_Body;

   Command_Line : Command_Lines.Reading
     with Constant_After_Elaboration;
   --  What is asked for, and the options; or why it is not understood

end Settings;
