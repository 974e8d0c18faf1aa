--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the figures were taken on, and with what rights.

package Machines is

   procedure Report;

   function File_Line (Path : String; Key : String := "") return String;
   --  The first line of a file that contains Key; "" if there is none

end Machines;
