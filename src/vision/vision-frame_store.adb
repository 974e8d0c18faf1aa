--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Vision.Frame_Store with SPARK_Mode is

   package Changed is new Event;
   --  An image has come, or none will. Awaited by th_arene

   package Look is new Event;
   --  The same, or the camera is silent. Awaited by th_captureImg

   procedure Tell_If (Awaited : Boolean) is
      --  Wakes th_captureImg
   begin
      if Awaited then
         Trace.Release (Schedule.Th_Capture_Img);
         Look.Set;
      end if;
   end Tell_If;

   protected body Store is

      procedure Begin_Delivery (At_Time : Time) is
      begin
         Vision.Frame_Slots.Begin_Delivery (Uses);
         Newest_Time := At_Time;
      end Begin_Delivery;

      procedure End_Delivery (Awaited : out Boolean) is
      begin
         Vision.Frame_Slots.End_Delivery (Uses);
         Awaited := Waits;
         Waits := False;
      end End_Delivery;

      procedure Claim_Empty (Slot : out Vision.Frame_Slots.Slot) is
      begin
         Vision.Frame_Slots.Claim_Empty (Uses, Slot);
      end Claim_Empty;

      procedure Publish
        (Slot    : Vision.Frame_Slots.Slot;
         At_Time : Time;
         Awaited : out Boolean) is
      begin
         Vision.Frame_Slots.Publish (Uses, Slot);
         if Vision.Frame_Slots.Is_Delivering (Uses) then
            Older_Time := Newest_Time;
            Newest_Time := At_Time;
         end if;
         Awaited := Waits;
         Waits := False;
      end Publish;

      procedure Release (Slot : Vision.Frame_Slots.Slot) is
      begin
         Vision.Frame_Slots.Release (Uses, Slot);
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
         Reserve := Vision.Frame_Slots.Has_Older (Uses)
           and then Vision.Frame_Slots.Has_Newest (Uses)
           and then Vision.Image_Grid.Sends_Older
             (Newest_Age => Vision.Image_Grid.Elapsed (Newest_Time, Now),
              Older_Age  => Vision.Image_Grid.Elapsed (Older_Time, Now),
              Period     => Period);
         if Reserve then
            Vision.Frame_Slots.Claim_Older (Uses, Slot);
            At_Time := Older_Time;
            Found := True;
         else
            Vision.Frame_Slots.Claim_Newest (Uses, Slot, Found);
            At_Time := Newest_Time;
         end if;
         Coming := Vision.Frame_Slots.Is_Delivering (Uses);
         Waits := Coming and then not Found;
      end Claim_Due;

      procedure Look_At_Silence (Now : Time; Awaited : out Boolean) is
      begin
         Awaited := Waits and then Now - Newest_Time > Schedule.Camera_Silence;
         Waits := Waits and then not Awaited;
      end Look_At_Silence;

      procedure Claim_Newest
        (Slot : out Vision.Frame_Slots.Slot; Found : out Boolean) is
      begin
         Vision.Frame_Slots.Claim_Newest (Uses, Slot, Found);
      end Claim_Newest;

      procedure Get_Delivering (Now : out Boolean) is
      begin
         Now := Vision.Frame_Slots.Is_Delivering (Uses);
      end Get_Delivering;

      procedure Get_Silent (Now : Time; Silent : out Boolean) is
      begin
         Silent := Now - Newest_Time > Schedule.Camera_Silence;
      end Get_Silent;

   end Store;

   procedure End_Delivery is
      Awaited : Boolean;
   begin
      Store.End_Delivery (Awaited);
      Changed.Set;
      Tell_If (Awaited);
   end End_Delivery;

   procedure Publish (Slot : Vision.Frame_Slots.Slot; At_Time : Time) is
      Awaited : Boolean;
   begin
      Store.Publish (Slot, At_Time, Awaited);
      Changed.Set;
      Tell_If (Awaited);
   end Publish;

   procedure Wait_Look is
   begin
      Look.Wait;
   end Wait_Look;

   procedure Look_At_Silence (Now : Time) is
      Awaited : Boolean;
   begin
      Store.Look_At_Silence (Now, Awaited);
      Tell_If (Awaited);
   end Look_At_Silence;

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

end Vision.Frame_Store;
