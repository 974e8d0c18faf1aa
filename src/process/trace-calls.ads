--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the recorder calls of the system. Decides nothing.

with Interfaces; use Interfaces;

private package Trace.Calls with
  SPARK_Mode,
  Abstract_State =>
    (System_State with
       Synchronous,
       External => (Async_Readers, Async_Writers),
       Part_Of  => Trace.Recorder),
  Initializes => System_State
is

   pragma Annotate (GNATprove, Terminating, Trace.Calls);
   --  By review: the calls may wait for the disk

   subtype Error_Number is Natural range 0 .. 4_095;
   --  errno; 0: no error

   subtype Outcome is Integer range -Error_Number'Last .. Integer'Last;
   --  Not negative: what the call returned. Negative: it failed, errno is
   --  -Outcome

   subtype Descriptor is Integer range -1 .. Integer'Last;

   None : constant Descriptor := -1;

   Not_Found  : constant Error_Number := 2;  --  ENOENT
   Io_Failure : constant Error_Number := 5;  --  EIO

   procedure Get_Time (Nanoseconds : out Unsigned_64)
   with Global => (In_Out => System_State);
   --  CLOCK_MONOTONIC, which is Ada's clock, too

   procedure Ignore_Size_Signal with Global => (In_Out => System_State);
   --  A file beyond the limit of its size is an error of the call, and does
   --  not end the process (SIGXFSZ)

   procedure Give_Up_Priority with Global => (In_Out => System_State);
   --  The calling task has the priority of ordinary programs from here on

   type Open_Flags is range 0 .. 2 ** 31 - 1;

   Existing : constant Open_Flags := 8#2004402#;
   --  O_RDWR, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
   New_Only : constant Open_Flags := Existing + 8#300#;  --  O_CREAT, O_EXCL
   New_Also : constant Open_Flags := Existing + 8#100#;  --  O_CREAT

   procedure Open
     (Path : Texts.Text; Flags : Open_Flags; Result : out Outcome)
   with Global => (In_Out => System_State);
   --  To read and write; a new one for its owner alone. Does not wait for the
   --  other end of a pipe, and follows no symbolic link at the end of Path.
   --  Result: its descriptor

   procedure Seek_Start (File : Descriptor; Result : out Outcome)
   with Global => (In_Out => System_State);
   --  An error if File has no places, such as a pipe or a terminal

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
   --  number of bytes

end Trace.Calls;
