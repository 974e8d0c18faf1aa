--  SPDX-License-Identifier: GPL-3.0-or-later
--  Ownership of the frame slots: one holds the newest image and one the image
--  before it, both unclaimed; each other slot is claimed by one task, or free.

package Vision.Frame_Slots with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.Frame_Slots);

   type Slot is range 0 .. 5;
   --  A place for one image. Used at most: one by the camera's owner, one for
   --  the newest image, one for the image before it, and one by each of the
   --  two readers. So one is always free

   type Use_Kind is (Free, Claimed, Older, Newest);

   type State is private;
   --  Initially all slots are free, and nothing is delivered

   function Use_Of (S : State; Which : Slot) return Use_Kind;

   function Has_Newest (S : State) return Boolean;

   function Has_Older (S : State) return Boolean;
   --  The image before the newest also waits

   function Is_Delivering (S : State) return Boolean;
   --  The camera is open: newer images will arrive

   --  Used in the contracts

   type Change_Kind is
     (None,
      Newer_Comes,   --  the newest becomes the older one, which is dropped
      Older_Drops);  --  the older one is dropped

   function After (Change : Change_Kind; Was : Use_Kind) return Use_Kind is
     (case Change is
         when None        => Was,
         when Newer_Comes =>
           (case Was is
               when Newest         => Older,
               when Older          => Free,
               when Free | Claimed => Was),
         when Older_Drops => (if Was = Older then Free else Was))
   with Ghost;

   function Is_Same_But
     (S, Before : State; Which : Slot; Change : Change_Kind) return Boolean
   is (for all Other in Slot =>
         (if Other /= Which then
             Use_Of (S, Other) = After (Change, Use_Of (Before, Other))))
   with Ghost;
   --  The change of all other slots

   procedure Prove_One_Each (S : State)
   with
     Ghost,
     Post => Has_Newest (S) = (for some W in Slot => Use_Of (S, W) = Newest)
       and then
         Has_Older (S) = (for some W in Slot => Use_Of (S, W) = Older)
       and then
         (for all Left in Slot =>
            (for all Right in Slot =>
               (if Use_Of (S, Left) in Newest | Older
                  and then Use_Of (S, Left) = Use_Of (S, Right)
                then Left = Right)));
   --  There is at most one of either kind

   procedure Begin_Delivery (S : in out State)
   with
     Post => Is_Delivering (S)
       and then not Has_Newest (S) and then not Has_Older (S);

   procedure End_Delivery (S : in out State)
   with
     Post => not Is_Delivering (S)
       and then not Has_Newest (S) and then not Has_Older (S);

   procedure Claim_Empty (S : in out State; Which : out Slot)
   with
     Post => Use_Of (S, Which) = Claimed
       and then
         (if (for some W in Slot => Use_Of (S'Old, W) = Free) then
             Use_Of (S'Old, Which) = Free)
       and then Is_Same_But (S, S'Old, Which, None)
       and then Is_Delivering (S) = Is_Delivering (S'Old);
   --  A slot to be filled: a free one, if any, searched from the slot claimed
   --  last. In rotation all slots get their memory soon after the start, none
   --  of them late

   procedure Publish (S : in out State; Which : Slot)
   with
     Post => Is_Delivering (S) = Is_Delivering (S'Old)
       and then
         (if Is_Delivering (S) then
             Use_Of (S, Which) = Newest
             and then Is_Same_But (S, S'Old, Which, Newer_Comes)
          else Use_Of (S, Which) = Free
            and then Is_Same_But (S, S'Old, Which, None));
   --  The image becomes the newest. The newest so far is kept as the image
   --  before it, the older one is dropped, unless claimed

   procedure Release (S : in out State; Which : Slot)
   with
     Post => Use_Of (S, Which) = Free
       and then Is_Same_But (S, S'Old, Which, None)
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
             and then Is_Same_But (S, S'Old, Which, Older_Drops))
       and then (if not Found then
                   (for all W in Slot => Use_Of (S, W) = Use_Of (S'Old, W)))
       and then Is_Delivering (S) = Is_Delivering (S'Old);
   --  Claims the newest image. The one before it is dropped

   procedure Claim_Older (S : in out State; Which : out Slot)
   with
     Pre  => Has_Older (S),
     Post => Use_Of (S'Old, Which) = Older
       and then Use_Of (S, Which) = Claimed
       and then Is_Same_But (S, S'Old, Which, None)
       and then Has_Newest (S) = Has_Newest (S'Old)
       and then not Has_Older (S)
       and then Is_Delivering (S) = Is_Delivering (S'Old);
   --  Claims the image before the newest, which still waits

private

   type Slot_Set is array (Slot) of Boolean;

   type State is record
      In_Use       : Slot_Set := (others => False);
      Has_Newest   : Boolean  := False;
      Newest       : Slot     := Slot'First;
      Has_Older    : Boolean  := False;
      Older        : Slot     := Slot'First;
      Last_Claimed : Slot     := Slot'Last;
      Delivering   : Boolean  := False;
   end record
   with Dynamic_Predicate =>
     (if State.Has_Newest then not State.In_Use (State.Newest))
     and then (if State.Has_Older then not State.In_Use (State.Older))
     and then (if State.Has_Newest and then State.Has_Older
               then State.Newest /= State.Older);

   function Use_Of (S : State; Which : Slot) return Use_Kind is
     (if S.In_Use (Which) then Claimed
      elsif S.Has_Newest and then S.Newest = Which then Newest
      elsif S.Has_Older and then S.Older = Which then Older
      else Free);

   function Has_Newest (S : State) return Boolean is (S.Has_Newest);

   function Has_Older (S : State) return Boolean is (S.Has_Older);

   function Is_Delivering (S : State) return Boolean is (S.Delivering);

end Vision.Frame_Slots;
