--  SPDX-License-Identifier: GPL-3.0-or-later
--  The process: what the system lets it do, the signals that end it, and its
--  end. Signals are blocked, and privileges examined, before any task runs.

with Console;
with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;
with System;
with System.Storage_Elements;

package body Process with
  SPARK_Mode    => Off,
  Refined_State =>
    (System_State =>
       (Signals, Privileges, May_Lock, Threads, Thread_Count, Real_Time_Set,
        Other_Set, Kept))
is

   type Signal_Set is array (1 .. 16) of Unsigned_64 with Convention => C;
   --  1024 bits, as glibc's

   Hang_Up     : constant int := 1;
   Interrupt   : constant int := 2;
   User_1      : constant int := 10;
   Broken_Pipe : constant int := 13;
   Terminate_S : constant int := 15;

   Signals    : Signal_Set := (others => 0);
   Privileges : Privilege_Kind := User_Without_Real_Time;
   May_Lock   : Boolean := False;
   --  as much memory as it likes

   type Processor_Set is array (0 .. 1_023) of Boolean
     with Pack, Convention => C;
   --  1024 bits, as glibc's

   type Thread_Number is range -2 ** 31 .. 2 ** 31 - 1 with Atomic;

   Max_Threads : constant := 64;

   Threads : array (1 .. Max_Threads) of Thread_Number :=
     (others => 0);
   --  The system's numbers of the threads that have a name, negative for
   --  those without a deadline; 0: none
   Thread_Count  : Unsigned_32 := 0;
   Real_Time_Set : Processor_Set := (others => False);
   Other_Set     : Processor_Set := (others => False);
   Kept          : Boolean := False with Atomic;
   --  the two sets hold

   function Add_Signal (Set : System.Address; Signal : int) return int
   with Import, Convention => C, External_Name => "sigaddset";

   function Set_Mask
     (How : int; Set : System.Address; Old : System.Address) return int
   with Import, Convention => C, External_Name => "pthread_sigmask";

   function Wait (Set : System.Address; Signal : System.Address) return int
   with Import, Convention => C, External_Name => "sigwait";

   function Own_Number return int
   with Import, Convention => C, External_Name => "getpid";

   function Kill (Process : int; Signal : int) return int
   with Import, Convention => C, External_Name => "kill";

   function Effective_User return unsigned
   with Import, Convention => C, External_Name => "geteuid";

   function Open (Path : System.Address; Flags : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   procedure Exit_At_Once (Status : int)
   with Import, Convention => C, External_Name => "_exit", No_Return;

   type Capability_Header is record
      Version : Unsigned_32 := 16#2008_0522#;
      Process : int         := 0;
   end record with Convention => C;

   type Capability_Data is record
      Effective, Permitted, Inheritable    : Unsigned_32 := 0;
      Effective_2, Permitted_2, Inherit_2  : Unsigned_32 := 0;
   end record with Convention => C;

   function Get_Capabilities
     (Header : System.Address; Data : System.Address) return int
   with Import, Convention => C, External_Name => "capget";

   function Process_Control
     (Option : int; Value : System.Address) return int
   with Import, Convention => C_Variadic_1, External_Name => "prctl";

   type Resource_Limit is record
      Soft, Hard : unsigned_long := 0;
   end record with Convention => C;

   Locked_Memory : constant int           := 8;  --  RLIMIT_MEMLOCK
   Unlimited     : constant unsigned_long := unsigned_long'Last;

   function Get_Limit (Resource : int; Limit : System.Address) return int
   with Import, Convention => C, External_Name => "getrlimit";

   Current_On_Fault : constant int := 1 + 2 + 4;
   --  MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT

   function Lock_All (Flags : int) return int
   with Import, Convention => C, External_Name => "mlockall";

   function Lock (Start : System.Address; Length : size_t) return int
   with Import, Convention => C, External_Name => "mlock";

   --  Of the program itself, from the linker
   Code_Start : char
   with Import, Convention => C, External_Name => "__executable_start";
   Code_End : char
   with Import, Convention => C, External_Name => "etext";

   function Own_Thread return int
   with Import, Convention => C, External_Name => "gettid";

   function Get_Affinity
     (Thread : int; Size : size_t; Set : System.Address) return int
   with Import, Convention => C, External_Name => "sched_getaffinity";

   function Set_Affinity
     (Thread : int; Size : size_t; Set : System.Address) return int
   with Import, Convention => C, External_Name => "sched_setaffinity";

   function Fetch_And_Add
     (Counter : System.Address; Amount : Unsigned_32; Order : int)
      return Unsigned_32
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__atomic_fetch_add_4";
   Sequential : constant int := 5;  --  __ATOMIC_SEQ_CST

   Set_Size : constant size_t := Processor_Set'Size / 8;

   procedure Keep (Thread : Thread_Number);
   --  On its set; Thread as in Threads

   procedure Touch_Stack with No_Inline;
   --  The calling task's stack is in memory, to the depth that the tasks
   --  without images reach

   procedure Open_Standard_Streams;
   --  Where they are closed, nothing else may get their descriptors: the log
   --  would be written to the monitor or to the robot

   procedure Block_Signals;
   procedure Examine_Privileges;

   ---------------------------
   -- Open_Standard_Streams --
   ---------------------------

   procedure Open_Standard_Streams is
      Nowhere    : constant String := "/dev/null" & ASCII.NUL;
      Read_Write : constant := 2;  --  O_RDWR
      Found      : int;
   begin
      loop
         Found := Open (Nowhere'Address, Read_Write);
         exit when Found not in 0 .. 2;
      end loop;
      if Found > 2 then
         Linux.Close (Found);
      end if;
   end Open_Standard_Streams;

   -------------------
   -- Block_Signals --
   -------------------

   procedure Block_Signals is
      Ignored : int;
   begin
      Ignored := Add_Signal (Signals'Address, Hang_Up);
      Ignored := Add_Signal (Signals'Address, Interrupt);
      Ignored := Add_Signal (Signals'Address, Terminate_S);
      Ignored := Add_Signal (Signals'Address, User_1);
      Ignored := Add_Signal (Signals'Address, Broken_Pipe);
      Ignored := Set_Mask (0, Signals'Address, System.Null_Address);
   end Block_Signals;

   ------------------------
   -- Examine_Privileges --
   ------------------------

   procedure Examine_Privileges is
      Header   : Capability_Header;
      Data     : Capability_Data;
      Ignored  : constant int :=
        Get_Capabilities (Header'Address, Data'Address);
      pragma Unreferenced (Ignored);
      Sys_Nice : constant Boolean :=
        (Data.Effective and Shift_Left (1, 23)) /= 0;
      Ipc_Lock : constant Boolean :=
        (Data.Effective and Shift_Left (1, 14)) /= 0;
      Limit    : Resource_Limit;
   begin
      May_Lock := Ipc_Lock
        or else (Get_Limit (Locked_Memory, Limit'Address) = 0
                 and then Limit.Soft = Unlimited);
      Privileges :=
        (if Effective_User = 0 then
           (if Sys_Nice then Root_With_Real_Time
            else Root_Without_Real_Time)
         elsif Sys_Nice then User_With_Real_Time
         else User_Without_Real_Time);
      if Privileges = Root_Without_Real_Time then
         --  Every protected action would raise Program_Error: no task may
         --  run, so this is the last moment
         Console.Put_Log
           ("destijl: cannot run as root without CAP_SYS_NICE (as in a "
            & "container by default): run as an ordinary user, or grant the "
            & "capability (docker run --cap-add SYS_NICE)");
         Exit_At_Once (int (Cannot_Start));
      end if;
   end Examine_Privileges;

   --------------------
   -- Get_Privileges --
   --------------------

   procedure Get_Privileges (Held : out Privilege_Kind) is
   begin
      Held := Privileges;
   end Get_Privileges;

   -----------------
   -- Lock_Memory --
   -----------------

   procedure Lock_Memory (Done : out Boolean) is
      use System.Storage_Elements;
      Ignored : int;
      pragma Unreferenced (Ignored);
   begin
      --  Under a limit a later allocation could fail. Only what is used is
      --  kept: all of what OpenCV brings along would be a gigabyte
      Done := May_Lock and then Lock_All (Current_On_Fault) = 0;
      if Done then
         --  the code that has not been needed so far, such as that of a
         --  stop, is not to be read from a slow disk when it is
         Ignored := Lock
           (Code_Start'Address,
            size_t (Code_End'Address - Code_Start'Address));
      end if;
   end Lock_Memory;

   ----------
   -- Keep --
   ----------

   procedure Keep (Thread : Thread_Number) is
      Set     : constant System.Address :=
        (if Thread > 0 then Real_Time_Set'Address else Other_Set'Address);
      Ignored : constant int := Set_Affinity (int (abs Thread), Set_Size, Set);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Keep;

   -------------
   -- Keep_On --
   -------------

   procedure Keep_On (Cpu : Natural; Done : out Boolean) is
      Allowed : Processor_Set := (others => False);
   begin
      Done := Get_Affinity (Own_Number, Set_Size, Allowed'Address) >= 0
        and then Cpu in Allowed'Range
        and then Allowed (Cpu);
      if Done then
         Other_Set := Allowed;
         Other_Set (Cpu) := False;
         if Other_Set = (Processor_Set'Range => False) then
            Other_Set := Allowed;
         end if;
         Real_Time_Set (Cpu) := True;
         --  before the threads are looked at: one that gets its name now
         --  keeps itself
         Kept := True;
         Keep (-Thread_Number (Own_Number));
         for Thread of Threads loop
            if Thread /= 0 then
               Keep (Thread);
            end if;
         end loop;
      end if;
   end Keep_On;

   -----------------
   -- Touch_Stack --
   -----------------

   procedure Touch_Stack is
      Page  : constant := 4_096;
      Depth : constant := 16 * Page;
      Stack : array (1 .. Depth) of char with Volatile;
   begin
      for Page_Number in 0 .. Depth / Page - 1 loop
         Stack (Page_Number * Page + 1) := nul;
      end loop;
   end Touch_Stack;

   ---------------
   -- Name_Task --
   ---------------

   procedure Name_Task (Name : String; Real_Time : Boolean := True) is
      Text    : constant String := Name & ASCII.NUL;
      Set     : constant := 15;  --  PR_SET_NAME
      Ignored : constant int := Process_Control (Set, Text'Address);
      pragma Unreferenced (Ignored);
      Thread  : constant Thread_Number := Thread_Number (Own_Thread);
      Place   : constant Positive := 1 + Natural
        (Fetch_And_Add (Thread_Count'Address, 1, Sequential));
   begin
      if Real_Time then
         Touch_Stack;
      end if;
      Threads (Place) := (if Real_Time then Thread else -Thread);
      if Kept then
         Keep (Threads (Place));
      end if;
   end Name_Task;

   -----------------
   -- Wait_Signal --
   -----------------

   procedure Wait_Signal (Kind : out Signal_Kind) is
      Signal : int := 0;
   begin
      loop
         if Wait (Signals'Address, Signal'Address) = 0 then
            exit when Signal /= Broken_Pipe;
         end if;
      end loop;
      Kind := (if Signal = User_1 then Failure else Stop_Request);
   end Wait_Signal;

   --------------------
   -- Report_Failure --
   --------------------

   procedure Report_Failure is
      Ignored : constant int := Kill (Own_Number, User_1);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Report_Failure;

   -----------
   -- Leave --
   -----------

   procedure Leave (Status : Exit_Status) is
   begin
      Exit_At_Once (int (Status));
   end Leave;

begin
   Open_Standard_Streams;
   Block_Signals;
   Examine_Privileges;
end Process;
