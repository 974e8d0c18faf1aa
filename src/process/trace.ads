--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace (--trace): the newest events of all tasks with their times, in
--  memory, and at the end in a file. Without --trace each call tests one flag.

with Ada.Real_Time;
with Commands;
with Orders;
with Schedule;
with Texts;

package Trace with
  SPARK_Mode,
  Abstract_State =>
    (Recorder with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Recorder
is
   pragma Annotate (GNATprove, Terminating, Trace);
   --  Finish waits for the disk, nothing else waits. Proved, if each call of
   --  the system (Trace.Calls) ends

   Capacity : constant := 2 ** 17;
   --  Events kept, in 4 MiB of memory: more than two minutes of a session with
   --  images, positions and 25 commands per second

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

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text)
   with
     Global => (Input => Ada.Real_Time.Clock_Time, In_Out => Recorder);
   --  Ends the recording and writes the file, if any. Whole is false if it is
   --  incomplete: the disk is full, or it took longer than
   --  Schedule.Trace_Limit. The calling task first gives up its real-time
   --  priority. To be called last, before the end of the process

   --  The events. Who: the task concerned

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0)
   with Global => (In_Out => Recorder);
   --  Release: Who becomes ready. Called just before the event is signalled

   procedure Release (Who : Task_Name; Due : Ada.Real_Time.Time)
   with Global => (In_Out => Recorder);
   --  The clock released Who at Due. Called by Who itself

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
     (Name : Commands.Command_Name; Number : Orders.Ticket)
   with Global => (In_Out => Recorder);
   --  A command of the monitor has been received

   procedure Sent (Label : Commands.Label_Text)
   with Global => (In_Out => Recorder);
   --  A message to the monitor has been sent

   procedure Ordered (Who : Task_Name; Letter : Character)
   with Global => (In_Out => Recorder);
   --  The robot's command with this letter has been written

end Trace;
