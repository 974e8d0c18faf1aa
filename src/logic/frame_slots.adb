--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may use which frame slot: at most one holds the newest image, for
--  whoever claims it first; the others are claimed by one task each, or free.

package body Frame_Slots with SPARK_Mode is

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
      for W in Slot loop
         if Use_Of (S, W) = Free then
            Which := W;
            exit;
         end if;
         pragma Loop_Invariant (Which = Slot'First);
         pragma Loop_Invariant
           (for all X in Slot'First .. W => Use_Of (S, X) /= Free);
      end loop;
      if S.Newest = Which then
         S.Has_Newest := False;
      end if;
      S.In_Use (Which) := True;
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
