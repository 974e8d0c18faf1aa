--  SPDX-License-Identifier: GPL-3.0-or-later
--  The kernel's table of file locks, /proc/locks: a line for each, such as
--  "1: FLOCK  ADVISORY  WRITE 1234 00:1a:3 0 EOF", with the process and the
--  file's device and inode.

with Interfaces;
with Texts;

package Lock_Tables with SPARK_Mode is

   use type Interfaces.Unsigned_32;

   type File_Place is record
      Major, Minor : Interfaces.Unsigned_32 := 0;
      --  of its device
      Inode        : Natural := 0;
   end record;

   procedure Find
     (Table : String; File : File_Place; Owner : out Texts.Text)
   with
     Pre => Table'First = 1 and then Table'Last < Integer'Last;
   --  The number of the process that has the first lock of File in Table, in
   --  decimal; empty if there is none

end Lock_Tables;
