--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of the trace: a ring of events that any number of tasks write
--  without waiting for each other.

with Interfaces; use Interfaces;

private package Trace.Ring with
  SPARK_Mode,
  Abstract_State =>
    (Memory with
       Synchronous,
       External => (Async_Readers, Async_Writers),
       Part_Of  => Trace.Recorder),
  Initializes => Memory
is

   pragma Annotate (GNATprove, Terminating, Trace.Ring);
   --  By review: the only loop has a fixed length

   type Event_Kind is
     (Release,    --  the task has become ready
      Due,        --  the same by the clock, at the time that was set
      Start,      --  of a job
      Take_Up,    --  both at once: released by the kernel just now
      Start_Due,  --  of a job whose release was at the time Number
      Done,       --  end of a job
      Wait,       --  the job waits, Label is the reason
      Resume,     --  the wait ends
      Idle,       --  the task found nothing to do
      Received,   --  a message of the monitor, Label is its own
      Sent,       --  a message to the monitor
      Ordered);   --  a command to the robot, Label is its letter

   subtype Label_Text is String (1 .. 6);
   --  Padded with blanks

   type Event is record
      At_Time : Unsigned_64 := 0;   --  in nanoseconds, CLOCK_MONOTONIC
      Number  : Unsigned_64 := 0;
      --  of the monitor's command, 0: none; of Start_Due: its release
      Who     : Task_Name := Task_Name'First;
      Kind    : Event_Kind := Idle;
      Label   : Label_Text := (others => ' ');
   end record
   with Size => 24 * 8;

   subtype Event_Number is Unsigned_64 range 0 .. 2 ** 62;
   --  From 0. With an event each nanosecond the last is reached after 146
   --  years

   procedure Reset with Global => (In_Out => Memory);
   --  No event is there, and all pages are present. Before any other call,
   --  and not at the same time as one

   procedure Put (Item : Event) with Global => (In_Out => Memory);
   --  Overwrites the oldest event if the ring is full. Never waits

   procedure Get_Count (Count : out Event_Number)
   with Global => (In_Out => Memory);
   --  Number of events put so far

   procedure Get (Number : Event_Number; Item : out Event; Found : out Boolean)
   with Global => (In_Out => Memory);
   --  Not found if it is overwritten or being written

end Trace.Ring;
