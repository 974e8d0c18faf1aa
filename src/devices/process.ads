--  SPDX-License-Identifier: GPL-3.0-or-later
--  The process and its end. Its child packages: signals, privileges, memory
--  and threads.

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

end Process;
