--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace (--trace): events of all tasks with their times. While the tasks
--  work, the events go through memory to the end of the file; at the end the
--  text is made from them. Without --trace each call tests one flag.

with Ada.Real_Time;
with Monitor.Protocol;
with Orders;
with Robot.Protocol;
with Schedule;
with Texts;
with Trace_Layout;

package Trace with
  SPARK_Mode,
  Abstract_State =>
    (Recorder with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Recorder
is
   pragma Annotate (GNATprove, Terminating, Trace);
   --  Store waits for events, and Finish for Store, both for a limited time,
   --  and both for the disk; nothing else waits. Proved, if each call of the
   --  system (Trace.Calls) and each delay ends

   Capacity : constant := Trace_Layout.Capacity;
   --  Newest events kept: more than two minutes of a session with images,
   --  positions and 25 commands per second

   In_Memory : constant := Trace_Layout.In_Memory;
   --  The newest of them, in 128 KiB of memory; the rest is in the file. If
   --  events are recorded faster than Store saves them, the oldest are lost

   subtype Task_Name is Schedule.Task_Name;

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => Recorder);
   --  Whether Open would succeed; changes nothing

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => Recorder);
   --  Opens the file, which must not be a pipe or a terminal, touches the
   --  memory, and starts recording. Reason explains a failure. Call once,
   --  before the tasks work

   procedure Store with Global => (In_Out => Recorder);
   --  Saves the recorded events to the file. First waits until In_Memory is a
   --  quarter full or Wake has been called, at most Schedule.Store_Limit. For
   --  one task only, after Open

   procedure Wake with Global => (In_Out => Recorder);
   --  Ends the current wait in Store, or else the next one

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text)
   with
     Global => (Input => Ada.Real_Time.Clock_Time, In_Out => Recorder);
   --  Ends the recording and writes the file, if any. Whole is false if it is
   --  incomplete: the disk is or was full, or it took longer than
   --  Schedule.Trace_Limit. The calling task first gives up its real-time
   --  priority. To be called last, before the end of the process

   --  The events. Who: the task concerned

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0)
   with Global => (In_Out => Recorder);
   --  Release: Who becomes ready. Called just before the event is signalled

   procedure Start (Who : Task_Name; Number : Orders.Ticket := 0)
   with Global => (In_Out => Recorder);
   --  Who starts a job; Number: of the monitor's command, if any

   procedure Take_Up (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Who starts a job just released by the kernel

   procedure Start (Who : Task_Name; Due : Ada.Real_Time.Time)
   with Global => (In_Out => Recorder);
   --  Who starts a job that the clock released at Due

   procedure Done (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Who completes its job, if it has one

   type Wait_Kind is
     (Line,      --  the robot's line, until the request is done
      Answer,    --  the robot's answer, or its time-out
      Gap,       --  the gap between two messages
      Camera,    --  the camera: opened, released, the next image
      Room,      --  room for an answer
      Tasks);    --  tasks that are still busy

   procedure Wait (Who : Task_Name; What : Wait_Kind)
   with Global => (In_Out => Recorder);
   --  During its job Who waits for What

   procedure Resume (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  The wait of Who ends, if there is one

   procedure Resume (Who : Task_Name; Due : Ada.Real_Time.Time)
   with Global => (In_Out => Recorder);
   --  The wait of Who until the time Due ends

   procedure Idle (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Who was released, but has nothing to do

   procedure Received
     (Kind : Monitor.Protocol.Message_Kind; Number : Orders.Ticket)
   with Global => (In_Out => Recorder);
   --  A command of the monitor has been received

   procedure Sent (Label : Monitor.Protocol.Label_Text)
   with Global => (In_Out => Recorder);
   --  A message to the monitor has been sent

   procedure Ordered (Who : Task_Name; Kind : Robot.Protocol.Command_Kind)
   with Global => (In_Out => Recorder);
   --  A command for the robot has been written

end Trace;
