--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls of the serial device: each returns what the system says, and
--  decides nothing.

private package Robot.Serial_Line.Calls with
  SPARK_Mode,
  Abstract_State =>
    (Port with
       Synchronous, External => (Async_Readers, Async_Writers),
       Part_Of => Device),
  Initializes => Port
is

   subtype Outcome is Integer range -Integer'Last .. Integer'Last;
   --  What a call returns, or, if it fails, its error (errno), negative

   Interrupted        : constant Outcome := -4;   --  EINTR
   Input_Output_Error : constant Outcome := -5;   --  EIO
   No_Such_Address    : constant Outcome := -6;   --  ENXIO
   No_Data            : constant Outcome := -11;  --  EAGAIN
   Not_Permitted      : constant Outcome := -13;  --  EACCES
   Busy               : constant Outcome := -16;  --  EBUSY
   No_Such_Device     : constant Outcome := -19;  --  ENODEV
   No_Terminal        : constant Outcome := -25;  --  ENOTTY

   No_Descriptor : constant Outcome := -1;
   --  Calls with it fail

   subtype Nanoseconds is Integer range 0 .. 999_999_999;

   procedure Open (Path : String; Result : out Outcome)
   with Global => (In_Out => Port);
   --  Does not wait for a carrier; 9600 baud, 8N1, raw, no echo; neither Read
   --  nor Write waits. With an advisory lock, which binds programs of root,
   --  too, and then the kernel's (TIOCEXCL), which keeps the programs of
   --  others out. Result: the descriptor; No_Data if another program has the
   --  lock, No_Terminal if this is not a serial line

   procedure Get_Start
     (Path : String; Data : in out String; Last : out Natural)
   with
     Global => (In_Out => Port),
     Pre    => Data'First = 1,
     Post   => Last <= Data'Last;
   --  What the file at Path begins with: Data (1 .. Last)

   type Device_Number is record
      Major : Natural range 0 .. 2 ** 12 - 1 := 0;
      Minor : Natural range 0 .. 2 ** 19 - 1 := 0;
   end record;
   --  The kernel's number for a device. A minor has one bit more, which no
   --  terminal needs

   type File_Numbers is record
      Itself : Device_Number;  --  if it is a device
      Place  : Device_Number;  --  where it is
      Inode  : Natural := 0;
   end record;

   procedure Get_Numbers (Path : String; File : out File_Numbers)
   with Global => (In_Out => Port);
   --  Of the file at Path

   procedure Get_Processes (Data : in out String; Last : out Natural)
   with
     Global => (In_Out => Port),
     Pre    => Data'First = 1,
     Post   => Last <= Data'Last;
   --  The numbers of all processes, as many as fit, each followed by a blank:
   --  Data (1 .. Last)

   procedure Close (Descriptor : Outcome) with Global => (In_Out => Port);
   --  Waits up to 30 s for what has not left. Takes the kernel's lock back,
   --  which a pseudo-terminal would keep; the other ends with it

   type Queue is (Received, Written);

   procedure Discard (Descriptor : Outcome; What : Queue)
   with Global => (In_Out => Port);
   --  What has been received and not read, or written and has not left

   procedure Get_Unsent (Descriptor : Outcome; Result : out Outcome)
   with Global => (In_Out => Port);
   --  Result: how many bytes have been written and have not left

   procedure Write
     (Descriptor : Outcome;
      Data       : Bytes.Byte_Array;
      Length     : Natural;
      Result     : out Outcome)
   with
     Global => (In_Out => Port),
     Pre    => Length <= Data'Length;
   --  The first Length bytes of Data. Result: how many have been accepted

   procedure Wait_Input
     (Descriptor : Outcome; Limit : Nanoseconds; Result : out Outcome)
   with Global => (In_Out => Port);
   --  Until there is something to read, Limit at most. Result: 0 if there is
   --  nothing

   procedure Read
     (Descriptor : Outcome;
      Data       : in out Bytes.Byte_Array;
      Result     : out Outcome)
   with
     Global => (In_Out => Port),
     Post   => Result <= Data'Length;
   --  Into the first bytes of Data. Result: their number, 0 at the end of the
   --  file

end Robot.Serial_Line.Calls;
