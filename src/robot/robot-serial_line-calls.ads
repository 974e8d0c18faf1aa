--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls of the serial device: each returns what the system says, and
--  decides nothing.

with Process;

private package Robot.Serial_Line.Calls with SPARK_Mode is

   subtype Outcome is Process.Outcome;

   Interrupted   : constant Outcome := -4;   --  EINTR
   No_Data       : constant Outcome := -11;  --  EAGAIN
   Not_Permitted : constant Outcome := -13;  --  EACCES
   Busy          : constant Outcome := -16;  --  EBUSY
   No_Terminal   : constant Outcome := -25;  --  ENOTTY

   No_Descriptor : constant Outcome := -1;
   --  Calls with it fail

   procedure Open (Path : String; Result : out Outcome)
   with Global => (In_Out => Process.System_State);
   --  Does not wait for a carrier; 9600 baud, 8N1, raw, no echo; neither Read
   --  nor Write waits. With an advisory lock, which binds programs of root,
   --  too, and then the kernel's (TIOCEXCL), which keeps the programs of
   --  others out. Result: the descriptor; No_Data if another program has the
   --  lock, No_Terminal if this is not a serial line

   procedure Close (Descriptor : Outcome)
   with Global => (In_Out => Process.System_State);
   --  Waits up to 30 s for what has not left. Takes the kernel's lock back,
   --  which a pseudo-terminal would keep; the other ends with it

   type Queue is (Received, Written);

   procedure Discard (Descriptor : Outcome; What : Queue)
   with Global => (In_Out => Process.System_State);
   --  What has been received and not read, or written and has not left

   procedure Get_Unsent (Descriptor : Outcome; Result : out Outcome)
   with Global => (In_Out => Process.System_State);
   --  Result: how many bytes have been written and have not left

   procedure Write
     (Descriptor : Outcome;
      Data       : Bytes.Byte_Array;
      Length     : Natural;
      Result     : out Outcome)
   with
     Global => (In_Out => Process.System_State),
     Pre    => Length <= Data'Length;
   --  The first Length bytes of Data. Result: how many have been accepted

   procedure Read
     (Descriptor : Outcome;
      Limit      : Ada.Real_Time.Time_Span;
      Data       : in out Bytes.Byte_Array;
      Result     : out Outcome)
   with
     Global => (In_Out => Process.System_State),
     Post   => Result <= Data'Length;
   --  Into the first bytes of Data. Waits for something to read, for Limit or
   --  for a part of that; not at all if it is 0. Result: how many have been
   --  read, 0 at the end of the file

end Robot.Serial_Line.Calls;
