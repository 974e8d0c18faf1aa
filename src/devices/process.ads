--  SPDX-License-Identifier: GPL-3.0-or-later
--  The process: what the system lets it do, the signals that end it, and its
--  end. Signals are blocked, and privileges examined, before any task runs.

package Process with
  SPARK_Mode,
  Abstract_State =>
    (System_State with
       Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => System_State
is
   pragma Elaborate_Body;

   type Privilege_Kind is
     (Root_With_Real_Time,     --  FIFO priorities, ceilings checked
      User_With_Real_Time,     --  FIFO priorities, ceilings not checked
      User_Without_Real_Time,  --  time-shared, priorities without effect
      Root_Without_Real_Time); --  GNAT's tasks cannot run like this

   procedure Get_Privileges (Held : out Privilege_Kind)
   with Global => (In_Out => System_State);

   procedure Name_Task (Name : String; Real_Time : Boolean := True)
   with Global => (In_Out => System_State), Pre => Name'Length <= 15;
   --  The calling task's name, as ps -L and top -H show it, and whether
   --  Keep_On is for it; the stack of one with Real_Time is in memory from
   --  here on. First of all that a task does, and once

   procedure Keep_On (Cpu : Natural; Done : out Boolean)
   with Global => (In_Out => System_State);
   --  From here on the real-time tasks run on processor Cpu alone, and all
   --  other threads on the others, where there are any. Done is false where
   --  this process may not run on Cpu

   procedure Lock_Memory (Done : out Boolean)
   with Global => (In_Out => System_State);
   --  From here on, what this process has once used stays in memory, and so
   --  does all of the program's own code. Done is false where it may not
   --  lock as much as it likes (CAP_IPC_LOCK, RLIMIT_MEMLOCK)

   type Signal_Kind is
     (Stop_Request,     --  SIGINT, SIGTERM, SIGHUP
      Failure);         --  Report_Failure

   procedure Wait_Signal (Kind : out Signal_Kind)
   with Global => (In_Out => System_State);
   --  Waits for one. For one task only

   procedure Report_Failure with Global => (In_Out => System_State);
   --  Makes Wait_Signal return Failure; never waits

   type Exit_Status is range 0 .. 255;

   Success          : constant Exit_Status := 0;
   Cannot_Start     : constant Exit_Status := 1;
   Bad_Usage        : constant Exit_Status := 2;
   Internal_Failure : constant Exit_Status := 3;

   procedure Leave (Status : Exit_Status)
   with Global => (In_Out => System_State), No_Return;
   --  Ends the process at once, with all its tasks

end Process;
