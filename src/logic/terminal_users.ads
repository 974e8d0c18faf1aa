--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who uses a terminal besides, by the kernel's own texts.

with Interfaces;

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

end Terminal_Users;
