--  SPDX-License-Identifier: GPL-3.0-or-later
--  Settings of the running program itself. If the system refuses one, nothing
--  changes.

with Interfaces.C; use Interfaces.C;

with Libc;

package Own_Process is

   procedure Prefer_Real_Time
     (Wanted : Boolean; Priority : int := Libc.Above_Supervisor);
   --  Sets this priority for the calling thread, so that measured times
   --  exclude its own wake-up latency; or an ordinary one again

   function Real_Time_Allowed return Boolean;
   --  The highest priority, to this process; afterwards the calling thread has
   --  an ordinary one

   procedure Wake_On_Time;
   --  No timer slack for the calling thread, even at ordinary priority

   procedure Give_Way;
   --  The calling thread and those it starts run below ordinary ones

   procedure Lock_Memory;
   --  For root: locks the memory of this process. Otherwise the system could
   --  evict the page needed next, and read it from the disk again

   procedure Ignore_Broken_Pipes;
   --  The reader may close a pipe that is written to

end Own_Process;
