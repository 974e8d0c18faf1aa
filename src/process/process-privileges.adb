--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;              use Interfaces;
with Interfaces.C;            use Interfaces.C;
with Linux;
with System.Storage_Elements; use System.Storage_Elements;

package body Process.Privileges with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   type Capability is range 0 .. 31;

   Ipc_Lock : constant Capability := 14;  --  CAP_IPC_LOCK
   Sys_Nice : constant Capability := 23;  --  CAP_SYS_NICE

   type Word_Array is array (Positive range <>) of Unsigned_32
     with Convention => C;

   procedure Get_Capabilities (Header, Data : System.Address)
   with Import, Convention => C, External_Name => "capget";

   Locked_Memory : constant int := 8;  --  RLIMIT_MEMLOCK
   Priorities    : constant int := 14;  --  RLIMIT_RTPRIO

   type Limit_Pair is array (1 .. 2) of unsigned_long with Convention => C;

   procedure Get_Limit (Resource : int; Limit : System.Address)
   with Import, Convention => C, External_Name => "getrlimit";

   procedure Set_Limit (Resource : int; Limit : System.Address)
   with Import, Convention => C, External_Name => "setrlimit";

   function Get_Policy (Thread : int) return int
   with Import, Convention => C, External_Name => "sched_getscheduler";

   procedure Get_Priority (Thread : int; Priority : System.Address)
   with Import, Convention => C, External_Name => "sched_getparam";

   Found : Scheduling := Not_Permitted;

   function Effective_User return unsigned
   with Export, Convention => C, External_Name => "__wrap_geteuid";
   --  Called by the run time in place of the C library's, before anything is
   --  elaborated here (Destijl_Switches.Privilege_Switches). 0, as for root,
   --  if this thread can have the highest priority of Linux, which all locks
   --  of the run time need. If it cannot have the highest of the tasks, none
   --  of them gets one

   function Has (Which : Capability) return Boolean is
      --  In effect, if only for a namespace of users
      Header : Word_Array := (16#2008_0522#, 0);
      --  version 3, this process. The kernel may write there, and qemu
      --  refuses what is not writable
      Data   : Word_Array (1 .. 6) := (others => 0);
      --  effective, permitted, inheritable: the first 32, then the others
   begin
      Get_Capabilities (Header'Address, Data'Address);
      return (Data (1) and Shift_Left (1, Natural (Which))) /= 0;
   end Has;

   function Effective_User return unsigned is
      Policy  : constant int := Get_Policy (0);
      Before  : int;
      Limit   : Limit_Pair := (others => 0);  --  soft, hard

      function Is_Granted (Priority : int) return Boolean is
        (Linux.Set_Scheduler
           (0, Linux.First_In_First_Out, Priority'Address) = 0
         and then Linux.Set_Scheduler (0, Policy, Before'Address) = 0);

   begin
      Get_Priority (0, Before'Address);
      if Is_Granted (int (System.Any_Priority'Last) + 1) then
         Found := Fifo_With_Ceilings;
      elsif Is_Granted (Needed_Limit) then
         Found := Fifo_Without_Ceilings;
      else
         Get_Limit (Priorities, Limit'Address);
         Found :=
           (if Has (Sys_Nice) or else Limit (1) >= Needed_Limit
            then Refused else Not_Permitted);
         Limit (1) := 0;
         Set_Limit (Priorities, Limit'Address);
         --  also one that it was started with
         Give_Up_Priority;
      end if;
      return (if Found = Fifo_With_Ceilings then 0 else 1);
   end Effective_User;

   function Create
     (Thread, Attributes, Main, Argument : System.Address) return int
   with Import, Convention => C, External_Name => "__real_pthread_create";

   function Create_Or_Leave
     (Thread, Attributes, Main, Argument : System.Address) return int
   with Export, Convention => C, External_Name => "__wrap_pthread_create";
   --  Called by the run time for each task. If there can be no more threads,
   --  the run time would wait for ever

   function Create_Or_Leave
     (Thread, Attributes, Main, Argument : System.Address) return int
   is
      Message : constant String :=
        "destijl: the system gives it fewer threads than it has tasks (the "
        & "limit of its user, ulimit -u, or of its container)" & ASCII.LF;
      Ignored : Linux.Ssize;
   begin
      if Create (Thread, Attributes, Main, Argument) /= 0 then
         Ignored := Linux.Write (2, Message'Address, Message'Length);
         Leave (Cannot_Start);
      end if;
      return 0;
   end Create_Or_Leave;

   procedure Get (Granted : out Scheduling) is
   begin
      Granted := Found;
   end Get;

   procedure Get_May_Lock (May_Lock : out Boolean) is
      Limit : Limit_Pair := (others => 0);
   begin
      Get_Limit (Locked_Memory, Limit'Address);
      May_Lock := Has (Ipc_Lock) or else Limit (1) = unsigned_long'Last;
   end Get_May_Lock;

   Current_On_Fault : constant int := 1 + 2 + 4;
   --  MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT

   function Lock_All (Flags : int) return int
   with Import, Convention => C, External_Name => "mlockall";

   procedure Lock_Part (Start : System.Address; Length : size_t)
   with Import, Convention => C, External_Name => "mlock";

   --  Of the program itself, from the linker
   Code_Start : char
   with Import, Convention => C, External_Name => "__executable_start";
   Code_End : char
   with Import, Convention => C, External_Name => "etext";

   procedure Lock_Memory (Done : out Boolean) is
   begin
      --  Under a limit a later allocation could fail. Only what is used is
      --  kept: all of what OpenCV brings along would be a gigabyte
      Get_May_Lock (Done);
      Done := Done and then Lock_All (Current_On_Fault) = 0;
      if Done then
         --  the code that has not been needed so far, such as that of a
         --  stop, is not to be read from a slow disk when it is
         Lock_Part
           (Code_Start'Address,
            size_t (Code_End'Address - Code_Start'Address));
      end if;
   end Lock_Memory;

end Process.Privileges;
