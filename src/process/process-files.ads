--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls for what the process writes: standard output, standard error, the
--  file of --trace. They return what the system says.

package Process.Files with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Process.Files);
   --  By review: the calls may wait for a disk or a terminal

   pragma Elaborate_Body;
   --  Opens closed standard streams. Otherwise a socket or the serial line
   --  could get their descriptors, and receive the log

   subtype Error_Number is Natural range 0 .. 4_095;
   --  errno; 0: no error

   Not_Found   : constant Error_Number := 2;  --  ENOENT
   Interrupted : constant Error_Number := 4;  --  EINTR
   Io_Failure  : constant Error_Number := 5;  --  EIO

   subtype Outcome is Integer range -Error_Number'Last .. Integer'Last;
   --  Not negative: what the call returned. Negative: it failed, its error is
   --  -Outcome

   subtype Descriptor is Natural;

   Standard_Output : constant Descriptor := 1;
   Standard_Error  : constant Descriptor := 2;

   type Creation is (None, New_Only, New_Also);
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

end Process.Files;
