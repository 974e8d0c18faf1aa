--  SPDX-License-Identifier: GPL-3.0-or-later
--  The processor time that the supervisor's tasks use, from the kernel, and
--  beside it what the response-time analysis allows them.

with Interfaces.C;

package Task_Times is

   procedure Start (Process : Interfaces.C.int);
   --  Looks at all its tasks about twice in a millisecond, until Stop. Not
   --  for the time of a measurement of delays: it costs some itself

   procedure Stop;

   procedure Print;
   --  To the report: how long each run of each task took, beside its budget.
   --  What a task does without a pause of 2 ms counts as one run

end Task_Times;
