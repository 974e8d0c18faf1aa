--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;
with Process.Memory;
with System;

package body Process.Threads with
  SPARK_Mode    => Off,
  Refined_State => (Named => (Numbers, Count, Sets, Kept))
is

   type Processor_Set is array (Options.Processor) of Boolean
     with Pack, Convention => C;
   --  1024 bits, as glibc's

   type Thread_Number is range -2 ** 31 .. 2 ** 31 - 1 with Atomic;

   Max_Threads : constant := 64;

   Numbers : array (1 .. Max_Threads) of Thread_Number := (others => 0);
   --  The system's numbers of the threads that have a name, negative for
   --  those without a deadline; 0: none
   Count   : Unsigned_32 := 0;
   Sets    : array (Boolean) of Processor_Set :=
     (others => (others => False));
   --  of the real-time tasks (True), and of all other threads
   Kept    : Boolean := False with Atomic;
   --  the two sets hold

   procedure Process_Control (Option : int; Value : System.Address)
   with Import, Convention => C_Variadic_1, External_Name => "prctl";

   function Own_Thread return int
   with Import, Convention => C, External_Name => "gettid";

   function Get_Affinity
     (Thread : int; Size : size_t; Set : System.Address) return int
   with Import, Convention => C, External_Name => "sched_getaffinity";

   procedure Set_Affinity (Thread : int; Size : size_t; Set : System.Address)
   with Import, Convention => C, External_Name => "sched_setaffinity";

   function Fetch_And_Add
     (Counter : System.Address; Amount : Unsigned_32; Order : int)
      return Unsigned_32
   with Import, Convention => Intrinsic,
     External_Name => "__atomic_fetch_add_4";
   Sequential : constant int := 5;  --  __ATOMIC_SEQ_CST

   Set_Size : constant size_t := Processor_Set'Size / 8;

   procedure Keep (Thread : Thread_Number);
   --  On its set; Thread as in Numbers

   procedure Keep (Thread : Thread_Number) is
   begin
      Set_Affinity (int (abs Thread), Set_Size, Sets (Thread > 0)'Address);
   end Keep;

   procedure Keep_On
     (Cpu : in out Options.Processor_Choice; Alone, Done : out Boolean)
   is
      Main    : constant int := Linux.Own_Process;
      Allowed : Processor_Set := (others => False);
      Last    : Options.Processor := 0;
      Count   : Natural := 0;
   begin
      if Get_Affinity (Main, Set_Size, Allowed'Address) >= 0 then
         for I in Allowed'Range loop
            if Allowed (I) then
               Last := I;
               Count := Count + 1;
            end if;
         end loop;
      end if;
      Alone := Count = 1;
      if Cpu = Options.Last_Processor then
         Cpu := Last;
      end if;
      Done := Cpu = Options.No_Processor or else Allowed (Cpu);
      if Done and then Cpu /= Options.No_Processor then
         Sets (True) (Cpu) := True;
         Sets (False) := Allowed and not Sets (True);
         if Sets (False) = (Processor_Set'Range => False) then
            Sets (False) := Allowed;
         end if;
         --  before the threads are looked at: one that gets its name now
         --  keeps itself
         Kept := True;
         Keep (-Thread_Number (Main));
         for Thread of Numbers loop
            if Thread /= 0 then
               Keep (Thread);
            end if;
         end loop;
      end if;
   end Keep_On;

   procedure Name_Task (Who : Schedule.Task_Name) is
      Item     : Schedule.Row renames Schedule.Table (Who);
      Text     : constant String := Schedule.Name_Of (Who) & ASCII.NUL;
      --  the kernel takes what it has room for
      Set_Name : constant := 15;  --  PR_SET_NAME
      Thread   : constant Thread_Number := Thread_Number (Own_Thread);
      Place    : constant Positive := 1 + Natural
        (Fetch_And_Add (Count'Address, 1, Sequential));
   begin
      Process_Control (Set_Name, Text'Address);
      if Item.Real_Time then
         Memory.Touch_Stack;
      end if;
      Numbers (Place) := (if Item.Real_Time then Thread else -Thread);
      if Kept then
         Keep (Numbers (Place));
      end if;
   end Name_Task;

end Process.Threads;
