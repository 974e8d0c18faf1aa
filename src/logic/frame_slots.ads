--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may use which frame slot: at most one holds the newest image, for
--  whoever claims it first; the others are claimed by one task each, or free.

package Frame_Slots with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Frame_Slots);
   --  A claim that GNATprove checks: every subprogram ends

   type Slot is range 0 .. 5;
   --  A place for one image. One is with the camera's owner, one holds the
   --  newest image, one is with each of the two readers: there is always a
   --  free one

   type Use_Kind is (Free, Claimed, Newest);

   type State is private;
   --  Initially all slots are free, and nothing is delivered

   function Use_Of (S : State; Which : Slot) return Use_Kind;

   function Has_Newest (S : State) return Boolean;

   function Is_Delivering (S : State) return Boolean;
   --  The camera is open: newer images will come

   --  The words of the contracts

   function Is_Same_But
     (S, Before : State; Which : Slot; Drop : Boolean) return Boolean
   is (for all Other in Slot =>
         (if Other /= Which then
             Use_Of (S, Other) =
               (if Drop and then Use_Of (Before, Other) = Newest then Free
                else Use_Of (Before, Other))))
   with Ghost;
   --  The other slots are as before; Drop: but none of them the newest

   procedure Prove_One_Newest (S : State)
   with
     Ghost,
     Post => Has_Newest (S) = (for some W in Slot => Use_Of (S, W) = Newest)
       and then
         (for all Left in Slot =>
            (for all Right in Slot =>
               (if Use_Of (S, Left) = Newest
                  and then Use_Of (S, Right) = Newest
                then Left = Right)));
   --  There never are two of them

   --  The operations

   procedure Begin_Delivery (S : in out State)
   with
     Post => Is_Delivering (S) and then not Has_Newest (S);

   procedure End_Delivery (S : in out State)
   with
     Post => not Is_Delivering (S) and then not Has_Newest (S);

   procedure Claim_Empty (S : in out State; Which : out Slot)
   with
     Post => Use_Of (S, Which) = Claimed
       and then
         (if (for some W in Slot => Use_Of (S'Old, W) = Free) then
             Use_Of (S'Old, Which) = Free)
       and then Is_Same_But (S, S'Old, Which, Drop => False)
       and then Is_Delivering (S) = Is_Delivering (S'Old);
   --  A slot to be filled: a free one as long as there is one, the next after
   --  the one claimed last. So each gets its memory soon after the start, and
   --  none late, when a rare moment first needs it

   procedure Publish (S : in out State; Which : Slot)
   with
     Post => Is_Delivering (S) = Is_Delivering (S'Old)
       and then
         (if Is_Delivering (S) then
             Use_Of (S, Which) = Newest
             and then Is_Same_But (S, S'Old, Which, Drop => True)
          else Use_Of (S, Which) = Free
            and then Is_Same_But (S, S'Old, Which, Drop => False));
   --  The newest image wins: an older one that nobody has claimed is dropped

   procedure Release (S : in out State; Which : Slot)
   with
     Post => Use_Of (S, Which) = Free
       and then Is_Same_But (S, S'Old, Which, Drop => False)
       and then Is_Delivering (S) = Is_Delivering (S'Old);

   procedure Claim_Newest
     (S : in out State; Which : out Slot; Found : out Boolean)
   with
     Post => Found = Has_Newest (S'Old)
       and then not Has_Newest (S)
       and then
         (if Found then
             Use_Of (S'Old, Which) = Newest
             and then Use_Of (S, Which) = Claimed
             and then Is_Same_But (S, S'Old, Which, Drop => False))
       and then (if not Found then
                   (for all W in Slot => Use_Of (S, W) = Use_Of (S'Old, W)))
       and then Is_Delivering (S) = Is_Delivering (S'Old);
   --  The newest image, once

private

   type Slot_Set is array (Slot) of Boolean;

   type State is record
      In_Use       : Slot_Set := (others => False);
      Has_Newest   : Boolean  := False;
      Newest       : Slot     := Slot'First;
      Last_Claimed : Slot     := Slot'Last;
      Delivering   : Boolean  := False;
   end record
   with Dynamic_Predicate =>
     (if State.Has_Newest then not State.In_Use (State.Newest));

   function Use_Of (S : State; Which : Slot) return Use_Kind is
     (if S.In_Use (Which) then Claimed
      elsif S.Has_Newest and then S.Newest = Which then Newest
      else Free);

   function Has_Newest (S : State) return Boolean is (S.Has_Newest);

   function Is_Delivering (S : State) return Boolean is (S.Delivering);

end Frame_Slots;
