--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line to the robot: 9600 baud, 8 data bits, no parity, 1 stop
--  bit, raw, no echo. For the one task that has the line.

with Ada.Real_Time;
with Bytes;
with Robot.Protocol;
with Robot.Session;
with Schedule;
with Texts;

package Robot.Serial_Line with
  SPARK_Mode,
  Abstract_State =>
    (Device with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Device
is

   use type Session.Mode_Kind;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text);
   --  Opens and configures the device, for this process alone, and discards
   --  its input so far. Reason explains a failure

   procedure Close (All_Sent : out Boolean);
   --  Waits for what has been written to leave, Schedule.Unsent_Limit at most;
   --  the rest is discarded, since the device may never take it (not
   --  All_Sent). No effect if it is not open

   procedure Discard_Input;
   --  Discards what has been received and not read

   procedure Write
     (Who    : Schedule.Thread_Name;
      Item   : Protocol.Command;
      Mode   : Session.Mode_Kind;
      Length : out Protocol.Frame_Length)
   with
     Pre =>
       (if Protocol.Is_Movement (Item) then Mode /= Session.Not_Started);
   --  Sends the frame of Item, which has Length bytes, to a robot in Mode.
   --  Never waits. Length 0: the device accepts nothing or has been removed

   procedure Read
     (Data       : out Bytes.Byte_Array;
      Length     : out Natural;
      Until_Time : Ada.Real_Time.Time;
      Gone       : out Boolean)
   with Post => Length <= (if Gone then 0 else Data'Length);
   --  Received data; waits for the first byte until Until_Time at most, then
   --  Length is 0. Gone: the device has been removed

   procedure Send_Stop
     (Path : Texts.Text; Sent : out Boolean; Report : out Texts.Text);
   --  Opens the device, writes the stop order's frame and closes it: for a
   --  robot whose supervisor was killed, while this one has no session. A line
   --  in use stays as it is. Report says what was done, or why nothing

   procedure Stop_Blindly;
   --  Writes the stop order's frame from any task: the last resort when the
   --  supervisor ends by an internal failure

end Robot.Serial_Line;
