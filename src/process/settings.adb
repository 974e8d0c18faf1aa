--  SPDX-License-Identifier: GPL-3.0-or-later

with Process;
with Texts;

package body Settings with SPARK_Mode is

begin

   for I in 1 .. Process.Argument_Count loop
      if Process.Is_Whole (I) then
         Command_Lines.Take
           (Command_Line, Texts.Image (Process.Argument (I)));
      else
         Command_Lines.Refuse_Long (Command_Line);
      end if;
   end loop;
   Command_Lines.Finish (Command_Line);

end Settings;
