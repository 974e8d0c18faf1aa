--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of a flight recorder: a ring of events that any number of tasks
--  write without waiting for each other. For Trace only.

with Trace.Ring_Memory;
with Trace_Json;
with Trace_Slots; use Trace_Slots;

private package Trace.Rings with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Trace.Rings);

   procedure Put (Item : Trace_Json.Event; Number : out Event_Number)
   with Global => (In_Out => Ring_Memory.Memory);
   --  Overwrites the oldest event if the ring is full. Never waits: if another
   --  task is still writing that slot, Item is lost. Number: number of events
   --  before

   procedure Get_Count (Count : out Event_Number)
   with Global => (In_Out => Ring_Memory.Memory);
   --  Number of events put so far

   procedure Get
     (Number : Event_Number;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   with Global => (In_Out => Ring_Memory.Memory);
   --  The event Number, counted from 0. Not found if it has been overwritten
   --  or lost, or is being written

end Trace.Rings;
