--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the system lets the process do. Examined before any task runs.

package Process.Privileges with SPARK_Mode is

   pragma Elaborate_Body;

   type Kind is
     (Root_With_Real_Time,     --  FIFO priorities, ceilings checked
      User_With_Real_Time,     --  FIFO priorities, ceilings not checked
      User_Without_Real_Time,  --  time-shared, priorities without effect
      Root_Without_Real_Time); --  GNAT's tasks cannot run like this

   procedure Get (Held : out Kind)
   with Global => (In_Out => System_State);

   procedure Get_May_Lock (May_Lock : out Boolean)
   with Global => (In_Out => System_State);
   --  Whether it may lock as much memory as it likes (CAP_IPC_LOCK,
   --  RLIMIT_MEMLOCK)

end Process.Privileges;
