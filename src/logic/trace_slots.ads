--  SPDX-License-Identifier: GPL-3.0-or-later
--  The slots of a trace's ring: where an event is, who may write a slot, and
--  what a reader may conclude from its state.

with Interfaces; use Interfaces;

package Trace_Slots with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Trace_Slots);

   Capacity : constant := 2 ** 12;
   --  A power of 2: no division where an event is recorded

   type Slot_Index is range 0 .. Capacity - 1;

   subtype Event_Number is Unsigned_64 range 0 .. 2 ** 62;
   --  From 0. With an event each nanosecond the last is reached after 146
   --  years

   subtype Slot_State is Unsigned_64;
   --  Empty, Being_Written or Complete. Only the task that has set the state
   --  Being_Written writes the event, so two writers a whole round apart
   --  cannot mix their events

   Empty : constant Slot_State := 0;

   function Being_Written (Number : Event_Number) return Slot_State is
     (2 * Number + 1);

   function Complete (Number : Event_Number) return Slot_State is
     (2 * Number + 2);

   function Slot_Of (Number : Event_Number) return Slot_Index is
     (Slot_Index (Number mod Capacity));

   function May_Write (State : Slot_State; Number : Event_Number)
     return Boolean
   is
     (State mod 2 = 0 and then State <= 2 * Number)
   with
     Post => (if May_Write'Result then State < Being_Written (Number));
   --  Whether the writer of event Number may replace State by Being_Written.
   --  States only increase, so a state that has not changed meanwhile is the
   --  same, and no newer event is overwritten

   function Expected (Number : Event_Number) return Slot_State is
     (if Number < Capacity then Empty else Complete (Number - Capacity))
   with Post => May_Write (Expected'Result, Number);
   --  The state in which the writer of event Number finds its slot, if no
   --  event was lost

   procedure Prove_States (Old, Number : Event_Number) with
     Ghost,
     Post =>
       May_Write (Empty, Number)
       and then not May_Write (Being_Written (Old), Number)
       and then May_Write (Complete (Old), Number) = (Old < Number)
       and then (Complete (Old) = Complete (Number)) = (Old = Number)
       and then Complete (Number) /= Being_Written (Old)
       and then Complete (Number) /= Empty
       and then Being_Written (Number) < Complete (Number);
   --  A slot being written belongs to its writer, and a complete one to
   --  newer events. A slot in the state Complete (Number) has event Number
   --  and no other

end Trace_Slots;
