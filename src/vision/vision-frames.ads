--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which task may use which image: the camera's owner fills the slots in turn,
--  and the newest image goes to the first reader that claims it.

with Ada.Real_Time; use Ada.Real_Time;
with Schedule;
with Vision.Image_Grid;

package Vision.Frames with SPARK_Mode is

   type Slot_Set is array (Slot) of Boolean;

   type Slot_Uses is record
      Claimed    : Slot_Set := (others => False);
      --  each by one task
      Has_Newest : Boolean := False;
      Newest     : Slot := Slot'First;
      Has_Older  : Boolean := False;
      Older      : Slot := Slot'First;
      --  the image before the newest, which still waits too
   end record
   with Dynamic_Predicate =>
     (if Slot_Uses.Has_Newest
      then not Slot_Uses.Claimed (Slot_Uses.Newest))
     and then (if Slot_Uses.Has_Older
               then not Slot_Uses.Claimed (Slot_Uses.Older))
     and then (if Slot_Uses.Has_Newest and then Slot_Uses.Has_Older
               then Slot_Uses.Newest /= Slot_Uses.Older);
   --  No slot is used for two things; initially all are free

   function Is_Free (Uses : Slot_Uses; Which : Slot) return Boolean is
     (not Uses.Claimed (Which)
      and then not (Uses.Has_Newest and then Uses.Newest = Which)
      and then not (Uses.Has_Older and then Uses.Older = Which));

   function Free_Slot (Uses : Slot_Uses; After : Slot) return Slot
   with Post =>
     (if (for some W in Slot => Is_Free (Uses, W))
      then Is_Free (Uses, Free_Slot'Result));
   --  The first free one behind After, in rotation: so all slots get their
   --  memory soon after the start, none of them late

   protected Store with Priority => Schedule.Frame_Ceiling is

      procedure Begin_Delivery (At_Time : Time);
      --  The camera has been opened

      procedure End_Delivery (Awaited : out Boolean);

      procedure Claim_Empty (Which : out Slot);
      --  A slot to be filled. For the camera's owner only

      procedure Publish (Which : Slot; At_Time : Time; Awaited : out Boolean);

      procedure Release (Which : Slot);
      --  The slot is free again, if it was claimed

      procedure Claim_Due
        (Now     : Time;
         Period  : Vision.Image_Grid.Period_Time;
         Which   : out Slot;
         At_Time : out Time;
         Reserve : out Boolean;
         Found   : out Boolean;
         Coming  : out Boolean);
      --  The image to be sent at an instant of the grid, and its arrival time.
      --  Reserve: a newer one waits. If none is found, Coming tells whether
      --  Wait_Look will return. For th_captureImg

      procedure Look_At_Silence (Now : Time; Awaited : out Boolean);

      procedure Claim_Newest
        (Which : out Slot; Found : out Boolean; Coming : out Boolean);
      --  The newest image, if it has not been taken yet. Coming: newer images
      --  will come

      procedure Get_Silent (Now : Time; Silent : out Boolean);
      --  No image for so long that the camera has failed

   private
      Uses         : Slot_Uses;
      Last_Claimed : Slot := Slot'Last;
      Is_On        : Boolean := False;
      --  the camera is open: newer images will come
      Newest_Time  : Time := Time_First;
      --  arrival of the newest image, or start of the delivery
      Older_Time   : Time := Time_First;
      --  arrival of the image before it
      Waits        : Boolean := False;
      --  th_captureImg waits for the next image
   end Store;

   --  Those of the object's operations that end a wait, and the waits

   procedure End_Delivery with Annotate => (GNATprove, Terminating);
   --  The camera has been closed or has failed: no newer image will come

   procedure Publish (Which : Slot; At_Time : Time)
   with Annotate => (GNATprove, Terminating);
   --  The slot holds the newest image now. The newest so far is kept as the
   --  image before it, the older one is dropped, unless claimed

   procedure Wait_Look;
   --  After a Claim_Due without an image, until one has come or none will. For
   --  th_captureImg only

   procedure Look_At_Silence (Now : Time)
   with Annotate => (GNATprove, Terminating);
   --  Ends Wait_Look if no image has come for so long that the camera has
   --  failed

   procedure Wait_Newest (Which : out Slot; Found : out Boolean);
   --  The newest image, once there is one; not found when the delivery has
   --  ended. For th_arene only

end Vision.Frames;
