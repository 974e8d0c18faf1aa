--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which task may use which frame slot: the camera's owner fills them in turn,
--  and the newest image goes to the first reader that claims it.

with Ada.Real_Time;
with Vision.Frame_Slots;
with Vision.Image_Grid;

package Vision.Frame_Store with SPARK_Mode is

   procedure Begin_Delivery (At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  The camera has been opened

   procedure End_Delivery with Annotate => (GNATprove, Terminating);
   --  The camera has been closed or has failed: no newer image will come

   procedure Claim_Empty (Slot : out Vision.Frame_Slots.Slot)
   with Annotate => (GNATprove, Terminating);
   --  A slot to be filled. For the camera's owner only

   procedure Publish
     (Slot : Vision.Frame_Slots.Slot; At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  The slot holds the newest image now. The newest so far is kept as the
   --  image before it, the older one is dropped, unless claimed

   procedure Release (Slot : Vision.Frame_Slots.Slot)
   with Annotate => (GNATprove, Terminating);
   --  The slot is free again

   procedure Claim_Due
     (Now     : Ada.Real_Time.Time;
      Period  : Vision.Image_Grid.Period_Time;
      Slot    : out Vision.Frame_Slots.Slot;
      At_Time : out Ada.Real_Time.Time;
      Reserve : out Boolean;
      Found   : out Boolean;
      Coming  : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The image to be sent at an instant of the grid, and its arrival time.
   --  Reserve: a newer one waits. If none is found, Coming tells whether
   --  Wait_Look will return. For th_captureImg

   procedure Wait_Look;
   --  After a Claim_Due without an image, until one has come or none will. For
   --  th_captureImg only

   procedure Look_At_Silence (Now : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Ends Wait_Look if no image has come for so long that the camera has
   --  failed

   procedure Claim_Newest
     (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The newest image, if it has not been taken yet

   procedure Wait_Newest
     (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean);
   --  The same, but waits for an image; not found when the delivery has ended.
   --  For th_arene only

   procedure Get_Silent (Now : Ada.Real_Time.Time; Silent : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  No image for so long that the camera has failed

end Vision.Frame_Store;
