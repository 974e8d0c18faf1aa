--  SPDX-License-Identifier: GPL-3.0-or-later
--  The process: its arguments, its end, the system's words for errors, and
--  its machine. Its child packages: signals, privileges and threads.

with Texts;

package Process with
  SPARK_Mode,
  Abstract_State =>
    (System_State with
       Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => System_State
is

   --  The arguments. They never change

   function Program return Texts.Text with Global => null;
   --  As it was called: with the path, unless it was found in PATH

   function Argument_Count return Natural with Global => null;

   function Is_Whole (Index : Positive) return Boolean with Global => null;
   --  Argument Index, counted from 1, fits into a text

   function Argument (Index : Positive) return Texts.Text
   with Global => null;
   --  As much of it as fits; empty if there is none

   --  The end, errors, the machine

   type Exit_Status is range 0 .. 255;

   Success          : constant Exit_Status := 0;
   Cannot_Start     : constant Exit_Status := 1;
   Bad_Usage        : constant Exit_Status := 2;
   Internal_Failure : constant Exit_Status := 3;

   procedure Leave (Status : Exit_Status)
   with Global => (In_Out => System_State), No_Return;
   --  Ends the process at once, with all its tasks

   procedure Give_Up_Priority
   with
     Global   => (In_Out => System_State),
     Annotate => (GNATprove, Terminating);
   --  The calling task has the priority of ordinary programs from here on

   procedure Describe (Error : Integer; Text : out Texts.Text)
   with Global => null, Annotate => (GNATprove, Terminating);
   --  Errno in words, such as "No such file or directory"

   procedure Get_Kernel (Name, Version : out Texts.Text)
   with Global => (In_Out => System_State);
   --  Such as "6.1.0-18-amd64", "#1 SMP PREEMPT_DYNAMIC Debian 6.1.76-1"

   procedure Get_Memory (Megabytes : out Natural)
   with Global => (In_Out => System_State);
   --  Of the whole machine

end Process;
