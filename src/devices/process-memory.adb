--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C;            use Interfaces.C;
with Process.Privileges;
with System.Storage_Elements; use System.Storage_Elements;

package body Process.Memory with SPARK_Mode => Off is

   Current_On_Fault : constant int := 1 + 2 + 4;
   --  MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT

   function Lock_All (Flags : int) return int
   with Import, Convention => C, External_Name => "mlockall";

   procedure Lock_Part (Start : System.Address; Length : size_t)
   with Import, Convention => C, External_Name => "mlock";

   --  Of the program itself, from the linker
   Code_Start : char
   with Import, Convention => C, External_Name => "__executable_start";
   Code_End : char
   with Import, Convention => C, External_Name => "etext";

   procedure Lock (Done : out Boolean) is
   begin
      --  Under a limit a later allocation could fail. Only what is used is
      --  kept: all of what OpenCV brings along would be a gigabyte
      Privileges.Get_May_Lock (Done);
      Done := Done and then Lock_All (Current_On_Fault) = 0;
      if Done then
         --  the code that has not been needed so far, such as that of a
         --  stop, is not to be read from a slow disk when it is
         Lock_Part
           (Code_Start'Address,
            size_t (Code_End'Address - Code_Start'Address));
      end if;
   end Lock;

   procedure Touch_Stack is
      Page  : constant := 4_096;
      Depth : constant := 16 * Page;
      Stack : array (1 .. Depth) of char with Volatile;
   begin
      for Page_Number in 0 .. Depth / Page - 1 loop
         Stack (Page_Number * Page + 1) := nul;
      end loop;
   end Touch_Stack;

end Process.Memory;
