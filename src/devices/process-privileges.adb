--  SPDX-License-Identifier: GPL-3.0-or-later

with Console;
with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with System;

package body Process.Privileges with SPARK_Mode => Off is

   Ipc_Lock : constant := 14;  --  CAP_IPC_LOCK
   Sys_Nice : constant := 23;  --  CAP_SYS_NICE

   function Effective_User return unsigned
   with Import, Convention => C, External_Name => "geteuid";

   type Word_Array is array (Positive range <>) of Unsigned_32
     with Convention => C;

   procedure Get_Capabilities (Header, Data : System.Address)
   with Import, Convention => C, External_Name => "capget";

   Locked_Memory : constant int := 8;  --  RLIMIT_MEMLOCK

   type Limit_Pair is array (1 .. 2) of unsigned_long with Convention => C;

   procedure Get_Limit (Resource : int; Limit : System.Address)
   with Import, Convention => C, External_Name => "getrlimit";

   function Get_Policy (Thread : int) return int
   with Import, Convention => C, External_Name => "sched_getscheduler";
   First_In_First_Out : constant int := 1;  --  SCHED_FIFO

   function Seen_By_Run_Time return int
   with Import, Convention => C, External_Name => "__gnat_has_cap_sys_nice";

   function Has (Capability : Natural) return Boolean;

   procedure Get (Held : out Kind) is
   begin
      Held := Kind_Of
        (Is_Root  => Effective_User = 0,
         Is_Seen  => Seen_By_Run_Time /= 0,
         Is_Fifo  => Get_Policy (0) = First_In_First_Out,
         Has_Nice => Has (Sys_Nice));
   end Get;

   procedure Get_May_Lock (May_Lock : out Boolean) is
      Limit : Limit_Pair := (others => 0);  --  soft, hard
   begin
      Get_Limit (Locked_Memory, Limit'Address);
      May_Lock := Has (Ipc_Lock) or else Limit (1) = unsigned_long'Last;
   end Get_May_Lock;

   function Has (Capability : Natural) return Boolean is
      Header : Word_Array := (16#2008_0522#, 0);
      --  version 3, this process. The kernel may write there, and qemu
      --  refuses what is not writable
      Data   : Word_Array (1 .. 6) := (others => 0);
      --  effective, permitted, inheritable: the first 32, then the others
   begin
      Get_Capabilities (Header'Address, Data'Address);
      return (Data (1) and Shift_Left (1, Capability)) /= 0;
   end Has;

   At_Start : Kind;

begin
   Get (At_Start);
   if At_Start = Cannot_Run then
      --  Every protected action would raise Program_Error: no task may run,
      --  so this is the last moment
      Console.Put_Log
        ("destijl: cannot run as root without CAP_SYS_NICE, or with that of "
         & "a user namespace (as in a container by default): run as an "
         & "ordinary user, or grant the capability (docker run --cap-add "
         & "SYS_NICE)");
      Leave (Cannot_Start);
   end if;
end Process.Privileges;
