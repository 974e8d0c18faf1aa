--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of the recorder's ring, and the processor's atomic operations
--  on it. Decides nothing, see Trace.Rings.

with Trace_Json;
with Trace_Slots; use Trace_Slots;

private package Trace.Ring_Memory with
  SPARK_Mode,
  Abstract_State =>
    (Memory with
       Synchronous,
       External => (Async_Readers, Async_Writers),
       Part_Of  => Trace.Recorder),
  Initializes => Memory
is

   pragma Annotate (GNATprove, Terminating, Trace.Ring_Memory);

   procedure Reset with Global => (In_Out => Memory);
   --  All slots are empty, no number is claimed, and all pages are present.
   --  Before any other call, and not at the same time as one

   procedure Claim (Count : Event_Number; Number : out Event_Number)
   with Global => (In_Out => Memory);
   --  Claims the next Count event numbers, from Number on; 0: none

   procedure Change
     (Slot : Slot_Index; Before, After : Slot_State; Found : out Slot_State)
   with Global => (In_Out => Memory);
   --  Sets the state to After if it is Before. Found: what it was

   procedure Write
     (Slot  : Slot_Index;
      Item  : Trace_Json.Event;
      After : Slot_State;
      Ahead : Slot_Index)
   with Global => (In_Out => Memory);
   --  Writes the event, then sets the state. For the task that has set the
   --  state Being_Written. Then prefetches Ahead, which will be written soon

   procedure Read
     (Slot          : Slot_Index;
      Before, After : out Slot_State;
      Item          : out Trace_Json.Event)
   with Global => (In_Out => Memory);
   --  The event, with the state before and after it was read. If these are
   --  not the same, or it is being written, Item may be mixed from two events

end Trace.Ring_Memory;
