--  SPDX-License-Identifier: GPL-3.0-or-later
--  The file of a trace: the text at its beginning, the events after it, and
--  which events are saved, skipped and kept.

with Interfaces; use Interfaces;
with Schedule;   use Schedule;
with Texts;
with Trace_Json;
with Trace_Slots;

package Trace_Layout with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Trace_Layout);

   use type Trace_Json.Event;

   subtype Event_Number is Trace_Slots.Event_Number;

   In_Memory : constant := Trace_Slots.Capacity;

   Capacity : constant := 2 ** 17;
   --  Newest events kept in the file

   Text_Limit : constant := Capacity * (Texts.Max_Length + 32);
   --  Bytes before the events. The text never reaches them, as an event's is
   --  Texts.Max_Length at most; the gap is a hole in the file

   --  An event in the file

   type Saved_Event is record
      Mark    : Unsigned_64 := 0;     --  event number + 1; 0: none
      At_Time : Unsigned_64 := 0;
      Number  : Unsigned_64 := 0;
      Who     : Unsigned_8  := 0;
      Kind    : Unsigned_8  := 0;
      Label   : Trace_Json.Label_Text := (others => ' ');
   end record
   with Size => 32 * 8;
   --  Each pattern of bits is a value: nothing is assumed of what is read

   Event_Bytes : constant := 32;

   function Holds (Item : Saved_Event; Number : Event_Number) return Boolean
   is
     (Item.Mark = Number + 1
      and then Item.Who <= Task_Name'Pos (Task_Name'Last)
      and then Item.Kind <=
        Trace_Json.Event_Kind'Pos (Trace_Json.Event_Kind'Last));
   --  Whether Item is event Number

   function Event_Of (Item : Saved_Event; Number : Event_Number)
     return Trace_Json.Event
   is
     ((At_Time => Item.At_Time,
       Number  => Item.Number,
       Who     => Task_Name'Val (Item.Who),
       Kind    => Trace_Json.Event_Kind'Val (Item.Kind),
       Label   => Item.Label))
   with Pre => Holds (Item, Number);

   function To_Saved (Number : Event_Number; Item : Trace_Json.Event)
     return Saved_Event
   is
     ((Mark    => Number + 1,
       At_Time => Item.At_Time,
       Number  => Item.Number,
       Who     => Task_Name'Pos (Item.Who),
       Kind    => Trace_Json.Event_Kind'Pos (Item.Kind),
       Label   => Item.Label))
   with
     Post => Holds (To_Saved'Result, Number)
       and then Event_Of (To_Saved'Result, Number) = Item;

   No_Event : constant Saved_Event := (others => <>);
   --  Of a lost event

   --  Places

   subtype Event_Place is Natural range 0 .. Capacity - 1;

   function Place_Of (Number : Event_Number) return Event_Place is
     (Event_Place (Number mod Capacity));

   subtype File_Offset is Natural;

   function Offset_Of (Place : Event_Place) return File_Offset is
     (Text_Limit + Place * Event_Bytes)
   with Post => Offset_Of'Result in Text_Limit ..
     Text_Limit + (Capacity - 1) * Event_Bytes;

   --  Events are saved, and read again, in batches

   Batch_Length : constant := 512;

   subtype Batch_Count is Natural range 0 .. Batch_Length;
   subtype Batch_Index is Batch_Count range 0 .. Batch_Length - 1;

   type Batch is array (Batch_Index) of Saved_Event
   with Component_Size => Event_Bytes * 8;

   Batch_Bytes : constant := Batch_Length * Event_Bytes;

   function Batch_Start (Number : Event_Number) return Event_Number is
     (Number - Number mod Batch_Length)
   with Post => Batch_Start'Result <= Number
     and then Number - Batch_Start'Result < Batch_Length
     and then Place_Of (Batch_Start'Result) <= Capacity - Batch_Length;
   --  First event of the batch in which Number is read

   --  Last: number of events recorded so far, one more than the last one's

   function First_To_Save (Saved, Last : Event_Number) return Event_Number is
     (if Last > In_Memory then Event_Number'Max (Saved, Last - In_Memory)
      else Saved)
   with Post => First_To_Save'Result >= Saved;
   --  The events below Saved are in the file, except skipped ones. Those
   --  between it and the result are skipped: they are overwritten

   function Run_Length (First, Last : Event_Number) return Batch_Count is
     (if First >= Last then 0
      else Natural
        (Event_Number'Min
           (Last - First,
            Event_Number'Min
              (Batch_Length, Capacity - First mod Capacity))))
   with
     Post =>
       (if First >= Last then Run_Length'Result = 0
        else Run_Length'Result > 0
          and then Unsigned_64 (Run_Length'Result) <= Last - First
          and then Place_Of (First) + Run_Length'Result <= Capacity);
   --  Number of events from First that are saved at once: one behind the
   --  other in the file

   function May_Come (Number, Last : Event_Number) return Boolean is
     (Number < Last and then Last - Number <= In_Memory / 2);
   --  Whether event Number, which is not in the ring, may still be there
   --  later, as its writer is not slow. Otherwise it is lost

   function Oldest_Kept (Last : Event_Number) return Event_Number is
     (if Last > Capacity then Last - Capacity else 0)
   with Post => Oldest_Kept'Result <= Last
     and then Last - Oldest_Kept'Result <= Capacity;

end Trace_Layout;
