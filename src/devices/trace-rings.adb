--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces; use Interfaces;

package body Trace.Rings with SPARK_Mode is

   procedure Get
     (Number : Event_Number;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   is
      Before, After : Slot_State;
   begin
      Ring_Memory.Read (Slot_Of (Number), Before, After, Item);
      Found := Before = Complete (Number) and then After = Before;
      if not Found then
         Item := (others => <>);
      end if;
   end Get;

   procedure Get_Count (Count : out Event_Number) is
   begin
      Ring_Memory.Claim (0, Count);
   end Get_Count;

   procedure Put (Item : Trace_Json.Event; Number : out Event_Number) is
      Before : Slot_State;
      Found  : Slot_State;
   begin
      Ring_Memory.Claim (1, Number);
      Before := Expected (Number);
      Ring_Memory.Change
        (Slot_Of (Number), Before, Being_Written (Number), Found);
      if Found /= Before and then May_Write (Found, Number) then
         --  the event there before was lost
         Before := Found;
         Ring_Memory.Change
           (Slot_Of (Number), Before, Being_Written (Number), Found);
      end if;
      if Found = Before then
         --  long evicted from the cache: prefetch the next slots
         Ring_Memory.Write
           (Slot_Of (Number), Item, Complete (Number),
            Ahead => (Slot_Of (Number) + 3) mod Trace_Slots.Capacity);
      end if;
   end Put;

end Trace.Rings;
