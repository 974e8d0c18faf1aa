--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which task may use which frame slot: the camera's owner fills one after
--  the other, the newest is for whoever takes it first.

with Ada.Real_Time;
with Frame_Slots;

package Frame_Store with SPARK_Mode is

   procedure Begin_Delivery (At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  The camera has been opened

   procedure End_Delivery with Annotate => (GNATprove, Terminating);
   --  The camera has been closed or has failed: nothing newer will come

   procedure Claim_Empty (Slot : out Frame_Slots.Slot)
   with Annotate => (GNATprove, Terminating);
   --  A slot to be filled. For the camera's owner only

   procedure Publish (Slot : Frame_Slots.Slot; At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  The slot holds the newest image now; an older one is dropped

   procedure Release (Slot : Frame_Slots.Slot)
   with Annotate => (GNATprove, Terminating);
   --  The slot is free again

   procedure Claim_Newest (Slot : out Frame_Slots.Slot; Found : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The newest image, if it has not been taken yet. For th_captureImg

   procedure Wait_Newest (Slot : out Frame_Slots.Slot; Found : out Boolean);
   --  The same, and waits for it; not found when the delivery has ended.
   --  For th_arene only

   procedure Get_Newest_Time (At_Time : out Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  When the last image came, or the delivery began

end Frame_Store;
