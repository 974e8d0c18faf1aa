--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with Linux;
with System;

package body Process.Threads.Calls with SPARK_Mode => Off is
   --  Off: addresses are passed to C. Each number is written by its own task
   --  alone, the sets are written before any task reads them

   Numbers : array (Schedule.Task_Name) of Natural := (others => 0)
     with Atomic_Components;
   --  Of the threads in the system; 0: the task has not entered
   Sets    : Division;
   Kept    : Boolean := False with Atomic;
   --  Sets holds
   Size    : constant size_t := Set'Size / 8;

   Room : constant := 32_768;  --  as GNAT's tasks have without Ravenscar

   Signal_Stacks : array (Schedule.Task_Name) of char_array (1 .. Room);
   --  In memory only where one was needed

   type Stack is record
      Start  : System.Address;
      Flags  : int := 0;
      Length : size_t := Room;
   end record with Convention => C;

   procedure Process_Control (Option : int; Value : System.Address)
   with Import, Convention => C_Variadic_1, External_Name => "prctl";

   function Own_Thread return int
   with Import, Convention => C, External_Name => "gettid";

   procedure Set_Signal_Stack (Stack, Old : System.Address)
   with Import, Convention => C, External_Name => "sigaltstack";

   procedure Get_Affinity (Thread : int; Size : size_t; Set : System.Address)
   with Import, Convention => C, External_Name => "sched_getaffinity";

   procedure Set_Affinity (Thread : int; Size : size_t; Set : System.Address)
   with Import, Convention => C, External_Name => "sched_setaffinity";

   procedure Get_Allowed (Allowed : out Set) is
   begin
      Allowed := (others => False);
      Get_Affinity (Linux.Own_Process, Size, Allowed'Address);
   end Get_Allowed;

   procedure Touch_Stack with No_Inline is
      --  To the depth that the tasks without images reach
      Page  : constant := 4_096;
      Depth : constant := 16 * Page;
      Stack : array (1 .. Depth) of char with Volatile;
   begin
      for Page_Number in 0 .. Depth / Page - 1 loop
         Stack (Page_Number * Page + 1) := nul;
      end loop;
   end Touch_Stack;

   procedure Keep_Thread (Thread : Natural; Real_Time : Boolean) is
   begin
      Set_Affinity (int (Thread), Size, Sets (Real_Time)'Address);
   end Keep_Thread;

   procedure Enter (Who : Schedule.Task_Name) is
      Name : constant String := Schedule.Name_Of (Who) & ASCII.NUL;
      Own  : Stack := (Start => Signal_Stacks (Who)'Address, others => <>);
   begin
      Process_Control (15, Name'Address);  --  PR_SET_NAME
      if Who in Schedule.Real_Time_Task then
         Touch_Stack;
      end if;
      Set_Signal_Stack (Own'Address, System.Null_Address);
      Numbers (Who) := Natural (Own_Thread);
      if Kept then
         Keep_Thread (Numbers (Who), Who in Schedule.Real_Time_Task);
      end if;
   end Enter;

   procedure Keep (Sets : Division) is
   begin
      Calls.Sets := Sets;
      --  before the threads are looked at: one that enters now keeps itself
      Kept := True;
      Keep_Thread (Natural (Linux.Own_Process), False);
      for Who in Schedule.Task_Name loop
         if Numbers (Who) > 0 then
            Keep_Thread (Numbers (Who), Who in Schedule.Real_Time_Task);
         end if;
      end loop;
   end Keep;

end Process.Threads.Calls;
