--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which task may use which frame slot: the camera's owner fills one after
--  the other, the newest is for whoever takes it first.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Schedule;
with Trace;

package body Frame_Store with SPARK_Mode is

   Changed : Suspension_Object;  --  an image has come, or none will

   protected Store with Priority => Schedule.Vision_Ceiling is
      procedure Begin_Delivery (At_Time : Time);
      procedure End_Delivery;
      procedure Claim_Empty (Slot : out Frame_Slots.Slot);
      procedure Publish (Slot : Frame_Slots.Slot; At_Time : Time);
      procedure Release (Slot : Frame_Slots.Slot);
      procedure Claim_Newest
        (Slot : out Frame_Slots.Slot; Found : out Boolean);
      procedure Get_Delivering (Now : out Boolean);
      procedure Get_Newest_Time (At_Time : out Time);
   private
      Uses        : Frame_Slots.State;
      Newest_Time : Time := Time_First;
   end Store;

   protected body Store is

      procedure Begin_Delivery (At_Time : Time) is
      begin
         Frame_Slots.Begin_Delivery (Uses);
         Newest_Time := At_Time;
      end Begin_Delivery;

      procedure End_Delivery is
      begin
         Frame_Slots.End_Delivery (Uses);
      end End_Delivery;

      procedure Claim_Empty (Slot : out Frame_Slots.Slot) is
      begin
         Frame_Slots.Claim_Empty (Uses, Slot);
      end Claim_Empty;

      procedure Publish (Slot : Frame_Slots.Slot; At_Time : Time) is
      begin
         Frame_Slots.Publish (Uses, Slot);
         if Frame_Slots.Is_Delivering (Uses) then
            Newest_Time := At_Time;
         end if;
      end Publish;

      procedure Release (Slot : Frame_Slots.Slot) is
      begin
         Frame_Slots.Release (Uses, Slot);
      end Release;

      procedure Claim_Newest
        (Slot : out Frame_Slots.Slot; Found : out Boolean) is
      begin
         Frame_Slots.Claim_Newest (Uses, Slot, Found);
      end Claim_Newest;

      procedure Get_Delivering (Now : out Boolean) is
      begin
         Now := Frame_Slots.Is_Delivering (Uses);
      end Get_Delivering;

      procedure Get_Newest_Time (At_Time : out Time) is
      begin
         At_Time := Newest_Time;
      end Get_Newest_Time;

   end Store;

   --------------------
   -- Begin_Delivery --
   --------------------

   procedure Begin_Delivery (At_Time : Ada.Real_Time.Time) is
   begin
      Store.Begin_Delivery (At_Time);
   end Begin_Delivery;

   ------------------
   -- End_Delivery --
   ------------------

   procedure End_Delivery is
   begin
      Store.End_Delivery;
      Set_True (Changed);
   end End_Delivery;

   -----------------
   -- Claim_Empty --
   -----------------

   procedure Claim_Empty (Slot : out Frame_Slots.Slot) is
   begin
      Store.Claim_Empty (Slot);
   end Claim_Empty;

   -------------
   -- Publish --
   -------------

   procedure Publish (Slot : Frame_Slots.Slot; At_Time : Ada.Real_Time.Time) is
   begin
      Store.Publish (Slot, At_Time);
      Set_True (Changed);
   end Publish;

   -------------
   -- Release --
   -------------

   procedure Release (Slot : Frame_Slots.Slot) is
   begin
      Store.Release (Slot);
   end Release;

   ------------------
   -- Claim_Newest --
   ------------------

   procedure Claim_Newest (Slot : out Frame_Slots.Slot; Found : out Boolean) is
   begin
      Store.Claim_Newest (Slot, Found);
   end Claim_Newest;

   -----------------
   -- Wait_Newest --
   -----------------

   procedure Wait_Newest (Slot : out Frame_Slots.Slot; Found : out Boolean) is
      Delivering : Boolean;
   begin
      loop
         Store.Get_Delivering (Delivering);
         Store.Claim_Newest (Slot, Found);
         exit when Found or else not Delivering;
         Trace.Wait (Schedule.Th_Arene, Trace.Camera);
         Suspend_Until_True (Changed);
         Trace.Resume (Schedule.Th_Arene);
      end loop;
   end Wait_Newest;

   ---------------------
   -- Get_Newest_Time --
   ---------------------

   procedure Get_Newest_Time (At_Time : out Ada.Real_Time.Time) is
   begin
      Store.Get_Newest_Time (At_Time);
   end Get_Newest_Time;

end Frame_Store;
