--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the host of a virtual machine takes for others: the eighth figure of
--  the first line of /proc/stat.

with Ada.Text_IO; use Ada.Text_IO;

package body Host_Time is

   package Integers is new Ada.Text_IO.Integer_IO (Long_Long_Integer);

   Tick  : constant Duration := 0.01;
   --  of these figures, whatever the kernel's own is (USER_HZ)
   Label : constant := 3;
   --  "cpu"
   Steal : constant := 8;
   --  after user, nice, system, idle, waiting and two of interrupts

   function Taken return Duration is
      File  : File_Type;
      Value : Long_Long_Integer := 0;
      Last  : Natural;
   begin
      Open (File, In_File, "/proc/stat");
      declare
         Line : constant String := Get_Line (File);
      begin
         Close (File);
         Last := Line'First + Label - 1;
         for Field in 1 .. Steal loop
            Integers.Get (Line (Last + 1 .. Line'Last), Value, Last);
         end loop;
      end;
      return Tick * Integer (Value);
   exception
      when Name_Error | Use_Error | Data_Error | End_Error =>
         return 0.0;
   end Taken;

end Host_Time;
