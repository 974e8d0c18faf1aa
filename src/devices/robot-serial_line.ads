--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line to the robot: 9600 baud, 8 data bits, no parity, 1 stop
--  bit, raw, no echo. For the one task that owns the line.

with Ada.Real_Time;
with Bytes;
with Interfaces;
with Robot.Protocol;
with Texts;

package Robot.Serial_Line with
  SPARK_Mode,
  Abstract_State =>
    (Device with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => (Device, Written)
is

   use type Interfaces.Unsigned_64;
   use type Robot.Protocol.Reading;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with
     Global =>
       (In_Out => Device, Input => Ada.Real_Time.Clock_Time);
   --  Opens and configures the device, for this process alone, and discards
   --  its input so far. Reason explains a failure

   procedure Close (All_Sent : out Boolean)
   with
     Global =>
       (In_Out => Device, Input => Ada.Real_Time.Clock_Time);
   --  Waits for what has been written to leave, Schedule.Unsent_Limit at most;
   --  the rest is discarded, since the device may never take it (not
   --  All_Sent). No effect if it is not open

   procedure Discard_Input with Global => (In_Out => Device);
   --  Discards what has been received and not read

   type Line_Record is record
      Count : Interfaces.Unsigned_64 := 0;
      --  number of frames, including failed ones
      Last  : Robot.Protocol.Reading;
      --  the last frame, as the robot decodes it
   end record;

   Written : Line_Record with Ghost;
   --  What the line's owner has written to the line

   procedure Write (Item : Robot.Protocol.Frame; Success : out Boolean)
   with
     Global => (In_Out => (Device, Written)),
     Post   => Written.Count = Written.Count'Old + 1
       and then Written.Last = Robot.Protocol.Decoded (Item);
   --  Sends the frame. Never waits: fails if the device accepts nothing or has
   --  been removed

   procedure Read
     (Data    : out Bytes.Byte_Array;
      Length  : out Natural;
      Until_Time : Ada.Real_Time.Time;
      Success : out Boolean)
   with
     Global => (In_Out => Device, Input => Ada.Real_Time.Clock_Time),
     Post   => Length <= Data'Length;
   --  Received data; waits for the first byte until Until_Time at most, then
   --  Length is 0. Success is false if the device has been removed

   procedure Send_Stop
     (Path : Texts.Text; Sent : out Boolean; Report : out Texts.Text)
   with
     Global =>
       (In_Out => Device, Input => Ada.Real_Time.Clock_Time);
   --  Opens the device, writes the stop order's frame and closes it: for a
   --  robot whose supervisor was killed, while this one has no session. A line
   --  in use stays as it is. Report says what was done, or why nothing

   procedure Get_Gone (Gone : out Boolean) with Global => (Input => Device);
   --  Whether the device has been removed since it was opened

   procedure Get_Use (Path : Texts.Text; Used : out Texts.Text)
   with Global => (In_Out => Device);
   --  What else the device is for: a console of the kernel, a login; empty if
   --  nothing is known

   procedure Stop_Blindly with Global => (In_Out => Device);
   --  Writes the stop order's frame from any task: the last resort when the
   --  supervisor ends by an internal failure

end Robot.Serial_Line;
