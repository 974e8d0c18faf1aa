--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls for the threads of the process, and the table of its tasks'
--  threads.

private package Process.Threads.Calls with
  SPARK_Mode,
  Abstract_State =>
    (Table with
       Synchronous, External => (Async_Readers, Async_Writers),
       Part_Of => Named),
  Initializes => Table
is

   procedure Get_Allowed (Allowed : out Set)
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

   procedure Enter (Who : Schedule.Task_Name)
   with Global => (In_Out => (Table, System_State));
   --  The calling task is Who. From here on a handler of signals has room
   --  where the task's stack has overflowed, and the task runs on the
   --  processors of Keep

   procedure Keep (Sets : Division)
   with Global => (In_Out => (Table, System_State));
   --  From here on the threads run on these processors. Once

end Process.Threads.Calls;
