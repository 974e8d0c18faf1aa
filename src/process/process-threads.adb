--  SPDX-License-Identifier: GPL-3.0-or-later

with Process.Threads.Calls;
with Processor_Sets;

package body Process.Threads with
  SPARK_Mode,
  Refined_State => (Named => (Calls.Table, Kept))
is

   Kept : Boolean := False with Atomic, Async_Readers, Async_Writers;
   --  The sets of Calls hold

   procedure Keep_On
     (Cpu : in out Options.Processor_Choice; Alone, Done : out Boolean)
   is
      Allowed : Processor_Sets.Set;
      Sets    : Processor_Sets.Division;
      Thread  : Natural;
   begin
      Calls.Get_Allowed (Allowed);
      Alone := Processor_Sets.Is_Alone (Allowed);
      Cpu := Processor_Sets.Chosen (Allowed, Cpu);
      Done := Processor_Sets.May_Have (Allowed, Cpu);
      if Done and then Cpu in Options.Processor then
         Processor_Sets.Divide (Allowed, Cpu, Sets);
         Calls.Put_Sets (Sets);
         --  before the threads are looked at: one that gets its name now
         --  keeps itself
         Kept := True;
         Calls.Get_Main (Thread);
         if Thread /= Calls.No_Thread then
            Calls.Keep (Thread, False);
         end if;
         for Who in Schedule.Task_Name loop
            Calls.Get_Thread (Who, Thread);
            if Thread /= Calls.No_Thread then
               Calls.Keep (Thread, Schedule.Table (Who).Real_Time);
            end if;
         end loop;
      end if;
   end Keep_On;

   procedure Name_Task (Who : Schedule.Task_Name) is
      Real_Time : constant Boolean := Schedule.Table (Who).Real_Time;
      Thread    : Natural;
      Keeps     : Boolean;
   begin
      Calls.Set_Name (Schedule.Name_Of (Who) & ASCII.NUL);
      if Real_Time then
         Calls.Touch_Stack;
      end if;
      Calls.Enter (Who, Thread);
      Keeps := Kept;
      if Keeps and then Thread /= Calls.No_Thread then
         Calls.Keep (Thread, Real_Time);
      end if;
   end Name_Task;

end Process.Threads;
