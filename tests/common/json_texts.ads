--  SPDX-License-Identifier: GPL-3.0-or-later

package Json_Texts is

   function Quoted (Text : String) return String;
   --  As JSON has it; a blank for each control character

end Json_Texts;
