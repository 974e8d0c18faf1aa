--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace (--trace): what every task did and when. While the tasks work,
--  the events go through memory to the far end of the file; at the end they
--  become its text. Without it each call tests one flag.

with Ada.Real_Time;
with Monitor.Protocol;
with Orders;
with Robot.Protocol;
with Schedule;
with Texts;

package Trace with
  SPARK_Mode,
  Abstract_State =>
    (Recorder with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Recorder
is
   pragma Annotate (GNATprove, Terminating, Trace);
   --  Store waits for something to store, and Finish for Store, both for a
   --  limited time, and both for the disk; nothing else waits for anything.
   --  A claim by reading: the body is outside SPARK

   Capacity : constant := 2 ** 17;
   --  Events kept, the newest: more than two minutes of a session with
   --  images, positions and 25 commands a second

   In_Memory : constant := 2 ** 12;
   --  The newest of them, in 128 KiB: the rest is in the file. What is
   --  recorded faster than Store can take it there, is lost, the oldest first

   subtype Task_Name is Schedule.Task_Name;

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => Recorder);
   --  Whether Open would find a file that it can use; leaves all as it was

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => Recorder);
   --  Opens the file, which must not be a pipe or a terminal, takes the
   --  memory, and records from here on. Reason says why where Success is
   --  false. Once, before the tasks work

   procedure Store with Global => (In_Out => Recorder);
   --  Takes what has been recorded to the file. Waits before until it is a
   --  quarter of In_Memory, or Wake has been called, Schedule.Store_Limit at
   --  most. For one task only, from Open on

   procedure Wake with Global => (In_Out => Recorder);
   --  Ends the wait in Store, in the next one where none is under way

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => Recorder);
   --  Ends the recording and writes the file, where there is one. Whole is
   --  false where not all is in it: the disk is or was full, or it took
   --  longer than Schedule.Trace_Limit. The calling task gives up its
   --  real-time priority first. When nothing is left to be done but to end
   --  the process

   --  The events. Who: the task that the event is about

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0)
   with Global => (In_Out => Recorder);
   --  Who has something to do. Called where the event is signalled, just
   --  before

   procedure Start (Who : Task_Name; Number : Orders.Ticket := 0)
   with Global => (In_Out => Recorder);
   --  Who begins a job; Number: the monitor's command behind it

   procedure Take_Up (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Who begins a job that the kernel has released it for, just now

   procedure Start (Who : Task_Name; Due : Ada.Real_Time.Time)
   with Global => (In_Out => Recorder);
   --  The same for a job whose release was at Due, by the clock

   procedure Done (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Who has nothing more to do for its job, if it had one

   type Wait_Kind is
     (Line,      --  the robot's line, until the request is done
      Answer,    --  the robot's answer, or its time-out
      Gap,       --  the gap between two messages
      Camera,    --  the camera: opened, released, the next image
      Room,      --  room for an answer
      Tasks);    --  tasks that are at work still

   procedure Wait (Who : Task_Name; What : Wait_Kind)
   with Global => (In_Out => Recorder);
   --  In its job Who waits for What

   procedure Resume (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Who waits no longer, if it did

   procedure Resume (Who : Task_Name; Due : Ada.Real_Time.Time)
   with Global => (In_Out => Recorder);
   --  The same after a wait until Due, by the clock

   procedure Idle (Who : Task_Name)
   with Global => (In_Out => Recorder);
   --  Whatever released Who so far, there is nothing to do

   procedure Received
     (Kind : Monitor.Protocol.Message_Kind; Number : Orders.Ticket)
   with Global => (In_Out => Recorder);
   --  A command of the monitor has come

   procedure Sent (Label : Monitor.Protocol.Label_Text)
   with Global => (In_Out => Recorder);
   --  A message to the monitor has gone

   procedure Ordered (Who : Task_Name; Kind : Robot.Protocol.Command_Kind)
   with Global => (In_Out => Recorder);
   --  A command for the robot has been written

end Trace;
