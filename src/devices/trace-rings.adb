--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C;            use Interfaces.C;
with System.Storage_Elements; use System.Storage_Elements;

package body Trace.Rings with SPARK_Mode => Off is

   type Slot is record
      State : aliased Unsigned_64;
      --  0: empty; 2 N + 1: event N is being written; 2 N + 2: it is complete.
      --  Only the task that has set the odd value writes Item, so two writers
      --  a whole round apart cannot mix their events
      Item  : Trace_Json.Event;
   end record
   with Size => Slot_Bytes * 8;

   --  Memory order, for processors with a weak memory model such as arm64 (on
   --  x86 it only restricts the compiler). Writer: State odd, fence, event,
   --  State even with release. Reader: State with acquire, event, fence, State
   --  again. So a reader that sees part of an event being written then sees
   --  the odd State, and a reader that sees the even State sees the whole
   --  event. The event numbers need no order: R.Next tells nothing about the
   --  contents of a slot.

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
   --  Sets Place to After if it equals the value at Before

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
         --  long evicted from the cache: prefetch the next slots
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
