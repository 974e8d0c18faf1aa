--  SPDX-License-Identifier: GPL-3.0-or-later
--  The threads of the process: their names, and the processors they run on.

with Options;
with Schedule;

package Process.Threads with
  SPARK_Mode,
  Abstract_State =>
    (Named with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Named
is

   procedure Name_Task (Who : Schedule.Task_Name)
   with Global => (In_Out => (Named, System_State));
   --  The calling task is Who: ps -L and top -H show the first 15 letters of
   --  its name; the stack of a real-time task is in memory from here on.
   --  First of all that a task does, and once

   procedure Keep_On
     (Cpu : in out Options.Processor_Choice; Alone, Done : out Boolean)
   with Global => (In_Out => (Named, System_State));
   --  From here on the real-time tasks run on processor Cpu alone, and all
   --  other threads on the others; Alone: there are none. Cpu becomes the one
   --  that was meant. Done is false where this process may not run on Cpu

end Process.Threads;
