--  SPDX-License-Identifier: GPL-3.0-or-later
--  The version of the project, the same for all that is released.

package Project_Version with SPARK_Mode is

   Number : constant String := "1.0.0";
   --  The only definition; other places that name it are checked against it

end Project_Version;
