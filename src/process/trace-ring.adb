--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with System;

package body Trace.Ring with
  SPARK_Mode    => Off,
  Refined_State => (Memory => (Slots, Next))
is
   --  Off: addresses, and atomic operations of the processor

   type Slot_Type is record
      Mark : aliased Unsigned_64;  --  event number + 1; 0: none
      Item : Event;
   end record
   with Size => 32 * 8, Suppress_Initialization;

   Slots : array (Unsigned_64 range 0 .. Capacity - 1) of Slot_Type
   with Alignment => 64;
   --  No page of it is present before Reset

   Next : aliased Unsigned_64 := 0;

   --  Memory order, for processors with a weak memory model such as arm64 (on
   --  x86 it only restricts the compiler). Writer: Mark 0, fence, event, Mark
   --  with release. Reader: Mark with acquire, event, fence, Mark again. So a
   --  reader that sees the same mark twice sees the whole event and no part
   --  of a later one. Two writers of a slot are a whole round apart, minutes
   --  at least; should one be kept from its processor for so long, its event
   --  may be mixed with the other's.

   Relaxed    : constant int := 0;  --  __ATOMIC_RELAXED
   Acquire    : constant int := 2;  --  __ATOMIC_ACQUIRE
   To_Release : constant int := 3;  --  __ATOMIC_RELEASE

   function Load (From : System.Address; Order : int) return Unsigned_64
   with Import, Convention => Intrinsic, External_Name => "__atomic_load_8";

   procedure Store (To : System.Address; Value : Unsigned_64; Order : int)
   with Import, Convention => Intrinsic, External_Name => "__atomic_store_8";

   function Fetch_And_Add
     (Counter : System.Address; Amount : Unsigned_64; Order : int)
      return Unsigned_64
   with Import, Convention => Intrinsic,
     External_Name => "__atomic_fetch_add_8";

   procedure Fence (Order : int)
   with Import, Convention => Intrinsic,
     External_Name => "__atomic_thread_fence";

   procedure Prefetch (Where : System.Address; To_Write, Locality : int)
   with Import, Convention => Intrinsic, External_Name => "__builtin_prefetch";

   procedure Get_Time (Now : out Time) is
   begin
      Now := Clock;
   end Get_Time;

   procedure Reset is
   begin
      for Slot of Slots loop
         Slot := (Mark => 0, Item => <>);
      end loop;
      Next := 0;
   end Reset;

   procedure Put (Item : Event) is
      Number : constant Unsigned_64 :=
        Fetch_And_Add (Next'Address, 1, Relaxed);
      Slot   : Slot_Type renames Slots (Number mod Capacity);
   begin
      Store (Slot.Mark'Address, 0, Relaxed);
      Fence (To_Release);
      Slot.Item := Item;
      Store (Slot.Mark'Address, Number + 1, To_Release);
      --  long evicted from the cache, and soon to be written
      Prefetch (Slots ((Number + 3) mod Capacity)'Address, 1, 3);
   end Put;

   procedure Get_Count (Count : out Event_Number) is
   begin
      Count := Load (Next'Address, Relaxed);
   end Get_Count;

   procedure Get (Number : Event_Number; Item : out Event; Found : out Boolean)
   is
      Slot   : Slot_Type renames Slots (Number mod Capacity);
      Before : constant Unsigned_64 := Load (Slot.Mark'Address, Acquire);
   begin
      Item := Slot.Item;
      Fence (Acquire);
      Found := Before = Number + 1
        and then Load (Slot.Mark'Address, Relaxed) = Before;
      if not Found then
         Item := (others => <>);
      end if;
   end Get;

end Trace.Ring;
