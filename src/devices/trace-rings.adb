--  SPDX-License-Identifier: GPL-3.0-or-later
--  The memory of a flight recorder: a ring of events that any number of
--  tasks write without waiting for each other. For Trace only.

with Interfaces.C;            use Interfaces.C;
with System.Storage_Elements; use System.Storage_Elements;

package body Trace.Rings with SPARK_Mode => Off is

   type Slot is record
      State : aliased Unsigned_64;
      --  0: empty; 2 N + 1: event N is being written; 2 N + 2: it is there.
      --  Only who has changed it to the odd value writes the rest, so two
      --  writers a whole round apart cannot mix their events
      Item  : Trace_Json.Event;
   end record
   with Size => Slot_Bytes * 8;

   --  The order of memory, for processors that keep as little of it as those
   --  of arm64 (on x86 only the compiler could disturb it). A writer: State
   --  odd, fence, event, State even with release. A reader: State with
   --  acquire, event, fence, State again. So whoever reads a part of an event
   --  that is being written, sees the odd State behind it, and whoever sees
   --  the even State sees all of its event. The numbers of events need no
   --  order: R.Next says nothing of what a slot holds.

   Acquire : constant int := 2;  --  __ATOMIC_ACQUIRE
   Release : constant int := 3;  --  __ATOMIC_RELEASE
   Relaxed : constant int := 0;  --  __ATOMIC_RELAXED

   function Load (From : System.Address; Order : int) return Unsigned_64
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__atomic_load_8";

   procedure Store (To : System.Address; Value : Unsigned_64; Order : int)
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__atomic_store_8";

   function Fetch_And_Add
     (Counter : System.Address; Amount : Unsigned_64; Order : int)
      return Unsigned_64
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__atomic_fetch_add_8";

   function Compare_And_Swap
     (Place   : System.Address;
      Before  : System.Address;
      After   : Unsigned_64;
      Weak    : Boolean;
      Success : int;
      Failure : int) return Boolean
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__atomic_compare_exchange_8";
   --  After is at Place now if the value at Before was there

   procedure Fence (Order : int)
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__atomic_thread_fence";

   procedure Prefetch (Where : System.Address; To_Write, Locality : int)
   with
     Import,
     Convention    => Intrinsic,
     External_Name => "__builtin_prefetch";

   function Place (R : Ring; Number : Unsigned_64) return System.Address is
     (R.Where + Storage_Offset (Slot_Bytes * (Number mod R.Capacity)));

   function Count (R : Ring) return Unsigned_64 is
     (Load (R.Next'Address, Acquire));

   procedure Get
     (R      : Ring;
      Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   is
      Here : Slot with Import, Address => Place (R, Number);
      Done : constant Unsigned_64 := 2 * Number + 2;
   begin
      Found := Load (Here.State'Address, Acquire) = Done;
      if Found then
         Item := Here.Item;
         Fence (Acquire);
         Found := Load (Here.State'Address, Relaxed) = Done;
      end if;
      if not Found then
         Item := (others => <>);
      end if;
   end Get;

   procedure Put
     (R : in out Ring; Item : Trace_Json.Event; Number : out Unsigned_64)
   is
      Own    : constant Unsigned_64 :=
        Fetch_And_Add (R.Next'Address, 1, Relaxed);
      Here   : Slot with Import, Address => Place (R, Own);
      Before : aliased Unsigned_64 := Load (Here.State'Address, Relaxed);
   begin
      Number := Own;
      if Before mod 2 = 0
        and then Before <= 2 * Own
        and then Compare_And_Swap
          (Here.State'Address, Before'Address, 2 * Own + 1, False,
           Acquire, Relaxed)
      then
         Fence (Release);
         Here.Item := Item;
         Store (Here.State'Address, 2 * Own + 2, Release);
         --  it is long ago that a cache had them: the next slots on their way
         Prefetch (Place (R, Own + 3), 1, 3);
      end if;
   end Put;

   procedure Set_Up
     (R : in out Ring; Where : System.Address; Capacity : Unsigned_64) is
   begin
      R.Where := Where;
      R.Capacity := Capacity;
      R.Next := 0;
   end Set_Up;

end Trace.Rings;
