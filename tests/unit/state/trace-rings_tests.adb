--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ring of a trace: the newest events, and none that is mixed from two.

with Ada.Calendar;
with Ada.Directories;
with Ada.Real_Time;
with Interfaces;              use Interfaces;
with System.Storage_Elements; use System.Storage_Elements;

with AUnit.Assertions;        use AUnit.Assertions;

with Programs;
with Schedule;                use Schedule;
with Texts;
with Trace.Rings;             use Trace.Rings;
with Trace_Files;
with Trace_Json;              use Trace_Json;

package body Trace.Rings_Tests is

   use type Trace_Files.Nanoseconds;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Capacity : constant := 8;
   --  so small that writers come round all the time

   type Memory is array (1 .. Capacity * Slot_Bytes / 8) of Unsigned_64;

   function Marked (Value : Unsigned_64) return Event is
     (At_Time => Value,
      Number  => not Value,
      Who     => Task_Name'Val (Value mod 21),
      Kind    => Event_Kind'Val (Value mod 12),
      Label   => (others => Character'Val (Value mod 251)));
   --  All of it depends on Value

   procedure Put (R : in out Ring; Item : Event);

   procedure Test_Round (T : in out Any_Test);
   procedure Test_Together (T : in out Any_Test);
   procedure Test_Overtaken (T : in out Any_Test);
   procedure Test_File (T : in out Any_Test);

   procedure Put (R : in out Ring; Item : Event) is
      Unused : Unsigned_64;
   begin
      Put (R, Item, Unused);
   end Put;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Trace.Rings"));

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Round'Access, "the newest are kept");
      Register_Routine
        (T, Test_Together'Access, "many writers, and a reader at once");
      Register_Routine
        (T, Test_Overtaken'Access, "a writer that is overtaken");
      Register_Routine
        (T, Test_File'Access, "more than is kept, in time, in the file");
   end Register_Tests;

   procedure Test_File (T : in out Any_Test) is
      use type Ada.Calendar.Time;
      pragma Unreferenced (T);
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

   procedure Test_Overtaken (T : in out Any_Test) is
      pragma Unreferenced (T);
      Words : constant := Slot_Bytes / 8;
      Here  : constant := 3;   --  a slot
      Where : Memory := (others => 0);
      R     : Ring;
      Item  : Event;
      Found : Boolean;
      State : Unsigned_64 renames Where (Here * Words + 1);

      procedure Put_Round (First : Unsigned_64);

      procedure Expect (Number : Unsigned_64; Is_There : Boolean);

      procedure Put_Round (First : Unsigned_64) is
      begin
         for Number in First .. First + Capacity - 1 loop
            Put (R, Marked (Number));
         end loop;
      end Put_Round;

      procedure Expect (Number : Unsigned_64; Is_There : Boolean) is
      begin
         Get (R, Number, Item, Found);
         Assert (Found = Is_There, "event" & Number'Image);
         Assert (not Found or else Item = Marked (Number), "mixed");
      end Expect;

   begin
      Set_Up (R, Where'Address, Capacity);
      Put_Round (0);
      --  event 3 is still being written
      State := 2 * Here + 1;
      Expect (Here, False);
      declare
         Before : constant Memory := Where;
      begin
         Put_Round (Capacity);
         Assert
           ((for all I in Here * Words + 1 .. (Here + 1) * Words =>
               Where (I) = Before (I)),
            "written by two");
      end;
      for Number in Unsigned_64 range Capacity .. 2 * Capacity - 1 loop
         Expect (Number, Number /= Here + Capacity);
      end loop;
      State := 2 * Here + 2;
      Put_Round (2 * Capacity);
      Expect (Here + 2 * Capacity, True);
      --  a late reader does not change a newer one
      State := 2 * (Here + 100 * Capacity) + 2;
      Put_Round (3 * Capacity);
      Expect (Here + 3 * Capacity, False);
      Assert (State = 2 * (Here + 100 * Capacity) + 2, "the newer is gone");
   end Test_Overtaken;

   procedure Test_Round (T : in out Any_Test) is
      pragma Unreferenced (T);
      Where : Memory := (others => 0);
      R      : Ring;
      Item   : Event;
      Found  : Boolean;
      Number : Unsigned_64;
   begin
      Set_Up (R, Where'Address, Capacity);
      Get (R, 0, Item, Found);
      Assert (not Found, "an event in an empty ring");
      for Put_So_Far in Unsigned_64 range 1 .. 3 * Capacity + 2 loop
         Put (R, Marked (100 + Put_So_Far - 1), Number);
         Assert (Number = Put_So_Far - 1, "number" & Number'Image);
         Assert (Count (R) = Put_So_Far, "count" & Count (R)'Image);
         for Number in Unsigned_64 range 0 .. Put_So_Far + Capacity loop
            Get (R, Number, Item, Found);
            Assert
              (Found = (Number < Put_So_Far
                        and then Number + Capacity >= Put_So_Far),
               "event" & Number'Image & " of" & Put_So_Far'Image);
            Assert
              (not Found or else Item = Marked (100 + Number),
               "another than event" & Number'Image);
         end loop;
      end loop;
   end Test_Round;

   procedure Test_Together (T : in out Any_Test) is
      pragma Unreferenced (T);
      Writers : constant := 4;
      Each    : constant := 1_000_000;
      Where   : array (1 .. Memory'Length + 8) of Unsigned_64 :=
        (others => 0);
      R       : Ring;
      Seen    : Natural := 0;
      Mixed   : Natural := 0;
      Kept    : Natural := 0;

      procedure Look (Number : Unsigned_64);

      procedure Look (Number : Unsigned_64) is
         Item  : Event;
         Found : Boolean;
      begin
         Get (R, Number, Item, Found);
         if Found then
            Seen := Seen + 1;
            if Item /= Marked (Item.At_Time) then
               Mixed := Mixed + 1;
            end if;
         end if;
      end Look;

   begin
      --  so that every second slot lies in two lines of the cache: what is
      --  half written is seen half written
      for I in 1 .. 8 loop
         if To_Integer (Where (I)'Address) mod 64 = 16 then
            Set_Up (R, Where (I)'Address, Capacity);
         end if;
      end loop;
      declare
         task type Writer (Number : Integer);

         task body Writer is
         begin
            for I in Unsigned_64 range 1 .. Each loop
               Put (R, Marked (Unsigned_64 (Number) * 2 ** 32 + I));
            end loop;
         end Writer;

         One   : Writer (1);
         Two   : Writer (2);
         Three : Writer (3);
         Four  : Writer (4);
         pragma Unreferenced (One, Two, Three, Four);
      begin
         while Count (R) < Writers * Each loop
            for Back in Unsigned_64 range 1 .. Capacity loop
               if Count (R) > Back then
                  Look (Count (R) - Back);
               end if;
            end loop;
         end loop;
      end;
      Assert (Count (R) = Writers * Each, "count" & Count (R)'Image);
      Assert (Seen > 1_000, "the reader saw" & Seen'Image);
      Kept := Seen;
      for Back in Unsigned_64 range 1 .. Capacity loop
         Look (Count (R) - Back);
      end loop;
      Kept := Seen - Kept;
      Assert (Mixed = 0, Mixed'Image & " events mixed of" & Seen'Image);
      Assert (Kept > 0, "nothing is kept");
   end Test_Together;

end Trace.Rings_Tests;
