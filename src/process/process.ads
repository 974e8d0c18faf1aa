--  SPDX-License-Identifier: GPL-3.0-or-later
--  The process: its arguments, its end, the system's words for errors, its
--  machine, and what it writes: standard output, standard error, the file of
--  --trace. Its child packages: signals, privileges and threads.

with Texts;

package Process with
  SPARK_Mode,
  Abstract_State =>
    (System_State with
       Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => System_State
is

   pragma Annotate (GNATprove, Terminating, Process);
   --  By review: the calls may wait for a disk or a terminal

   pragma Elaborate_Body;
   --  Opens closed standard streams. Otherwise a socket or the serial line
   --  could get their descriptors, and receive the log

   --  The arguments. They never change

   function Program return Texts.Text with Global => null;
   --  As it was called: with the path, unless it was found in PATH

   function Argument_Count return Natural with Global => null;

   function Argument (Index : Positive) return String
   with Global => null, Post => Argument'Result'First = 1;
   --  Counted from 1; empty if there is none

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
   with Global => (In_Out => System_State);
   --  The calling task has the priority of ordinary programs from here on

   subtype Error_Number is Natural range 0 .. 4_095;
   --  errno; 0: no error

   Not_Found  : constant Error_Number := 2;  --  ENOENT
   Io_Failure : constant Error_Number := 5;  --  EIO

   procedure Describe (Error : Integer; Text : out Texts.Text)
   with Global => null;
   --  Error, an Error_Number, in words, such as "No such file or directory"

   procedure Get_Kernel (Name, Version : out Texts.Text)
   with Global => (In_Out => System_State);
   --  Such as "6.1.0-18-amd64", "#1 SMP PREEMPT_DYNAMIC Debian 6.1.76-1"

   procedure Get_Memory (Megabytes : out Natural)
   with Global => (In_Out => System_State);
   --  Of the whole machine

   --  Files

   subtype Outcome is Integer range -Error_Number'Last .. Integer'Last;
   --  Not negative: what the call returned. Negative: it failed, its error is
   --  -Outcome

   subtype Descriptor is Natural;

   Standard_Output : constant Descriptor := 1;
   Standard_Error  : constant Descriptor := 2;

   type Creation is (Never, New_Only, New_Also);
   --  Whether the file is created: never; it must be new; if it is not there

   procedure Open
     (Path : Texts.Text; Created : Creation; Result : out Outcome)
   with Global => (In_Out => System_State);
   --  To read and write; a new one for its owner alone. Does not wait for the
   --  other end of a pipe, and follows no symbolic link at the end of Path. An
   --  error if it has no places, such as a pipe or a terminal. Result: its
   --  descriptor

   procedure Close (File : Descriptor)
   with Global => (In_Out => System_State);

   procedure Remove (Path : Texts.Text)
   with Global => (In_Out => System_State);

   procedure Empty (File : Descriptor)
   with Global => (In_Out => System_State);
   --  Drops its contents

   procedure Write (File : Descriptor; Data : String; Result : out Outcome)
   with
     Global => (In_Out => System_State),
     Post   => Result <= Data'Length;
   --  Writes the beginning of Data at the file's current position. Result:
   --  number of characters

end Process;
