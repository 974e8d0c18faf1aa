--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package body Json_Texts is

   function Quoted (Text : String) return String is
      Result : Unbounded_String;
   begin
      for C of Text loop
         if C in '"' | '\' then
            Append (Result, '\');
         end if;
         Append (Result, (if C < ' ' then ' ' else C));
      end loop;
      return """" & To_String (Result) & """";
   end Quoted;

end Json_Texts;
