--  SPDX-License-Identifier: GPL-3.0-or-later
--  The process, its end and its machine. Its child packages: signals,
--  privileges and threads.

with Texts;

package Process with
  SPARK_Mode,
  Abstract_State =>
    (System_State with
       Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => System_State
is

   type Exit_Status is range 0 .. 255;

   Success          : constant Exit_Status := 0;
   Cannot_Start     : constant Exit_Status := 1;
   Bad_Usage        : constant Exit_Status := 2;
   Internal_Failure : constant Exit_Status := 3;

   procedure Leave (Status : Exit_Status)
   with Global => (In_Out => System_State), No_Return;
   --  Ends the process at once, with all its tasks

   procedure Get_Kernel (Name, Version : out Texts.Text)
   with Global => (In_Out => System_State);
   --  Such as "6.1.0-18-amd64", "#1 SMP PREEMPT_DYNAMIC Debian 6.1.76-1"

   procedure Get_Memory (Megabytes : out Natural)
   with Global => (In_Out => System_State);
   --  Of the whole machine

end Process;
