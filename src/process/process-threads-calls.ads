--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls for the threads of the process, and the table of its tasks'
--  threads.

private package Process.Threads.Calls with SPARK_Mode is

   procedure Get_Allowed (Allowed : out Set)
   with Global => (In_Out => System_State);
   --  The processors that the process may run on; none if this is not known

   procedure Enter (Who : Schedule.Task_Name)
   with Global => (In_Out => System_State);
   --  The calling task is Who, see Name_Task. From here on a handler of
   --  signals has room where the task's stack has overflowed, and the task
   --  runs on the processors of Keep

   procedure Keep (Sets : Division)
   with Global => (In_Out => System_State);
   --  From here on the threads run on these processors. Once

end Process.Threads.Calls;
