--  SPDX-License-Identifier: GPL-3.0-or-later
--  The frame slots: who holds which, and that the newest image wins.

with Ada.Real_Time;    use Ada.Real_Time;

with AUnit.Assertions; use AUnit.Assertions;

with Frame_Slots;
with Frame_Store;

package body Frame_Store_Tests is

   use type Frame_Slots.Slot;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   procedure Begin_Anew;
   --  A camera has been opened.

   procedure Check_Newest (Expected : Frame_Slots.Slot);
   --  Expected holds the newest image; it is released again.

   procedure Check_None;
   --  No image waits.

   procedure Test_Newest (T : in out Any_Test);
   procedure Test_Once (T : in out Any_Test);
   procedure Test_Always_Free (T : in out Any_Test);
   procedure Test_End (T : in out Any_Test);
   procedure Test_In_Turn (T : in out Any_Test);
   procedure Test_Times (T : in out Any_Test);

   ----------------
   -- Begin_Anew --
   ----------------

   procedure Begin_Anew is
   begin
      for Slot in Frame_Slots.Slot loop
         Frame_Store.Release (Slot);
      end loop;
      Frame_Store.Begin_Delivery (Clock);
   end Begin_Anew;

   ------------------
   -- Check_Newest --
   ------------------

   procedure Check_Newest (Expected : Frame_Slots.Slot) is
      Taken : Frame_Slots.Slot;
      Found : Boolean;
   begin
      Frame_Store.Claim_Newest (Taken, Found);
      Assert (Found, "an image waits");
      Assert (Taken = Expected,
              Expected'Image & " expected, not" & Taken'Image);
      Frame_Store.Release (Taken);
   end Check_Newest;

   ----------------
   -- Check_None --
   ----------------

   procedure Check_None is
      Taken : Frame_Slots.Slot;
      Found : Boolean;
   begin
      Frame_Store.Claim_Newest (Taken, Found);
      Assert (not Found, "no image expected, not" & Taken'Image);
   end Check_None;

   ----------
   -- Name --
   ----------

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Frame_Store"));

   --------------------
   -- Register_Tests --
   --------------------

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Newest'Access, "the newest image wins");
      Register_Routine (T, Test_Once'Access, "each image is taken once");
      Register_Routine (T, Test_Always_Free'Access,
                        "an empty slot beside owner, newest and readers");
      Register_Routine (T, Test_End'Access,
                        "a delivery that ends drops what waits");
      Register_Routine (T, Test_In_Turn'Access, "every slot in its turn");
      Register_Routine (T, Test_Times'Access, "when the last image came");
   end Register_Tests;

   ----------------------
   -- Test_Always_Free --
   ----------------------

   procedure Test_Always_Free (T : in out Any_Test) is
      pragma Unreferenced (T);
      type Slot_Set is array (Frame_Slots.Slot) of Boolean;
      Held  : Slot_Set := (others => False);
      Slot  : Frame_Slots.Slot;
      Found : Boolean;
   begin
      Begin_Anew;

      --  two readers hold one each, one is the newest

      for Reader in 1 .. 2 loop
         Frame_Store.Claim_Empty (Slot);
         Assert (not Held (Slot), "free");
         Frame_Store.Publish (Slot, Clock);
         Frame_Store.Claim_Newest (Slot, Found);
         Assert (Found, "for reader" & Reader'Image);
         Held (Slot) := True;
      end loop;
      Frame_Store.Claim_Empty (Slot);
      Assert (not Held (Slot), "one for the newest");
      Frame_Store.Publish (Slot, Clock);
      Held (Slot) := True;

      --  and the owner claims the others

      for I in 4 .. Held'Length loop
         Frame_Store.Claim_Empty (Slot);
         Assert (not Held (Slot), "slot" & I'Image & " of all");
         Held (Slot) := True;
      end loop;
      Assert (Held = (Held'Range => True), "all slots are in use");
      Frame_Store.Claim_Newest (Slot, Found);
      Assert (Found, "the newest waits still");
   end Test_Always_Free;

   --------------
   -- Test_End --
   --------------

   procedure Test_End (T : in out Any_Test) is
      pragma Unreferenced (T);
      Slot  : Frame_Slots.Slot;
      Found : Boolean;
   begin
      Begin_Anew;
      Frame_Store.Claim_Empty (Slot);
      Frame_Store.Publish (Slot, Clock);
      Frame_Store.End_Delivery;
      Check_None;
      Frame_Store.Wait_Newest (Slot, Found);
      Assert (not Found, "nobody waits for what does not come");

      --  an image that the owner was just taking is too late

      Frame_Store.Claim_Empty (Slot);
      Frame_Store.Publish (Slot, Clock);
      Check_None;

      --  and a camera that is opened again begins with nothing

      Frame_Store.Begin_Delivery (Clock);
      Check_None;
      Frame_Store.Claim_Empty (Slot);
      Frame_Store.Publish (Slot, Clock);
      Frame_Store.Wait_Newest (Slot, Found);
      Assert (Found, "the first image of the new delivery");
      Frame_Store.Release (Slot);
   end Test_End;

   ------------------
   -- Test_In_Turn --
   ------------------

   procedure Test_In_Turn (T : in out Any_Test) is
      pragma Unreferenced (T);
      Held, Slot, Last : Frame_Slots.Slot;

      function Next (After : Frame_Slots.Slot) return Frame_Slots.Slot is
        (if After = Frame_Slots.Slot'Last then Frame_Slots.Slot'First
         else After + 1);
   begin
      Begin_Anew;
      Frame_Store.Claim_Empty (Held);
      Last := Held;
      for Image in 1 .. 3 * Frame_Slots.Slot'Range_Length loop
         Frame_Store.Claim_Empty (Slot);
         Frame_Store.Publish (Slot, Clock);
         Last := Next (Last);
         if Last = Held then
            Last := Next (Last);
         end if;
         Assert (Slot = Last, "the next free one, not" & Slot'Image);
      end loop;
   end Test_In_Turn;

   -----------------
   -- Test_Newest --
   -----------------

   procedure Test_Newest (T : in out Any_Test) is
      pragma Unreferenced (T);
      First, Second, Third : Frame_Slots.Slot;
      Is_First_Free        : Boolean := False;
   begin
      Begin_Anew;
      Check_None;
      Frame_Store.Claim_Empty (First);
      Frame_Store.Publish (First, Clock);
      Frame_Store.Claim_Empty (Second);
      Assert (Second /= First, "the newest is not overwritten");
      Frame_Store.Publish (Second, Clock);
      for Other in 2 .. 6 loop
         Frame_Store.Claim_Empty (Third);
         Assert (Third /= Second, "nor by any of the others");
         Is_First_Free := Is_First_Free or else Third = First;
      end loop;
      Assert (Is_First_Free, "what was dropped is free again");
      Check_Newest (Second);
   end Test_Newest;

   ---------------
   -- Test_Once --
   ---------------

   procedure Test_Once (T : in out Any_Test) is
      pragma Unreferenced (T);
      Slot, Taken, Next : Frame_Slots.Slot;
      Found             : Boolean;
   begin
      Begin_Anew;
      Frame_Store.Claim_Empty (Slot);
      Frame_Store.Publish (Slot, Clock);
      Frame_Store.Claim_Newest (Taken, Found);
      Assert (Found and then Taken = Slot, "taken");
      Check_None;

      --  and its slot is not filled anew while it is being read

      Frame_Store.Claim_Empty (Next);
      Assert (Next /= Taken, "claimed");
      Frame_Store.Publish (Next, Clock);
      Frame_Store.Release (Taken);
      Check_Newest (Next);
   end Test_Once;

   ----------------
   -- Test_Times --
   ----------------

   procedure Test_Times (T : in out Any_Test) is
      pragma Unreferenced (T);
      Begun : constant Time := Clock;
      Later : constant Time := Begun + Milliseconds (40);
      Slot  : Frame_Slots.Slot;
      Found : Time;
   begin
      Begin_Anew;
      Frame_Store.Begin_Delivery (Begun);
      Frame_Store.Get_Newest_Time (Found);
      Assert (Found = Begun, "the beginning");
      Frame_Store.Claim_Empty (Slot);
      Frame_Store.Publish (Slot, Later);
      Frame_Store.Get_Newest_Time (Found);
      Assert (Found = Later, "the image");
      Frame_Store.End_Delivery;
      Frame_Store.Claim_Empty (Slot);
      Frame_Store.Publish (Slot, Later + Milliseconds (40));
      Frame_Store.Get_Newest_Time (Found);
      Assert (Found = Later, "none that is too late");
   end Test_Times;

end Frame_Store_Tests;
