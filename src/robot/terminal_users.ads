--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who uses a terminal besides, by the kernel's own texts.

with Texts;

package Terminal_Users with SPARK_Mode is

   type Device is record
      Major : Natural range 0 .. 2 ** 12 - 1 := 0;
      Minor : Natural range 0 .. 2 ** 19 - 1 := 0;
   end record;
   --  The kernel's number for it. A minor has one bit more, which no terminal
   --  needs

   type File is record
      Itself : Device;  --  if it is one
      Place  : Device;  --  where it is
      Inode  : Natural := 0;
   end record;

   function Is_Console (Table : String; Number : Device) return Boolean
   with Pre => Table'First = 1 and then Table'Last < Integer'Last;
   --  The kernel writes its messages to the device. Table: /proc/consoles, a
   --  line for each, such as "ttyS0   -W- (EC p a)    4:64"

   function Is_Of_Session (Stat : String; Number : Device) return Boolean
   with Pre => Stat'First = 1 and then Stat'Last < Integer'Last;
   --  The device is the terminal of a process' session, such as a login's.
   --  Stat: its /proc/PID/stat, such as
   --  "512 (agetty) S 1 512 512 1088 512 ..."

   procedure Find_Lock
     (Table : String; Locked : File; Owner : out Texts.Text)
   with
     Pre => Table'First = 1 and then Table'Last < Integer'Last;
   --  The number of the process that has the first lock of the file, in
   --  decimal; empty if there is none. Table: /proc/locks, a line for each,
   --  such as "1: FLOCK  ADVISORY  WRITE 1234 00:1a:3 0 EOF", with the process
   --  and the file's place and inode

end Terminal_Users;
