--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which task may use which frame slot: the camera's owner fills them in turn,
--  and the newest image goes to the first reader that claims it.

with Ada.Real_Time; use Ada.Real_Time;
with Schedule;
with Vision.Frame_Slots;
with Vision.Image_Grid;

package Vision.Frame_Store with SPARK_Mode is

   protected Store with Priority => Schedule.Frame_Ceiling is

      procedure Begin_Delivery (At_Time : Time);
      --  The camera has been opened

      procedure End_Delivery (Awaited : out Boolean);

      procedure Claim_Empty (Slot : out Vision.Frame_Slots.Slot);
      --  A slot to be filled. For the camera's owner only

      procedure Publish
        (Slot    : Vision.Frame_Slots.Slot;
         At_Time : Time;
         Awaited : out Boolean);

      procedure Release (Slot : Vision.Frame_Slots.Slot);
      --  The slot is free again

      procedure Claim_Due
        (Now     : Time;
         Period  : Vision.Image_Grid.Period_Time;
         Slot    : out Vision.Frame_Slots.Slot;
         At_Time : out Time;
         Reserve : out Boolean;
         Found   : out Boolean;
         Coming  : out Boolean);
      --  The image to be sent at an instant of the grid, and its arrival time.
      --  Reserve: a newer one waits. If none is found, Coming tells whether
      --  Wait_Look will return. For th_captureImg

      procedure Look_At_Silence (Now : Time; Awaited : out Boolean);

      procedure Claim_Newest
        (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean);
      --  The newest image, if it has not been taken yet

      procedure Get_Delivering (Now : out Boolean);

      procedure Get_Silent (Now : Time; Silent : out Boolean);
      --  No image for so long that the camera has failed

   private
      Uses        : Vision.Frame_Slots.State;
      Newest_Time : Time := Time_First;
      --  arrival of the newest image, or start of the delivery
      Older_Time  : Time := Time_First;
      --  arrival of the image before it
      Waits       : Boolean := False;
      --  th_captureImg waits for the next image
   end Store;

   --  Those of the object's operations that end a wait, and the waits

   procedure End_Delivery with Annotate => (GNATprove, Terminating);
   --  The camera has been closed or has failed: no newer image will come

   procedure Publish (Slot : Vision.Frame_Slots.Slot; At_Time : Time)
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

   procedure Wait_Newest
     (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean);
   --  The newest image, once there is one; not found when the delivery has
   --  ended. For th_arene only

end Vision.Frame_Store;
