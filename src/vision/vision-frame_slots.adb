--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Frame_Slots with SPARK_Mode is

   procedure Find_Free
     (S           : State;
      First, Last : Slot'Base;
      Which       : in out Slot)
   with
     Pre => First >= Slot'First and then Last <= Slot'Last,
     Post =>
       (if (for some W in First .. Last => Use_Of (S, W) = Free) then
           Which in First .. Last and then Use_Of (S, Which) = Free
        else Which = Which'Old)
   is
      --  The first free slot of First .. Last; otherwise Which is unchanged
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

   procedure Begin_Delivery (S : in out State) is
   begin
      S.Has_Newest := False;
      S.Has_Older := False;
      S.Delivering := True;
   end Begin_Delivery;

   procedure Claim_Empty (S : in out State; Which : out Slot) is
   begin
      Which := Slot'First;
      Find_Free (S, S.Last_Claimed + 1, Slot'Last, Which);
      if Use_Of (S, Which) /= Free then
         Find_Free (S, Slot'First, S.Last_Claimed, Which);
      end if;
      Release (S, Which);
      S.In_Use (Which) := True;
      S.Last_Claimed := Which;
   end Claim_Empty;

   procedure Claim_Newest
     (S : in out State; Which : out Slot; Found : out Boolean) is
   begin
      Which := S.Newest;
      Found := S.Has_Newest;
      if Found then
         S.Has_Newest := False;
         S.Has_Older := False;
         S.In_Use (Which) := True;
      end if;
   end Claim_Newest;

   procedure Claim_Older (S : in out State; Which : out Slot) is
   begin
      Which := S.Older;
      S.Has_Older := False;
      S.In_Use (Which) := True;
   end Claim_Older;

   procedure End_Delivery (S : in out State) is
   begin
      S.Has_Newest := False;
      S.Has_Older := False;
      S.Delivering := False;
   end End_Delivery;

   procedure Prove_One_Each (S : State) is null;

   procedure Publish (S : in out State; Which : Slot) is
   begin
      Release (S, Which);
      if S.Delivering then
         S := (In_Use       => S.In_Use,
               Has_Newest   => True,
               Newest       => Which,
               Has_Older    => S.Has_Newest,
               Older        => S.Newest,
               Last_Claimed => S.Last_Claimed,
               Delivering   => True);
      end if;
   end Publish;

   procedure Release (S : in out State; Which : Slot) is
   begin
      if S.Newest = Which then
         S.Has_Newest := False;
      end if;
      if S.Older = Which then
         S.Has_Older := False;
      end if;
      S.In_Use (Which) := False;
   end Release;

end Vision.Frame_Slots;
