--  SPDX-License-Identifier: GPL-3.0-or-later
--  The threads of the process: their names, and the processors they run on.

package Process.Threads with
  SPARK_Mode,
  Abstract_State =>
    (Named with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Named
is

   procedure Name_Task (Name : String; Real_Time : Boolean := True)
   with
     Global => (In_Out => (Named, System_State)),
     Pre    => Name'Length <= 15;
   --  The calling task's name, as ps -L and top -H show it, and whether
   --  Keep_On is for it; the stack of one with Real_Time is in memory from
   --  here on. First of all that a task does, and once

   procedure Keep_On (Cpu : Natural; Done : out Boolean)
   with Global => (In_Out => (Named, System_State));
   --  From here on the real-time tasks run on processor Cpu alone, and all
   --  other threads on the others, where there are any. Done is false where
   --  this process may not run on Cpu

end Process.Threads;
