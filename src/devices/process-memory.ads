--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of the process: that it is there when it is needed.

package Process.Memory with SPARK_Mode is

   procedure Lock (Done : out Boolean)
   with Global => (In_Out => System_State);
   --  From here on, what this process has once used stays in memory, and so
   --  does all of the program's own code. Done is false where it may not
   --  lock as much as it likes

   procedure Touch_Stack with Global => (In_Out => System_State), No_Inline;
   --  The calling task's stack is in memory, to the depth that the tasks
   --  without images reach

end Process.Memory;
