--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel says about a process that a test has started, and in
--  other files of its own.

with Interfaces.C; use Interfaces.C;

package Process_Facts is

   function File_Line (Path : String; Key : String := "") return String;
   --  The first line of a file that contains Key; "" if there is none

   function Resident_Kilobytes (Process : int) return Natural;
   function Locked_Kilobytes (Process : int) return Natural;
   --  Of its address space, whether in memory yet or not
   function Threads (Process : int) return Natural;
   function Descriptors (Process : int) return Natural;
   --  0 when there is no such process

   function Next_Descriptor (Process : int) return Natural;
   --  The number of the one that it would open now: the lowest free one

   function Open_File (Process : int; Descriptor : Natural) return String;
   --  What is behind it, as the kernel names it: a path, "pipe:[123]"; ""
   --  where it is closed

   function Has_Mapped (Process : int; Path : String) return Boolean;
   --  A file, such as a library

   function Thread_Named (Process : int; Name : String) return int;
   --  Its number, 0 when there is none. Upper and lower case count as one;
   --  the kernel keeps the first 15 characters of a name.

   function Thread_Names (Process : int) return String;

   function Thread_Waits (Process : int) return String;
   --  " name:function" of each thread, function being that of the kernel in
   --  which it waits, "0" where it does not

   function Processors (Process : int; Thread : int) return String;
   --  Where the thread may run, as the kernel writes it: "0", "1-3"

end Process_Facts;
