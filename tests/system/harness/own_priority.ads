--  SPDX-License-Identifier: GPL-3.0-or-later
--  The priority of the thread that measures: the times that it notes are not
--  to be those of its own waiting.

package Own_Priority is

   procedure Prefer_Real_Time (Wanted : Boolean);
   --  For the calling thread, where it is allowed: Libc.Above_Supervisor, or
   --  an ordinary one again. Where it is not, nothing changes.

   function Real_Time_Allowed return Boolean;
   --  To this process; the calling thread is an ordinary one afterwards

end Own_Priority;
