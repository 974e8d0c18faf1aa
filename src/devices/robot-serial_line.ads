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
   with Global => (In_Out => Device);
   --  Opens and sets up the device, and discards what it has received
   --  already. Reason says why where Success is false

   procedure Close with Global => (In_Out => Device);
   --  Without effect where it is not open

   procedure Discard_Input with Global => (In_Out => Device);
   --  Forgets what has been received and not yet read

   type Line_Record is record
      Count : Interfaces.Unsigned_64 := 0;
      --  of frames, the failed ones too
      Last  : Robot.Protocol.Reading;
      --  as the robot reads it
   end record;

   Written : Line_Record with Ghost;
   --  What has been written to the line by its owner

   procedure Write (Item : Robot.Protocol.Frame; Success : out Boolean)
   with
     Global => (In_Out => (Device, Written)),
     Post   => Written.Count = Written.Count'Old + 1
       and then Written.Last = Robot.Protocol.Decoded (Item);
   --  Sends the frame. Does not wait: fails where the device takes nothing,
   --  and where it is gone

   procedure Read
     (Data    : out Bytes.Byte_Array;
      Length  : out Natural;
      Until_Time : Ada.Real_Time.Time;
      Success : out Boolean)
   with
     Global => (In_Out => Device, Input => Ada.Real_Time.Clock_Time),
     Post   => Length <= Data'Length;
   --  What has been received; waits for a first byte until Until_Time at
   --  most, Length is 0 then. Success is false where the device is gone

   procedure Stop_Blindly with Global => (In_Out => Device);
   --  Writes the stop order's frame, whoever owns the line: the last resort
   --  of a supervisor that ends on an internal failure

end Robot.Serial_Line;
