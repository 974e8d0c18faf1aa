--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the system lets the process do.

package Process.Privileges with SPARK_Mode is

   function Image (Real_Time : Boolean) return String is
     (if Real_Time then "yes (FIFO), ceilings act"
      else "none, ceilings do not act");

   procedure Get (Real_Time : out Boolean)
   with Global => (In_Out => System_State);
   --  Whether FIFO priorities and ceilings act: found out at the start

   procedure Get_May_Lock (May_Lock : out Boolean)
   with Global => (In_Out => System_State);
   --  Whether it may lock as much memory as it likes (CAP_IPC_LOCK,
   --  RLIMIT_MEMLOCK)

end Process.Privileges;
