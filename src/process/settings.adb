--  SPDX-License-Identifier: GPL-3.0-or-later

with Program_Arguments;
with Texts;

package body Settings with SPARK_Mode is

begin

   for I in 1 .. Program_Arguments.Count loop
      if Program_Arguments.Is_Whole (I) then
         Command_Lines.Take
           (Command_Line, Texts.Image (Program_Arguments.Argument (I)));
      else
         Command_Lines.Refuse_Long (Command_Line);
      end if;
   end loop;
   Command_Lines.Finish (Command_Line);

end Settings;
