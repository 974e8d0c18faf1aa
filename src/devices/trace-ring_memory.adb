--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with System;

package body Trace.Ring_Memory with
  SPARK_Mode    => Off,
  Refined_State => (Memory => (Slots, Next))
is
   --  Off: addresses, and atomic operations of the processor

   type Slot_Type is record
      State : aliased Slot_State;
      Item  : Trace_Json.Event;
   end record
   with Size => 32 * 8, Suppress_Initialization;

   Slots : array (Slot_Index) of Slot_Type with Alignment => 64;
   --  No page of it is present before Reset

   Next : aliased Unsigned_64 := 0;

   --  Memory order, for processors with a weak memory model such as arm64 (on
   --  x86 it only restricts the compiler). Writer: State odd with a full
   --  barrier, event, State even with release. Reader: State with acquire,
   --  event, fence, State again. So a reader that sees part of an event being
   --  written then sees the odd State, and a reader that sees the even State
   --  sees the whole event. The event numbers need no order: Next tells
   --  nothing about the contents of a slot.

   Acquire : constant int := 2;  --  __ATOMIC_ACQUIRE
   Release : constant int := 3;  --  __ATOMIC_RELEASE
   Relaxed : constant int := 0;  --  __ATOMIC_RELAXED

   function Load (From : System.Address; Order : int) return Unsigned_64
   with Import, Convention => Intrinsic, External_Name => "__atomic_load_8";

   procedure Store (To : System.Address; Value : Unsigned_64; Order : int)
   with Import, Convention => Intrinsic, External_Name => "__atomic_store_8";

   function Fetch_And_Add
     (Counter : System.Address; Amount : Unsigned_64; Order : int)
      return Unsigned_64
   with Import, Convention => Intrinsic,
     External_Name => "__atomic_fetch_add_8";

   function Compare_And_Swap
     (Place : System.Address; Before, After : Unsigned_64) return Unsigned_64
   with Import, Convention => Intrinsic,
     External_Name => "__sync_val_compare_and_swap_8";
   --  A full barrier

   procedure Fence (Order : int)
   with Import, Convention => Intrinsic,
     External_Name => "__atomic_thread_fence";

   procedure Prefetch (Where : System.Address; To_Write, Locality : int)
   with Import, Convention => Intrinsic, External_Name => "__builtin_prefetch";

   procedure Change
     (Slot : Slot_Index; Before, After : Slot_State; Found : out Slot_State)
   is
   begin
      Found := Compare_And_Swap (Slots (Slot).State'Address, Before, After);
   end Change;

   procedure Claim (Count : Event_Number; Number : out Event_Number) is
   begin
      Number := Fetch_And_Add (Next'Address, Count, Relaxed);
   end Claim;

   procedure Read
     (Slot          : Slot_Index;
      Before, After : out Slot_State;
      Item          : out Trace_Json.Event) is
   begin
      Before := Load (Slots (Slot).State'Address, Acquire);
      Item := Slots (Slot).Item;
      Fence (Acquire);
      After := Load (Slots (Slot).State'Address, Relaxed);
   end Read;

   procedure Reset is
   begin
      for Slot of Slots loop
         Slot := (State => Empty, Item => <>);
      end loop;
      Next := 0;
   end Reset;

   procedure Write
     (Slot  : Slot_Index;
      Item  : Trace_Json.Event;
      After : Slot_State;
      Ahead : Slot_Index) is
   begin
      Slots (Slot).Item := Item;
      Store (Slots (Slot).State'Address, After, Release);
      Prefetch (Slots (Ahead)'Address, 1, 3);
   end Write;

end Trace.Ring_Memory;
