--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who uses a terminal besides, by the kernel's own texts.

with Interfaces;
with Texts;

package Terminal_Users with SPARK_Mode is

   use type Interfaces.Unsigned_32;

   type Device_Number is record
      Major, Minor : Interfaces.Unsigned_32 := 0;
   end record;

   function Is_Console (Table : String; Device : Device_Number) return Boolean
   with Pre => Table'First = 1 and then Table'Last < Integer'Last;
   --  The kernel writes its messages to Device. Table: /proc/consoles, a line
   --  for each, such as "ttyS0   -W- (EC p a)    4:64"

   function Is_Of_Session (Stat : String; Device : Device_Number)
     return Boolean
   with Pre => Stat'First = 1 and then Stat'Last < Integer'Last;
   --  Device is the terminal of a process' session, such as a login's. Stat:
   --  its /proc/PID/stat, such as "512 (agetty) S 1 512 512 1088 512 ..."

   type File_Place is record
      Major, Minor : Interfaces.Unsigned_32 := 0;
      --  of its device
      Inode        : Natural := 0;
   end record;

   procedure Find_Lock
     (Table : String; File : File_Place; Owner : out Texts.Text)
   with
     Pre => Table'First = 1 and then Table'Last < Integer'Last;
   --  The number of the process that has the first lock of File, in decimal;
   --  empty if there is none. Table: /proc/locks, a line for each, such as
   --  "1: FLOCK  ADVISORY  WRITE 1234 00:1a:3 0 EOF", with the process and the
   --  file's device and inode

end Terminal_Users;
