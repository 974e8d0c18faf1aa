--  SPDX-License-Identifier: GPL-3.0-or-later
--  The processor time that the supervisor's tasks use, from the kernel, and
--  beside it what the response-time analysis allows them.

with Interfaces.C;

package Task_Times is

   procedure Start (Process : Interfaces.C.int; Except : String := "");
   --  Looks at all its tasks about twice in a millisecond, until Stop; at all
   --  but the one of the name Except. Not for the time of a measurement of
   --  delays: it costs some itself

   procedure Begin_Exchange;
   procedure End_Exchange;
   --  What a task does in between that uses the line is an exchange with the
   --  robot: a run for the request, and one for the answer. If it is more,
   --  there was another exchange, and these are not told apart

   procedure Stop;

   procedure Print;
   --  To the report: how long each run of each task took so far, in all
   --  processes, beside its budget. What a task does without a pause of 2 ms
   --  counts as one run; of the line that can be an answer and the next
   --  request. What it does while its process ends does not count

end Task_Times;
