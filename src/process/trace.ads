--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace (--trace): the newest events of all tasks with their times, in
--  memory, and at the end in a file. Without --trace each call tests one flag.

with Ada.Real_Time;
with Commands;
with Process;
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
   --  the system ends

   Capacity : constant := 2 ** 17;
   --  Events kept, in 4 MiB of memory: about two minutes of a session with
   --  images, positions and 25 commands per second

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => Process.System_State);
   --  Whether Open would succeed; changes nothing

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   with Global => (In_Out => (Recorder, Process.System_State));
   --  Opens the file, which must not be a pipe or a terminal, touches the
   --  memory, and starts recording. Reason explains a failure. Call once,
   --  before the tasks work

   procedure Finish (Reason : out Texts.Text)
   with
     Global => (Input  => Ada.Real_Time.Clock_Time,
                In_Out => (Recorder, Process.System_State));
   --  Ends the recording and writes the file, if any. Reason is empty, or says
   --  why it is incomplete: the disk is full, or it took longer than
   --  Schedule.Trace_Limit. The calling task first gives up its real-time
   --  priority. To be called last, before the end of the process

   procedure Append_Time
     (Line  : in out Texts.Text;
      Value : Ada.Real_Time.Time;
      Step  : Positive := 1;
      Width : Positive := 9)
   with Global => null, Pre => Width <= 9;
   --  Value, as seconds of the clock with Width decimals, in steps of Step
   --  nanoseconds

   --  The events. Who: the task concerned. What the main procedure does is
   --  not recorded

   type Event_Kind is
     (Release,   --  Who becomes ready: just before its event is signalled
      Due,       --  the same by the clock, at the time that was set
      Start,     --  Who starts a job
      Take,      --  the job is for the monitor's command Number
      Done,      --  Who completes its job, if it has one
      Wait,      --  during its job Who waits for Label
      Resume,    --  the wait ends, if there is one
      Received,  --  the command Number, with this Label, from the monitor
      Sent,      --  a message with this Label to the monitor
      Ordered);  --  a command with this letter to the robot

   subtype Label_Text is String (1 .. 6);
   --  Padded with blanks

   No_Label : constant Label_Text := "      ";
   Line     : constant Label_Text := "line  ";
   --  the robot's line, until the request is done
   Answer   : constant Label_Text := "answer";
   --  the robot's answer, or its time-out
   Gap      : constant Label_Text := "gap   ";
   --  the gap between two messages
   Camera   : constant Label_Text := "camera";
   --  the camera: opened, released, the next image
   Room     : constant Label_Text := "room  ";
   --  room for an answer
   Tasks    : constant Label_Text := "tasks ";
   --  tasks that are still busy

   procedure Put
     (Kind   : Event_Kind;
      Who    : Schedule.Thread_Name;
      Number : Commands.Ticket := 0;
      Label  : Label_Text := No_Label)
   with Global => (In_Out => Recorder);
   --  Records an event now

   procedure Put_Due (Who : Schedule.Thread_Name; At_Time : Ada.Real_Time.Time)
   with Global => (In_Out => Recorder);
   --  Records that the clock has released Who at At_Time. Called by Who itself

end Trace;
