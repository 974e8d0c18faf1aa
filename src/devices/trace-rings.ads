--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of a flight recorder: a ring of events that any number of tasks
--  write without waiting for each other. For Trace only.

with Interfaces; use Interfaces;
with System;
with Trace_Json;

private package Trace.Rings with SPARK_Mode => Off is
   --  Off: addresses, and atomic operations of the processor

   Slot_Bytes : constant := 32;

   type Ring is limited private;

   procedure Set_Up
     (R : in out Ring; Where : System.Address; Capacity : Unsigned_64);
   --  An empty ring at Where, in Capacity * Slot_Bytes zeroed bytes

   procedure Put
     (R : in out Ring; Item : Trace_Json.Event; Number : out Unsigned_64);
   --  Overwrites the oldest event if the ring is full. Never waits: if another
   --  task is still writing that slot, Item is lost. Number: number of events
   --  before

   function Count (R : Ring) return Unsigned_64;
   --  Number of events put so far

   procedure Get
     (R      : Ring;
      Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean);
   --  The event Number, counted from 0. Not found if it has been overwritten
   --  or lost, or is being written

private

   type Ring is limited record
      Where    : System.Address := System.Null_Address;
      Capacity : Unsigned_64    := 1;
      Next     : aliased Unsigned_64 := 0;
   end record;

end Trace.Rings;
