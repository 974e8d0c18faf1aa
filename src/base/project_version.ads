--  SPDX-License-Identifier: GPL-3.0-or-later
--  The version of all that is released together.

package Project_Version with SPARK_Mode is

   Number : constant String := "1.0.0";
   --  Here and nowhere else: what else names it is checked against it

end Project_Version;
