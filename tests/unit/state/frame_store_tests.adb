--  SPDX-License-Identifier: GPL-3.0-or-later
--  The frame slots: who holds which, and that the newest image wins.

with Ada.Real_Time;    use Ada.Real_Time;

with AUnit.Assertions; use AUnit.Assertions;

with Schedule;
with Vision.Frame_Slots;
with Vision.Frame_Store;
with Vision.Image_Grid;
with Unit_Runs; use Unit_Runs;

procedure Frame_Store_Tests is

   use type Vision.Frame_Slots.Slot;
   use type Vision.Image_Grid.Microseconds;

   Period : constant := 100_000;

   procedure Begin_Anew is
      --  A camera has been opened.
   begin
      for Slot in Vision.Frame_Slots.Slot loop
         Vision.Frame_Store.Store.Release (Slot);
      end loop;
      Vision.Frame_Store.Store.Begin_Delivery (Clock);
   end Begin_Anew;

   procedure Check_Newest (Expected : Vision.Frame_Slots.Slot) is
      --  Expected holds the newest image; it is released again.
      Taken : Vision.Frame_Slots.Slot;
      Found : Boolean;
   begin
      Vision.Frame_Store.Store.Claim_Newest (Taken, Found);
      Assert (Found, "an image waits");
      Assert (Taken = Expected,
              Expected'Image & " expected, not" & Taken'Image);
      Vision.Frame_Store.Store.Release (Taken);
   end Check_Newest;

   procedure Check_None is
      --  No image waits.
      Taken : Vision.Frame_Slots.Slot;
      Found : Boolean;
   begin
      Vision.Frame_Store.Store.Claim_Newest (Taken, Found);
      Assert (not Found, "no image expected, not" & Taken'Image);
   end Check_None;

   procedure Claim_Due
     (Now     : Time;
      Slot    : out Vision.Frame_Slots.Slot;
      At_Time : out Time;
      Reserve : out Boolean)
   is
      --  What is sent at Now; it is released again
      Found, Coming : Boolean;
   begin
      Vision.Frame_Store.Store.Claim_Due
        (Now, Period, Slot, At_Time, Reserve, Found, Coming);
      Assert (Found and then Coming, "an image is due");
      Vision.Frame_Store.Store.Release (Slot);
   end Claim_Due;

   procedure Put (At_Time : Time; Slot : out Vision.Frame_Slots.Slot) is
      --  An image comes
   begin
      Vision.Frame_Store.Store.Claim_Empty (Slot);
      Vision.Frame_Store.Publish (Slot, At_Time);
   end Put;

   procedure Test_Always_Free is
      type Slot_Set is array (Vision.Frame_Slots.Slot) of Boolean;
      Held  : Slot_Set := (others => False);
      Slot  : Vision.Frame_Slots.Slot;
      Found : Boolean;
   begin
      Begin_Anew;

      --  two readers hold one each, one is the newest

      for Reader in 1 .. 2 loop
         Vision.Frame_Store.Store.Claim_Empty (Slot);
         Assert (not Held (Slot), "free");
         Vision.Frame_Store.Publish (Slot, Clock);
         Vision.Frame_Store.Store.Claim_Newest (Slot, Found);
         Assert (Found, "for reader" & Reader'Image);
         Held (Slot) := True;
      end loop;
      Vision.Frame_Store.Store.Claim_Empty (Slot);
      Assert (not Held (Slot), "one for the newest");
      Vision.Frame_Store.Publish (Slot, Clock);
      Held (Slot) := True;
      Vision.Frame_Store.Store.Claim_Empty (Slot);
      Assert (not Held (Slot), "one for the image after it");
      Vision.Frame_Store.Publish (Slot, Clock);
      Held (Slot) := True;

      --  and the owner claims the others

      for I in 5 .. Held'Length loop
         Vision.Frame_Store.Store.Claim_Empty (Slot);
         Assert (not Held (Slot), "slot" & I'Image & " of all");
         Held (Slot) := True;
      end loop;
      Assert (Held = (Held'Range => True), "all slots are in use");
      Vision.Frame_Store.Store.Claim_Newest (Slot, Found);
      Assert (Found, "the newest waits still");
   end Test_Always_Free;

   procedure Test_End is
      Slot  : Vision.Frame_Slots.Slot;
      Found : Boolean;
   begin
      Begin_Anew;
      Put (Clock, Slot);
      Vision.Frame_Store.End_Delivery;
      Check_None;
      Vision.Frame_Store.Wait_Newest (Slot, Found);
      Assert (not Found, "nobody waits for what does not come");

      --  an image that the owner was just taking is too late

      Put (Clock, Slot);
      Check_None;

      --  and a camera that is opened again begins with nothing

      Vision.Frame_Store.Store.Begin_Delivery (Clock);
      Check_None;
      Put (Clock, Slot);
      Vision.Frame_Store.Wait_Newest (Slot, Found);
      Assert (Found, "the first image of the new delivery");
      Vision.Frame_Store.Store.Release (Slot);
   end Test_End;

   procedure Test_In_Turn is
      Held, Slot, Last : Vision.Frame_Slots.Slot;

      function Next
        (After : Vision.Frame_Slots.Slot) return Vision.Frame_Slots.Slot is
        (if After = Vision.Frame_Slots.Slot'Last
         then Vision.Frame_Slots.Slot'First
         else After + 1);
   begin
      Begin_Anew;
      Vision.Frame_Store.Store.Claim_Empty (Held);
      Last := Held;
      for Image in 1 .. 3 * Vision.Frame_Slots.Slot'Range_Length loop
         Put (Clock, Slot);
         Last := Next (Last);
         if Last = Held then
            Last := Next (Last);
         end if;
         Assert (Slot = Last, "the next free one, not" & Slot'Image);
      end loop;
   end Test_In_Turn;

   procedure Test_Elapsed is
      Begun : constant Time := Clock;
   begin
      Assert (Vision.Image_Grid.Elapsed (Begun, Begun) = 0, "none");
      Assert (Vision.Image_Grid.Elapsed (Begun, Begun + Microseconds (1)) = 1,
                   "a microsecond");
      Assert (Vision.Image_Grid.Elapsed (Begun + Seconds (1), Begun) = 0,
              "none that is negative");
      Assert (Vision.Image_Grid.Elapsed (Begun, Begun + Seconds (5_000))
                = Vision.Image_Grid.Microseconds'Last, "more than there is");
   end Test_Elapsed;

   procedure Test_Reserve is
      Begun                : constant Time := Clock;
      First, Second, Third : Vision.Frame_Slots.Slot;
      Slot                 : Vision.Frame_Slots.Slot;
      At_Time              : Time;
      Reserve              : Boolean;
   begin
      Begin_Anew;
      Put (Begun, First);
      Claim_Due (Begun + Milliseconds (50), Slot, At_Time, Reserve);
      Assert (Slot = First and then At_Time = Begun and then not Reserve,
              "one that waits alone");
      Check_None;

      --  the second has just come

      Put (Begun + Milliseconds (100), First);
      Put (Begun + Milliseconds (195), Second);
      Claim_Due (Begun + Milliseconds (200), Slot, At_Time, Reserve);
      Assert (Slot = First and then Reserve
              and then At_Time = Begun + Milliseconds (100), "the older one");
      Claim_Due (Begun + Milliseconds (300), Slot, At_Time, Reserve);
      Assert (Slot = Second and then not Reserve
              and then At_Time = Begun + Milliseconds (195), "the reserve");
      Check_None;

      --  the second has been there for a while: the first is left out

      Put (Begun + Milliseconds (300), First);
      Put (Begun + Milliseconds (380), Second);
      Claim_Due (Begun + Milliseconds (400), Slot, At_Time, Reserve);
      Assert (Slot = Second and then not Reserve, "the newer one");
      Check_None;

      --  of three the oldest is left out in any case

      Put (Begun + Milliseconds (400), Slot);
      Put (Begun + Milliseconds (448), Second);
      Put (Begun + Milliseconds (499), Third);
      Claim_Due (Begun + Milliseconds (500), Slot, At_Time, Reserve);
      Assert (Slot = Second and then Reserve, "the second of three");
      Check_Newest (Third);

      --  the third has just come, but a fourth will come in time

      Put (Begun + Milliseconds (549), Second);
      Put (Begun + Milliseconds (599), Third);
      Claim_Due (Begun + Milliseconds (600), Slot, At_Time, Reserve);
      Assert (Slot = Third and then not Reserve, "of a fast source");
      Check_None;
   end Test_Reserve;

   procedure Test_Wait is
      Begun   : constant Time := Clock;
      Slot    : Vision.Frame_Slots.Slot;
      At_Time : Time;
      Reserve : Boolean;
      Found   : Boolean;
      Coming  : Boolean;

      procedure Begin_Wait (Expected : Boolean) is
         --  Nothing is due; Expected: something is still to come
      begin
         Vision.Frame_Store.Store.Claim_Due
           (Begun, Period, Slot, At_Time, Reserve, Found, Coming);
         Assert (not Found, "nothing is due");
         Assert (Coming = Expected, "coming: " & Coming'Image);
      end Begin_Wait;

   begin
      --  each Wait_Look returns, or the test does not end

      Begin_Anew;
      Vision.Frame_Store.Store.Begin_Delivery (Begun);
      Begin_Wait (Expected => True);
      Put (Begun, Slot);
      Vision.Frame_Store.Wait_Look;
      Claim_Due (Begun, Slot, At_Time, Reserve);

      Begin_Wait (Expected => True);
      Vision.Frame_Store.Look_At_Silence (Begun + Milliseconds (2_000));
      Vision.Frame_Store.Look_At_Silence (Begun + Milliseconds (2_600));
      Vision.Frame_Store.Wait_Look;

      Begin_Wait (Expected => True);
      Vision.Frame_Store.End_Delivery;
      Vision.Frame_Store.Wait_Look;
      Begin_Wait (Expected => False);
   end Test_Wait;

   procedure Test_Times is
      Begun : constant Time := Clock;
      Later : constant Time := Begun + Milliseconds (40);
      Slot  : Vision.Frame_Slots.Slot;

      procedure Check (From : Time; What : String) is
         --  The time of silence counts from From
         Silent : Boolean;
      begin
         Vision.Frame_Store.Store.Get_Silent
           (From + Schedule.Camera_Silence, Silent);
         Assert (not Silent, What & ": too early");
         Vision.Frame_Store.Store.Get_Silent
           (From + Schedule.Camera_Silence + Milliseconds (1), Silent);
         Assert (Silent, What & ": too late");
      end Check;
   begin
      Begin_Anew;
      Vision.Frame_Store.Store.Begin_Delivery (Begun);
      Check (Begun, "the beginning");
      Put (Later, Slot);
      Check (Later, "the image");
      Vision.Frame_Store.End_Delivery;
      Put (Later + Milliseconds (40), Slot);
      Check (Later, "none that is too late");
   end Test_Times;

begin
   Run_Test ("an empty slot beside owner, two that wait, readers",
             Test_Always_Free'Access);
   Run_Test ("a delivery that ends drops what waits", Test_End'Access);
   Run_Test ("every slot in its turn", Test_In_Turn'Access);
   Run_Test ("when the last image came", Test_Times'Access);
   Run_Test ("what has just come is kept in reserve", Test_Reserve'Access);
   Run_Test ("who waits for an image is told of what ends it",
             Test_Wait'Access);
   Run_Test ("times between images", Test_Elapsed'Access);
end Frame_Store_Tests;
