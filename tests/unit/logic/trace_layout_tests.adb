--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;       use Interfaces;

with AUnit.Assertions; use AUnit.Assertions;

with Schedule;
with Trace_Json;       use Trace_Json;
with Trace_Layout;     use Trace_Layout;
with Trace_Slots;      use Trace_Slots;
with Unit_Runs; use Unit_Runs;

package body Trace_Layout_Tests is

   subtype Number_Type is Trace_Slots.Event_Number;

   procedure Test_Foreign_Record is
      Item : Saved_Event := To_Saved (7, (others => <>));
   begin
      Item.Who := Schedule.Task_Name'Pos (Schedule.Task_Name'Last) + 1;
      Assert (not Holds (Item, 7), "no task");
      Item.Who := 0;
      Assert (Holds (Item, 7), "the first task");
      Item.Kind := Event_Kind'Pos (Event_Kind'Last) + 1;
      Assert (not Holds (Item, 7), "no kind");
   end Test_Foreign_Record;

   procedure Test_Lost is
      In_Ring : constant Number_Type := In_Memory;
      In_File : constant Number_Type := Trace_Layout.Capacity;
   begin
      Assert (First_To_Save (5, 10) = 5, "all");
      Assert (First_To_Save (5, 5 + In_Ring) = 5, "all of a full ring");
      Assert (First_To_Save (5, 6 + In_Ring) = 6, "one is overwritten");
      Assert (First_To_Save (5, 100 + 2 * In_Ring) = 100 + In_Ring, "most");
      Assert (not May_Come (10, 10), "not yet claimed");
      Assert (May_Come (9, 10), "the newest");
      Assert (May_Come (9, 9 + In_Ring / 2), "half a ring old");
      Assert (not May_Come (9, 10 + In_Ring / 2), "older than that");
      Assert (Oldest_Kept (0) = 0 and then Oldest_Kept (In_File) = 0, "all");
      Assert (Oldest_Kept (In_File + 3) = 3, "three more");
   end Test_Lost;

   procedure Test_Places is
      Size : constant := 76 * 2 ** 20;
   begin
      Assert (Offset_Of (Place_Of (0)) = Text_Limit, "the first");
      Assert
        (Offset_Of (Place_Of (1)) = Text_Limit + Event_Bytes, "the second");
      Assert (Place_Of (Trace_Layout.Capacity) = 0, "the next round");
      Assert
        (Offset_Of (Place_Of (Trace_Layout.Capacity - 1)) < Size,
         "the size of the file");
      Assert
        (Batch_Start (0) = 0 and then Batch_Start (Batch_Length - 1) = 0
         and then Batch_Start (Batch_Length) = Batch_Length,
         "the start of a batch");
   end Test_Places;

   procedure Test_Record is
   begin
      for Who in Schedule.Task_Name loop
         for Kind in Event_Kind loop
            declare
               Item   : constant Event :=
                 (At_Time => Unsigned_64'Last - Event_Kind'Pos (Kind),
                  Number  => 2 ** 63 + Schedule.Task_Name'Pos (Who),
                  Who     => Who,
                  Kind    => Kind,
                  Label   => "ab" & ASCII.NUL & "cd" & Character'Last);
               Saved  : constant Saved_Event := To_Saved (77, Item);
            begin
               Assert (Holds (Saved, 77), "not there");
               Assert (not Holds (Saved, 78), "another");
               Assert (Event_Of (Saved, 77) = Item, "changed");
            end;
         end loop;
      end loop;
      Assert (not Holds (No_Event, 0), "an event where none is");
   end Test_Record;

   procedure Test_Runs is
      Round : constant Number_Type := Trace_Layout.Capacity;
   begin
      Assert (Run_Length (0, 0) = 0, "nothing");
      Assert (Run_Length (9, 3) = 0, "less than nothing");
      Assert (Run_Length (3, 9) = 6, "a few");
      Assert (Run_Length (3, 9_999) = Batch_Length, "a batch");
      Assert (Run_Length (Round - 5, Round + 9) = 5, "the end of a round");
      Assert (Run_Length (Round, Round + 9) = 9, "the next round");
   end Test_Runs;

   procedure Test_Slots is
      Round : constant Number_Type := Trace_Slots.Capacity;
   begin
      Assert (May_Write (Empty, 0), "an empty slot");
      Assert (Expected (5) = Empty, "the first round");
      Assert (Expected (Round) = Complete (0), "the second round");
      Assert (May_Write (Complete (5), Round + 5), "an event a round older");
      Assert (not May_Write (Complete (Round + 5), 5), "a newer event");
      Assert (not May_Write (Complete (5), 5), "the same event");
      Assert
        (not May_Write (Being_Written (5), Round + 5),
         "an event that is being written");
      Assert
        (not May_Write (Being_Written (Number_Type'Last), Number_Type'Last)
         and then Complete (Number_Type'Last) >
           Being_Written (Number_Type'Last),
         "the last number");
      Assert
        (Slot_Of (0) = 0 and then Slot_Of (Round + 1) = 1
         and then Slot_Of (Round - 1) = Slot_Index'Last,
         "the slot");
   end Test_Slots;

   procedure Add_Tests is
   begin
      Add_Test ("who may write a slot", Test_Slots'Access);
      Add_Test ("an event in the file", Test_Record'Access);
      Add_Test ("what another has written there", Test_Foreign_Record'Access);
      Add_Test ("places in the file", Test_Places'Access);
      Add_Test ("what is saved at once", Test_Runs'Access);
      Add_Test ("skipped, lost and kept", Test_Lost'Access);
   end Add_Tests;

end Trace_Layout_Tests;
