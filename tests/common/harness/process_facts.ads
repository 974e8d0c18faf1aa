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
   function Descriptors (Process : int) return Natural;
   --  0 when there is no such process

   function Inherited (Process : int) return String;
   --  Which of its files, but the standard streams, a program that it started
   --  would inherit: " number:file" of each

   function Has_Mapped (Process : int; Path : String) return Boolean;
   --  A file, such as a library

   function Thread_Named (Process : int; Name : String) return int;
   --  Its number, 0 if there is none. Case is ignored; the kernel keeps the
   --  first 15 characters of a name.

   function Thread_Names (Process : int) return String;

   function Real_Time_Threads (Process : int) return Natural;
   --  How many of its threads are scheduled as SCHED_FIFO

   function Processors (Process : int; Thread : int) return String;
   --  The affinity of the thread, in the kernel's notation: "0", "1-3"

end Process_Facts;
