--  SPDX-License-Identifier: GPL-3.0-or-later
--  The response times of the tasks, out of a file of --trace, beside the
--  bounds of the response-time analysis.

package Trace_Responses is

   --  An activity is what the analysis calls one: what a task does between
   --  two waits. Its response is the time from its release to its end. What
   --  releases it:
   --    - the clock: the nominal instant;
   --    - another task: the moment in which it signals the event, but for
   --      a task that uses the line not before the transaction before has
   --      ended (the analysis takes these for one after the other);
   --    - the kernel (socket, robot's answer, camera): when the task has
   --      seen it. The kernel's own latency is missing there.

   procedure Report (Path : String);
   --  Of the trace in the file Path; where it is empty, of one that is made
   --  first, under the load that the analysis takes for granted: 20 commands
   --  a second, images with positions, and two busy loops; and another beside
   --  missions. The supervisor runs with --cpu, where there is more than one
   --  processor, and so must have that of the file

end Trace_Responses;
