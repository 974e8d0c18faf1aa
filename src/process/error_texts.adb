--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.OS_Lib;

package body Error_Texts with SPARK_Mode => Off is
   --  Off: GNAT.OS_Lib is not in SPARK

   procedure Describe (Error : Integer; Text : out Texts.Text) is
   begin
      Texts.Set (Text, GNAT.OS_Lib.Errno_Message (Error));
   end Describe;

end Error_Texts;
