--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of the trace: a ring of events that any number of tasks write
--  without waiting for each other.

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces;    use Interfaces;

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

   type Event is record
      At_Time : Time := Time_First;
      Number  : Commands.Ticket := 0;
      Who     : Schedule.Task_Name := Schedule.Task_Name'First;
      Kind    : Event_Kind := Done;
      Label   : Label_Text := No_Label;
   end record
   with Size => 24 * 8;

   subtype Event_Number is Unsigned_64 range 0 .. 2 ** 62;
   --  From 0. With an event each nanosecond the last is reached after 146
   --  years

   procedure Get_Time (Now : out Time) with Global => (In_Out => Memory);
   --  The clock of the events: Ada's

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
