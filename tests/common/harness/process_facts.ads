--  SPDX-License-Identifier: GPL-3.0-or-later
--  Facts about a process started by a test, from the kernel and its other
--  files.

with Interfaces.C; use Interfaces.C;

package Process_Facts is

   function File_Line (Path : String; Key : String := "") return String;
   --  The first line of a file that contains Key; "" if there is none

   function State (Process : int) return String;
   --  The line of its status in the kernel (proc_pid_stat(5)), and the
   --  kernel's function in which it waits

   function Resident_Kilobytes (Process : int) return Natural;
   function Locked_Kilobytes (Process : int) return Natural;
   --  Of its address space, resident or not
   function Threads (Process : int) return Natural;
   --  0 when there is no such process

   type Footprint is record
      Kilobytes, Threads, Descriptors : Natural := 0;
   end record;

   function Footprint_Of (Process : int) return Footprint;

   procedure Expect_Flat
     (Process : int; Before : Footprint; Kilobytes : Natural := 1024);
   --  Raises Failed if it keeps more than before, and than so much more memory

   function Inherited (Process : int) return String;
   --  Which of its files, but the standard streams, a program that it started
   --  would inherit: " number:file" of each

   function Has_Mapped (Process : int; Path : String) return Boolean;
   --  A file, such as a library

   function Thread_Named (Process : int; Name : String) return int;
   --  Its number. Case is ignored; the kernel keeps the first 15 characters of
   --  a name. Raises Failed if there is none

   function Thread_Names (Process : int) return String;

   function Real_Time_Threads (Process : int) return Natural;
   --  How many of its threads are scheduled as SCHED_FIFO

   function Processors (Process : int; Thread : String) return String;
   --  The affinity of the thread with this name, in the kernel's notation:
   --  "0", "1-3"

end Process_Facts;
