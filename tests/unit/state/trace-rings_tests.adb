--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ring of a trace: the newest events, and none that is mixed from two.

with Ada.Calendar;
with Ada.Directories;
with Ada.Real_Time;
with Interfaces;       use Interfaces;

with AUnit.Assertions; use AUnit.Assertions;

with Programs;
with Schedule;         use Schedule;
with Texts;
with Trace.Ring_Memory;
with Trace.Rings;      use Trace.Rings;
with Trace_Files;
with Trace_Json;       use Trace_Json;
with Trace_Slots;      use Trace_Slots;
with Unit_Runs; use Unit_Runs;

package body Trace.Rings_Tests is

   use type Trace_Files.Nanoseconds;

   Capacity : constant := Trace_Slots.Capacity;

   function Marked (Value : Unsigned_64) return Event is
     (At_Time => Value,
      Number  => not Value,
      Who     => Task_Name'Val (Value mod 22),
      Kind    => Event_Kind'Val (Value mod 12),
      Label   => (others => Character'Val (Value mod 251)));
   --  All of it depends on Value

   procedure Put (Item : Event) is
      Unused : Event_Number;
   begin
      Put (Item, Unused);
   end Put;

   procedure Test_File is
      use type Ada.Calendar.Time;
      Path    : constant String :=
        Programs.Temporary_Folder & "/trace.json";
      More    : constant := 6_001;
      Burst   : constant := Trace.Capacity;
      Lost    : constant := 300;
      --  From event Burst on, as many more than are kept in memory
      Kept    : constant := Trace.Capacity - Lost;
      Begun   : Ada.Calendar.Time;
      Success : Boolean;
      Reason  : Texts.Text;
      Result  : Trace_Files.Trace;
      Starts  : Natural := 0;
      Sent    : Natural := 0;
   begin
      Trace.Open (Texts.To_Text (Path), Success, Reason);
      Assert (Success, Texts.Image (Reason));
      Trace.Release (Th_Move, 5);
      for I in 4 .. Trace.Capacity + More - 1 loop
         --  what lasts past the first events that are kept, begins in those
         --  that are not
         if I mod 3 = 0 then
            Trace.Start (Th_Move);
         elsif I mod 3 = 1 then
            Trace.Wait (Th_Move, Trace.Line);
         else
            Trace.Done (Th_Move);
         end if;
         if (I <= Burst and then (I = Burst or else I mod 1_000 = 0))
           or else I = Burst + Trace.In_Memory + Lost
         then
            Trace.Wake;
            Trace.Store;
         end if;
      end loop;
      Trace.Resume (Th_Move, Ada.Real_Time.Time_First);
      Trace.Sent ("AACK");
      Begun := Ada.Calendar.Clock;
      Trace.Finish (Success, Reason);
      --  with contracts on and other load it may be too slow; the file is
      --  valid nevertheless
      Assert (Success or else Texts.Image (Reason) = "it takes too long",
              Texts.Image (Reason));
      Assert (Ada.Calendar.Clock - Begun < 20.0,
              Duration'Image (Ada.Calendar.Clock - Begun) & " s");
      Trace_Files.Read (Path, Result);
      Assert (Result.Recorded = Trace.Capacity + More, "recorded");
      Assert (Result.Kept = Kept, "kept" & Result.Kept'Image);
      for Item of Result.Events loop
         Assert (Trace_Files.Name (Item) /= "release", "the oldest is kept");
         Assert (Item.Time < 1_000_000_000_000, "a time of long ago");
         if Trace_Files.Name (Item) = "job" then
            Starts := Starts + 1;
         elsif Trace_Files.Name (Item) = "out AACK" then
            Sent := Sent + 1;
         end if;
      end loop;
      Assert
        (Starts <= Kept / 3 + 1
         and then (Starts >= Kept / 3 - 1 or else not Success),
         Starts'Image & " jobs");
      Assert
        (Sent = (if Success then 1 else 0), "the newest is missing");
      Programs.Remove_Temporary_Folder;
      --  it is over
      Trace.Start (Th_Move);
      Trace.Finish (Success, Reason);
      Assert (Success and then not Ada.Directories.Exists (Path), "again");
   end Test_File;

   procedure Test_Overtaken is
      Here  : constant := 3;   --  an event, and its slot
      Item  : Event;
      Found : Boolean;
      State : Slot_State;

      procedure Put_Round (First : Event_Number) is
      begin
         for Number in First .. First + Capacity - 1 loop
            Put (Marked (Number));
         end loop;
      end Put_Round;

      procedure Expect (Number : Event_Number; Is_There : Boolean) is
      begin
         Get (Number, Item, Found);
         Assert (Found = Is_There, "event" & Number'Image);
         Assert (not Found or else Item = Marked (Number), "mixed");
      end Expect;

      procedure Take (Before, After : Slot_State) is
         --  As the writer of event Here does
      begin
         Ring_Memory.Change (Here, Before, After, State);
         Assert (State = Before, "state" & State'Image);
      end Take;

      After : Slot_State;
   begin
      Ring_Memory.Reset;
      Put_Round (0);
      --  event 3 is still being written
      Take (Complete (Here), Being_Written (Here));
      Expect (Here, False);
      Put_Round (Capacity);
      Ring_Memory.Read (Here, State, After, Item);
      Assert
        (State = Being_Written (Here) and then After = State
         and then Item = Marked (Here),
         "written by two");
      for Number in Event_Number range Capacity .. 2 * Capacity - 1 loop
         Expect (Number, Number /= Here + Capacity);
      end loop;
      Take (Being_Written (Here), Complete (Here));
      --  the next writer finds an event older than a round
      Put_Round (2 * Capacity);
      Expect (Here + 2 * Capacity, True);
      --  a late writer does not change a newer one
      Take (Complete (Here + 2 * Capacity), Complete (Here + 100 * Capacity));
      Put_Round (3 * Capacity);
      Expect (Here + 3 * Capacity, False);
      Ring_Memory.Read (Here, State, After, Item);
      Assert
        (State = Complete (Here + 100 * Capacity)
         and then Item = Marked (Here + 2 * Capacity),
         "the newer is gone");
   end Test_Overtaken;

   procedure Test_Round is
      Item   : Event;
      Found  : Boolean;
      Number : Event_Number;
      Count  : Event_Number;

      procedure Look (Number, Put_So_Far : Event_Number) is
      begin
         Get (Number, Item, Found);
         Assert
           (Found = (Number < Put_So_Far
                     and then Number + Capacity >= Put_So_Far),
            "event" & Number'Image & " of" & Put_So_Far'Image);
         Assert
           (not Found or else Item = Marked (100 + Number),
            "another than event" & Number'Image);
      end Look;

   begin
      Ring_Memory.Reset;
      Get (0, Item, Found);
      Assert (not Found, "an event in an empty ring");
      for Put_So_Far in Event_Number range 1 .. 3 * Capacity + 2 loop
         Put (Marked (100 + Put_So_Far - 1), Number);
         Assert (Number = Put_So_Far - 1, "number" & Number'Image);
         Get_Count (Count);
         Assert (Count = Put_So_Far, "count" & Count'Image);
         if Put_So_Far mod 500 = 0 or else Put_So_Far mod Capacity <= 2
         then
            for Number in Event_Number range 0 .. Put_So_Far + Capacity loop
               Look (Number, Put_So_Far);
            end loop;
         end if;
      end loop;
   end Test_Round;

   procedure Test_Together is
      Writers : constant := 4;
      Each    : constant := 1_000_000;
      Near    : constant := 2;
      Seen    : Natural := 0;
      Mixed   : Natural := 0;
      Kept    : Natural := 0;
      Count   : Event_Number := 0;

      procedure Look (Back : Event_Number) is
         --  At event Count - Back
         Item  : Event;
         Found : Boolean;
      begin
         if Count > Back then
            Get (Count - Back, Item, Found);
            if Found then
               Seen := Seen + 1;
               if Item /= Marked (Item.At_Time) then
                  Mixed := Mixed + 1;
               end if;
            end if;
         end if;
      end Look;

      procedure Look_At_Both_Ends is
         --  At the newest events, and at the oldest, which are overwritten
         --  next
      begin
         for Back in Event_Number range 1 .. Near loop
            Get_Count (Count);
            Look (Back);
            Get_Count (Count);
            Look (Capacity - Back);
         end loop;
      end Look_At_Both_Ends;

   begin
      Ring_Memory.Reset;
      declare
         task type Writer (Number : Integer);

         task body Writer is
         begin
            for I in Unsigned_64 range 1 .. Each loop
               Put (Marked (Unsigned_64 (Number) * 2 ** 32 + I));
            end loop;
         end Writer;

         One   : Writer (1);
         Two   : Writer (2);
         Three : Writer (3);
         Four  : Writer (4);
         pragma Unreferenced (One, Two, Three, Four);
      begin
         while Count < Writers * Each loop
            Look_At_Both_Ends;
         end loop;
      end;
      Assert (Count = Writers * Each, "count" & Count'Image);
      Assert (Seen > 1_000, "the reader saw" & Seen'Image);
      Kept := Seen;
      Look_At_Both_Ends;
      Kept := Seen - Kept;
      Assert (Mixed = 0, Mixed'Image & " events mixed of" & Seen'Image);
      Assert (Kept > 0, "nothing is kept");
   end Test_Together;

   procedure Add_Tests is
   begin
      Add_Test ("the newest are kept", Test_Round'Access);
      Add_Test ("many writers, and a reader at once", Test_Together'Access);
      Add_Test ("a writer that is overtaken", Test_Overtaken'Access);
      Add_Test ("more than is kept, in time, in the file", Test_File'Access);
   end Add_Tests;

end Trace.Rings_Tests;
