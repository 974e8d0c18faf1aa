--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the running program asks of the system for itself. Where the system
--  refuses, nothing changes.

with Interfaces.C; use Interfaces.C;

with Libc;

package Own_Process is

   procedure Prefer_Real_Time
     (Wanted : Boolean; Priority : int := Libc.Above_Supervisor);
   --  For the calling thread: this priority, so that the times it notes are
   --  not those of its own waiting; or an ordinary one again

   function Real_Time_Allowed return Boolean;
   --  To this process; the calling thread is an ordinary one afterwards

   procedure Wake_On_Time;
   --  The calling thread wakes up on time, even if it is an ordinary one

   procedure Give_Way;
   --  The calling thread and those that it starts run behind ordinary ones

   procedure Lock_Memory;
   --  For root: what this process has once used stays in memory. Elsewhere
   --  the system could take the page that is needed next, and read it from
   --  the disk again

   procedure Ignore_Broken_Pipes;
   --  The other end may close what is being written to

   procedure Allow_Descriptors;
   --  As many for this process as it may have

end Own_Process;
