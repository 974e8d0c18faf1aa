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

   function Kind_Of
     (Is_Root, Is_Seen, Is_Fifo, Has_Nice : Boolean) return Kind
   is (if not Is_Root and then not Is_Seen then Ordinary_User
       elsif Is_Fifo and then Has_Nice then Real_Time
       else Cannot_Run);
   --  GNAT's run time gives ceilings to the objects of root, and where it sees
   --  CAP_SYS_NICE (Is_Seen). They act if the process has that (Has_Nice), and
   --  its threads are FIFO

   procedure Get (Held : out Kind)
   with Global => (In_Out => System_State);
   --  As it is, and not only as it may be. For the environment task

   procedure Get_May_Lock (May_Lock : out Boolean)
   with Global => (In_Out => System_State);
   --  Whether it may lock as much memory as it likes (CAP_IPC_LOCK,
   --  RLIMIT_MEMLOCK)

end Process.Privileges;
