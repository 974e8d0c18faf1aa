--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls of the C library that the emulator needs, with Linux's numbers.

with Interfaces;
with Interfaces.C; use Interfaces.C;
with System;

package Libc is

   subtype Descriptor is int range -1 .. int'Last;

   No_Descriptor : constant Descriptor := -1;

   subtype Byte_Count is long;
   --  ssize_t: how many bytes, -1 after a failure

   --  Time

   subtype Nanoseconds is Interfaces.Integer_64;
   --  Of CLOCK_MONOTONIC, or a difference of two such times

   function Now return Nanoseconds;

   --  Files

   function Read
     (Fd : Descriptor; Data : System.Address; Length : size_t)
      return Byte_Count
     with Import, Convention => C, External_Name => "read";

   function Write
     (Fd : Descriptor; Data : System.Address; Length : size_t)
      return Byte_Count
     with Import, Convention => C, External_Name => "write";

   function Close (Fd : Descriptor) return int
     with Import, Convention => C, External_Name => "close";

   procedure Close (Fd : in out Descriptor);
   --  Closes it unless it is No_Descriptor, which it is afterwards

   function Open (Path : char_array; Flags : int) return Descriptor
     with Import, Convention => C_Variadic_2, External_Name => "open";

   O_RDWR     : constant := 8#2#;
   O_NOCTTY   : constant := 8#400#;
   O_NONBLOCK : constant := 8#4000#;
   O_CLOEXEC  : constant := 8#2000000#;

   function Change_Mode (Path : char_array; Mode : unsigned) return int
     with Import, Convention => C, External_Name => "chmod";

   function Make_Link (Target, Path : char_array) return int
     with Import, Convention => C, External_Name => "symlink";

   function Read_Link
     (Path : char_array; Data : System.Address; Length : size_t)
      return Byte_Count
     with Import, Convention => C, External_Name => "readlink";

   function Remove (Path : char_array) return int
     with Import, Convention => C, External_Name => "unlink";

   function Rename (From, To : char_array) return int
     with Import, Convention => C, External_Name => "rename";

   function Last_Error return String;
   --  What went wrong with the last call of this task, in words

   --  Waiting

   type Poll_Entry is record
      Fd      : Descriptor := No_Descriptor;
      Events  : short := 0;
      Revents : short := 0;
   end record with Convention => C;

   type Poll_Array is array (Positive range <>) of Poll_Entry
     with Convention => C;

   POLLIN    : constant short := 16#0001#;
   POLLOUT   : constant short := 16#0004#;
   POLLRDHUP : constant short := 16#2000#;

   procedure Poll (Set : in out Poll_Array; Wait : Nanoseconds);
   --  Until something is ready or Wait has passed; at once where Wait is
   --  not positive. A failure or a signal looks like nothing ready.

   function Event_Descriptor
     (Initial : unsigned; Flags : int) return Descriptor
     with Import, Convention => C, External_Name => "eventfd";

   --  Terminals

   function Open_Master (Flags : int) return Descriptor
     with Import, Convention => C, External_Name => "posix_openpt";

   function Grant (Master : Descriptor) return int
     with Import, Convention => C, External_Name => "grantpt";

   function Unlock (Master : Descriptor) return int
     with Import, Convention => C, External_Name => "unlockpt";

   function Slave_Name
     (Master : Descriptor; Name : System.Address; Length : size_t) return int
     with Import, Convention => C, External_Name => "ptsname_r";

   procedure Make_Raw (Terminal : Descriptor; Done : out Boolean);
   --  8 bits, no echo, nothing translated, 9600 baud for who asks

   --  Priorities and signals. Where the system refuses, nothing changes.

   procedure Prefer_Real_Time;
   --  The calling task runs ahead of all ordinary ones, as hardware would,
   --  and wakes up on time; an ordinary user only gets the latter

   procedure Lock_Memory;
   --  For root: what this process has once used stays in memory, as a
   --  robot's own would. Elsewhere the system could take the page that is
   --  needed next, and read it from the disk again

   procedure Give_Way;
   --  The calling task and its threads run behind ordinary ones

   procedure Ignore_Broken_Pipes;

end Libc;
