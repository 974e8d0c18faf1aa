--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls for the threads of the process, and the table of its tasks'
--  threads.

with Processor_Sets;

private package Process.Threads.Calls with
  SPARK_Mode,
  Abstract_State =>
    (Table with
       Synchronous, External => (Async_Readers, Async_Writers),
       Part_Of => Named),
  Initializes => Table
is

   No_Thread : constant := 0;

   procedure Get_Allowed (Allowed : out Processor_Sets.Set)
   with Global => (In_Out => System_State);
   --  The processors that the process may run on; none if this is not known

   procedure Set_Name (Name : String)
   with
     Global => (In_Out => System_State),
     Pre    => Name'Length > 0 and then Name (Name'Last) = ASCII.NUL;
   --  Of the calling task. The kernel takes what it has room for

   procedure Touch_Stack with Global => (In_Out => System_State), No_Inline;
   --  The calling task's stack is in memory, to the depth that the tasks
   --  without images reach

   procedure Enter (Who : Schedule.Task_Name; Thread : out Natural)
   with Global => (In_Out => Table);
   --  The calling task is Who. Thread: its number in the system. From here on
   --  a handler of signals has room where the task's stack has overflowed

   procedure Get_Thread (Who : Schedule.Task_Name; Thread : out Natural)
   with Global => (In_Out => Table);
   --  No_Thread: it has not entered

   procedure Get_Main (Thread : out Natural)
   with Global => (In_Out => System_State);
   --  The main procedure's

   procedure Put_Sets (Sets : Processor_Sets.Division)
   with Global => (In_Out => Table);
   --  For Keep. Once

   procedure Keep (Thread : Natural; Real_Time : Boolean)
   with Global => (In_Out => (Table, System_State)),
        Pre    => Thread /= No_Thread;
   --  From here on the thread runs on the processors of its kind. After
   --  Put_Sets

end Process.Threads.Calls;
