--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may use which frame slot: at most one holds the newest image, for
--  whoever claims it first; the others are claimed by one task each, or free.

package body Frame_Slots with SPARK_Mode is

   procedure Find_Free
     (S           : State;
      First, Last : Slot'Base;
      Which       : in out Slot)
   with
     Pre => First >= Slot'First and then Last <= Slot'Last,
     Post =>
       (if (for some W in First .. Last => Use_Of (S, W) = Free) then
           Which in First .. Last and then Use_Of (S, Which) = Free
        else Which = Which'Old);
   --  The first free slot of First .. Last; Which remains if there is none

   --------------------
   -- Begin_Delivery --
   --------------------

   procedure Begin_Delivery (S : in out State) is
   begin
      S.Has_Newest := False;
      S.Delivering := True;
   end Begin_Delivery;

   -----------------
   -- Claim_Empty --
   -----------------

   procedure Claim_Empty (S : in out State; Which : out Slot) is
   begin
      Which := Slot'First;
      Find_Free (S, S.Last_Claimed + 1, Slot'Last, Which);
      if Use_Of (S, Which) /= Free then
         Find_Free (S, Slot'First, S.Last_Claimed, Which);
      end if;
      if S.Newest = Which then
         S.Has_Newest := False;
      end if;
      S.In_Use (Which) := True;
      S.Last_Claimed := Which;
   end Claim_Empty;

   ------------------
   -- Claim_Newest --
   ------------------

   procedure Claim_Newest
     (S : in out State; Which : out Slot; Found : out Boolean) is
   begin
      Which := S.Newest;
      Found := S.Has_Newest;
      if Found then
         S.Has_Newest := False;
         S.In_Use (Which) := True;
      end if;
   end Claim_Newest;

   ------------------
   -- End_Delivery --
   ------------------

   procedure End_Delivery (S : in out State) is
   begin
      S.Has_Newest := False;
      S.Delivering := False;
   end End_Delivery;

   ---------------
   -- Find_Free --
   ---------------

   procedure Find_Free
     (S           : State;
      First, Last : Slot'Base;
      Which       : in out Slot) is
   begin
      for W in First .. Last loop
         if Use_Of (S, W) = Free then
            Which := W;
            return;
         end if;
         pragma Loop_Invariant
           (for all X in First .. W => Use_Of (S, X) /= Free);
      end loop;
   end Find_Free;

   ----------------------
   -- Prove_One_Newest --
   ----------------------

   procedure Prove_One_Newest (S : State) is null;

   -------------
   -- Publish --
   -------------

   procedure Publish (S : in out State; Which : Slot) is
   begin
      Release (S, Which);
      if S.Delivering then
         S.Newest := Which;
         S.Has_Newest := True;
      end if;
   end Publish;

   -------------
   -- Release --
   -------------

   procedure Release (S : in out State; Which : Slot) is
   begin
      if S.Newest = Which then
         S.Has_Newest := False;
      end if;
      S.In_Use (Which) := False;
   end Release;

end Frame_Slots;
