--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the system lets the process do. Examined before any task runs.

package Process.Privileges with SPARK_Mode is

   pragma Elaborate_Body;

   type Kind is
     (Real_Time,      --  FIFO priorities, and ceilings act
      Ordinary_User,  --  time-shared mostly; ceilings do not act
      Cannot_Run);    --  every protected action would raise Program_Error

   function Image (Held : Kind) return String is
     (if Held = Real_Time then "yes (FIFO), ceilings act"
      else "none, ceilings do not act");

   procedure Get (Held : out Kind)
   with Global => (In_Out => System_State);
   --  As it is, and not only as it may be. For the environment task

   procedure Get_May_Lock (May_Lock : out Boolean)
   with Global => (In_Out => System_State);
   --  Whether it may lock as much memory as it likes (CAP_IPC_LOCK,
   --  RLIMIT_MEMLOCK)

end Process.Privileges;
