--  SPDX-License-Identifier: GPL-3.0-or-later
--  The images from the camera: arrival times, which one is due, and whether
--  th_captureImg waits for the next.

with Ada.Real_Time;      use Ada.Real_Time;
with Schedule;
with Vision.Frame_Slots; use Vision.Frame_Slots;
with Vision.Image_Grid;

package Vision.Frame_Delivery with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Frame_Delivery);

   type State is record
      Uses        : Vision.Frame_Slots.State;
      Newest_Time : Time := Time_First;
      --  arrival of the newest image, or start of the delivery
      Older_Time  : Time := Time_First;
      --  arrival of the image before it
      Waits       : Boolean := False;
      --  th_captureImg waits for the next image
   end record;

   function Elapsed (First, Last : Time) return Vision.Image_Grid.Microseconds;
   --  From First to Last, within the range of the type; 0 if Last is earlier

   function Is_Silent (S : State; Now : Time) return Boolean is
     (Now - S.Newest_Time > Schedule.Camera_Silence);
   --  No image for so long that the camera has failed

   function Is_Reserve
     (S      : State;
      Now    : Time;
      Period : Vision.Image_Grid.Period_Time) return Boolean
   is (Has_Older (S.Uses)
       and then Has_Newest (S.Uses)
       and then Vision.Image_Grid.Sends_Older
         (Newest_Age => Elapsed (S.Newest_Time, Now),
          Older_Age  => Elapsed (S.Older_Time, Now),
          Period     => Period));
   --  The older image is due, and the newest is kept for later

   procedure Begin_Delivery (S : in out State; At_Time : Time)
   with
     Post => Is_Delivering (S.Uses) and then S.Waits = S'Old.Waits;
   --  The contracts do not cover the times: GNATprove cannot reason about the
   --  equality of two Time values. The unit tests cover them

   procedure End_Delivery (S : in out State; Awaited : out Boolean)
   with
     Post => not Is_Delivering (S.Uses)
       and then Awaited = S'Old.Waits
       and then not S.Waits;
   --  Awaited, here and below: th_captureImg must be woken

   procedure Publish
     (S : in out State; Which : Slot; At_Time : Time; Awaited : out Boolean)
   with
     Post => Awaited = S'Old.Waits
       and then not S.Waits
       and then
         Use_Of (S.Uses, Which) =
           (if Is_Delivering (S'Old.Uses) then Newest else Free);

   procedure Claim_Due
     (S       : in out State;
      Now     : Time;
      Period  : Vision.Image_Grid.Period_Time;
      Which   : out Slot;
      At_Time : out Time;
      Reserve : out Boolean;
      Found   : out Boolean;
      Coming  : out Boolean)
   with
     Post => Reserve = Is_Reserve (S'Old, Now, Period)
       and then Found = (Reserve or else Has_Newest (S'Old.Uses))
       and then
         (if Found then
             Use_Of (S'Old.Uses, Which) = (if Reserve then Older else Newest)
             and then Use_Of (S.Uses, Which) = Claimed)
       and then Coming = Is_Delivering (S'Old.Uses)
       and then S.Waits = (Coming and then not Found);
   --  The image to be sent at an instant of the grid, and its arrival time.
   --  Reserve: a newer one waits. Coming: another will arrive

   procedure Look_At_Silence
     (S : in out State; Now : Time; Awaited : out Boolean)
   with
     Post => Awaited = (S'Old.Waits and then Is_Silent (S'Old, Now))
       and then S.Waits = (S'Old.Waits and then not Awaited);

end Vision.Frame_Delivery;
