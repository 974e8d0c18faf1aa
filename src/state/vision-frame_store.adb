--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Vision.Frame_Slots and Vision.Frame_Delivery decide.

with Ada.Real_Time; use Ada.Real_Time;
with Event;
with Schedule;
with Trace;
with Vision.Frame_Delivery;

package body Vision.Frame_Store with SPARK_Mode is

   package Changed is new Event;
   --  An image has come, or none will. Awaited by th_arene

   package Look is new Event;
   --  The same, or the camera is silent. Awaited by th_captureImg

   protected Store with Priority => Schedule.Frame_Ceiling is
      procedure Begin_Delivery (At_Time : Time);
      procedure End_Delivery (Awaited : out Boolean);
      procedure Claim_Empty (Slot : out Vision.Frame_Slots.Slot);
      procedure Publish
        (Slot    : Vision.Frame_Slots.Slot;
         At_Time : Time;
         Awaited : out Boolean);
      procedure Release (Slot : Vision.Frame_Slots.Slot);
      procedure Claim_Due
        (Now     : Time;
         Period  : Vision.Image_Grid.Period_Time;
         Slot    : out Vision.Frame_Slots.Slot;
         At_Time : out Time;
         Reserve : out Boolean;
         Found   : out Boolean;
         Coming  : out Boolean);
      procedure Look_At_Silence (Now : Time; Awaited : out Boolean);
      procedure Claim_Newest
        (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean);
      procedure Get_Delivering (Now : out Boolean);
      procedure Get_Silent (Now : Time; Silent : out Boolean);
   private
      State : Vision.Frame_Delivery.State;
   end Store;

   procedure Tell_If (Awaited : Boolean);
   --  Wakes th_captureImg

   protected body Store is

      procedure Begin_Delivery (At_Time : Time) is
      begin
         Vision.Frame_Delivery.Begin_Delivery (State, At_Time);
      end Begin_Delivery;

      procedure End_Delivery (Awaited : out Boolean) is
      begin
         Vision.Frame_Delivery.End_Delivery (State, Awaited);
      end End_Delivery;

      procedure Claim_Empty (Slot : out Vision.Frame_Slots.Slot) is
      begin
         Vision.Frame_Slots.Claim_Empty (State.Uses, Slot);
      end Claim_Empty;

      procedure Publish
        (Slot    : Vision.Frame_Slots.Slot;
         At_Time : Time;
         Awaited : out Boolean) is
      begin
         Vision.Frame_Delivery.Publish (State, Slot, At_Time, Awaited);
      end Publish;

      procedure Release (Slot : Vision.Frame_Slots.Slot) is
      begin
         Vision.Frame_Slots.Release (State.Uses, Slot);
      end Release;

      procedure Claim_Due
        (Now     : Time;
         Period  : Vision.Image_Grid.Period_Time;
         Slot    : out Vision.Frame_Slots.Slot;
         At_Time : out Time;
         Reserve : out Boolean;
         Found   : out Boolean;
         Coming  : out Boolean) is
      begin
         Vision.Frame_Delivery.Claim_Due
           (State, Now, Period, Slot, At_Time, Reserve, Found, Coming);
      end Claim_Due;

      procedure Look_At_Silence (Now : Time; Awaited : out Boolean) is
      begin
         Vision.Frame_Delivery.Look_At_Silence (State, Now, Awaited);
      end Look_At_Silence;

      procedure Claim_Newest
        (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean) is
      begin
         Vision.Frame_Slots.Claim_Newest (State.Uses, Slot, Found);
      end Claim_Newest;

      procedure Get_Delivering (Now : out Boolean) is
      begin
         Now := Vision.Frame_Slots.Is_Delivering (State.Uses);
      end Get_Delivering;

      procedure Get_Silent (Now : Time; Silent : out Boolean) is
      begin
         Silent := Vision.Frame_Delivery.Is_Silent (State, Now);
      end Get_Silent;

   end Store;

   procedure Begin_Delivery (At_Time : Ada.Real_Time.Time) is
   begin
      Store.Begin_Delivery (At_Time);
   end Begin_Delivery;

   procedure End_Delivery is
      Awaited : Boolean;
   begin
      Store.End_Delivery (Awaited);
      Changed.Set;
      Tell_If (Awaited);
   end End_Delivery;

   procedure Claim_Empty (Slot : out Vision.Frame_Slots.Slot) is
   begin
      Store.Claim_Empty (Slot);
   end Claim_Empty;

   procedure Publish
     (Slot : Vision.Frame_Slots.Slot; At_Time : Ada.Real_Time.Time) is
      Awaited : Boolean;
   begin
      Store.Publish (Slot, At_Time, Awaited);
      Changed.Set;
      Tell_If (Awaited);
   end Publish;

   procedure Release (Slot : Vision.Frame_Slots.Slot) is
   begin
      Store.Release (Slot);
   end Release;

   procedure Claim_Due
     (Now     : Ada.Real_Time.Time;
      Period  : Vision.Image_Grid.Period_Time;
      Slot    : out Vision.Frame_Slots.Slot;
      At_Time : out Ada.Real_Time.Time;
      Reserve : out Boolean;
      Found   : out Boolean;
      Coming  : out Boolean) is
   begin
      Store.Claim_Due (Now, Period, Slot, At_Time, Reserve, Found, Coming);
   end Claim_Due;

   procedure Wait_Look is
   begin
      Look.Wait;
   end Wait_Look;

   procedure Look_At_Silence (Now : Ada.Real_Time.Time) is
      Awaited : Boolean;
   begin
      Store.Look_At_Silence (Now, Awaited);
      Tell_If (Awaited);
   end Look_At_Silence;

   procedure Tell_If (Awaited : Boolean) is
   begin
      if Awaited then
         Trace.Release (Schedule.Th_Capture_Img);
         Look.Set;
      end if;
   end Tell_If;

   procedure Claim_Newest
     (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean) is
   begin
      Store.Claim_Newest (Slot, Found);
   end Claim_Newest;

   procedure Wait_Newest
     (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean) is
      Delivering : Boolean;
   begin
      loop
         Store.Get_Delivering (Delivering);
         Store.Claim_Newest (Slot, Found);
         exit when Found or else not Delivering;
         Trace.Wait (Schedule.Th_Arene, Trace.Camera);
         Changed.Wait;
         Trace.Resume (Schedule.Th_Arene);
      end loop;
   end Wait_Newest;

   procedure Get_Silent
     (Now : Ada.Real_Time.Time; Silent : out Boolean) is
   begin
      Store.Get_Silent (Now, Silent);
   end Get_Silent;

end Vision.Frame_Store;
