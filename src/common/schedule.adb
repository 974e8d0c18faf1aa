--  SPDX-License-Identifier: GPL-3.0-or-later

package body Schedule with SPARK_Mode is

   function Name_Of (Who : Task_Name) return String is
      Name : String renames Table (Who).Name;
      Last : Positive := 1;
   begin
      while Last < Name'Last and then Name (Last + 1) /= ' ' loop
         pragma Loop_Variant (Increases => Last);
         Last := Last + 1;
      end loop;
      return Name (1 .. Last);
   end Name_Of;

end Schedule;
