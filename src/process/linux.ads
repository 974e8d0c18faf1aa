--  SPDX-License-Identifier: GPL-3.0-or-later
--  C library functions shared by the device bodies, with constants of the
--  Linux kernel's interface. For bodies outside SPARK only.

with GNAT.OS_Lib;
with Interfaces;
with Interfaces.C; use Interfaces.C;
with System;

package Linux with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   type Ssize is range -(2 ** (Standard'Address_Size - 1)) ..
                       2 ** (Standard'Address_Size - 1) - 1;

   type Poll_Entry is record
      Descriptor : int;
      Events     : short;
      Returned   : short := 0;
   end record with Convention => C;

   Poll_In : constant short := 16#0001#;

   type Time_Spec is record
      Seconds     : long;
      Nanoseconds : long;
   end record with Convention => C;

   procedure Poll
     (Entries : System.Address; Count : unsigned_long; Wait_Ms : int)
   with Import, Convention => C, External_Name => "poll";

   function Precise_Poll
     (Entries : System.Address; Count : unsigned_long;
      Wait, Mask : System.Address) return int
   with Import, Convention => C, External_Name => "ppoll";

   function Read
     (Descriptor : int; Data : System.Address; Length : size_t) return Ssize
   with Import, Convention => C, External_Name => "read";

   function Write
     (Descriptor : int; Data : System.Address; Length : size_t) return Ssize
   with Import, Convention => C, External_Name => "write";

   procedure Close (Descriptor : int)
   with Import, Convention => C, External_Name => "close";
   --  No result: nothing can be done about a failure

   function Open_File
     (Path : char_array; Flags : int; Mode : unsigned := 0) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   To_Read_Only : constant int := 8#2004400#;
   --  O_RDONLY, O_CLOEXEC, O_NONBLOCK, O_NOCTTY

   --  The kernel's struct statx (linux/stat.h), the same on all platforms
   type File_Status is array (1 .. 64) of Interfaces.Unsigned_32
     with Convention => C;
   --  Words 6: the owner, 8: the mode, in the lower half (little-endian),
   --  9 and 10: the inode, 35 and 36: the device's major and minor number, 33
   --  and 34: those of the device that it is

   function Status_Of
     (Folder : int; Path : char_array; Flags : int; Mask : unsigned;
      Status : System.Address) return int
   with Import, Convention => C, External_Name => "statx";

   function Event_Counter (Initial : unsigned; Flags : int) return int
   with Import, Convention => C, External_Name => "eventfd";

   Event_Blocking : constant int := 8#2000000#;  --  EFD_CLOEXEC

   procedure Control (Descriptor : int; Request : unsigned_long)
   with Import, Convention => C_Variadic_2, External_Name => "ioctl";

   Close_On_Exec : constant unsigned_long := 16#5451#;
   --  FIOCLEX. For what GNAT's library opens: a program that OpenCV's
   --  libraries start, such as GStreamer's scanner, inherits nothing

   function Set_Scheduler
     (Thread, Policy : int; Priority : System.Address) return int
   with Import, Convention => C, External_Name => "sched_setscheduler";

   Time_Shared        : constant int := 0;  --  SCHED_OTHER
   First_In_First_Out : constant int := 1;  --  SCHED_FIFO

   function Own_Process return int
   with Import, Convention => C, External_Name => "getpid";

   function Outcome_Of (Returned : Ssize) return Integer is
     (if Returned < 0 then Integer'Min (-1, -GNAT.OS_Lib.Errno)
      else Integer (Returned));
   --  Of a call: what it returned, or, if it has failed, its error, negative

end Linux;
