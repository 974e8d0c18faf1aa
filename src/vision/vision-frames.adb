--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Vision.Frames with SPARK_Mode is

   package Changed is new Event (Schedule.Th_Arene);
   --  An image has come, or none will

   package Look is new Event (Schedule.Th_Capture_Img);
   --  The same, or the camera is silent

   function Free_Slot (Uses : Slot_Uses; After : Slot) return Slot is
   begin
      for W in After + 1 .. Slot'Last loop
         if Is_Free (Uses, W) then
            return W;
         end if;
         pragma Loop_Invariant
           (for all X in After + 1 .. W => not Is_Free (Uses, X));
      end loop;
      for W in Slot'First .. After loop
         if Is_Free (Uses, W) then
            return W;
         end if;
         pragma Loop_Invariant
           (for all X in Slot'First .. W => not Is_Free (Uses, X));
      end loop;
      return After;
   end Free_Slot;

   procedure Claim
     (Uses : in out Slot_Uses; Which : out Slot; Found : out Boolean) is
      --  The newest image; the one before it is dropped
   begin
      Which := Uses.Newest;
      Found := Uses.Has_Newest;
      if Found then
         Uses := (Claimed => Uses.Claimed, others => <>);
         Uses.Claimed (Which) := True;
      end if;
   end Claim;

   procedure Tell_If (Awaited : Boolean) is
      --  Wakes th_captureImg
   begin
      if Awaited then
         Look.Set;
      end if;
   end Tell_If;

   protected body Store is

      procedure Begin_Delivery (At_Time : Time) is
      begin
         Uses := (Claimed => Uses.Claimed, others => <>);
         Is_On := True;
         Newest_Time := At_Time;
      end Begin_Delivery;

      procedure End_Delivery (Awaited : out Boolean) is
      begin
         Uses := (Claimed => Uses.Claimed, others => <>);
         Is_On := False;
         Awaited := Waits;
         Waits := False;
      end End_Delivery;

      procedure Claim_Empty (Which : out Slot) is
      begin
         Which := Free_Slot (Uses, Last_Claimed);
         if Is_Free (Uses, Which) then
            Uses.Claimed (Which) := True;
         end if;
         Last_Claimed := Which;
      end Claim_Empty;

      procedure Publish
        (Which : Slot; At_Time : Time; Awaited : out Boolean) is
      begin
         if Uses.Claimed (Which) then
            Uses.Claimed (Which) := False;
            if Is_On then
               Uses := (Claimed    => Uses.Claimed,
                        Has_Newest => True,
                        Newest     => Which,
                        Has_Older  => Uses.Has_Newest,
                        Older      => Uses.Newest);
               Older_Time := Newest_Time;
               Newest_Time := At_Time;
            end if;
         end if;
         Awaited := Waits;
         Waits := False;
      end Publish;

      procedure Release (Which : Slot) is
      begin
         Uses.Claimed (Which) := False;
      end Release;

      procedure Claim_Due
        (Now     : Time;
         Period  : Vision.Image_Grid.Period_Time;
         Which   : out Slot;
         At_Time : out Time;
         Reserve : out Boolean;
         Found   : out Boolean;
         Coming  : out Boolean) is
      begin
         Reserve := Uses.Has_Older
           and then Uses.Has_Newest
           and then Vision.Image_Grid.Sends_Older
             (Newest_Age => Vision.Image_Grid.Elapsed (Newest_Time, Now),
              Older_Age  => Vision.Image_Grid.Elapsed (Older_Time, Now),
              Period     => Period);
         if Reserve then
            Which := Uses.Older;
            Uses.Has_Older := False;
            Uses.Claimed (Which) := True;
            At_Time := Older_Time;
            Found := True;
         else
            Claim (Uses, Which, Found);
            At_Time := Newest_Time;
         end if;
         Coming := Is_On;
         Waits := Coming and then not Found;
      end Claim_Due;

      procedure Look_At_Silence (Now : Time; Awaited : out Boolean) is
      begin
         Awaited := Waits and then Now - Newest_Time > Schedule.Camera_Silence;
         Waits := Waits and then not Awaited;
      end Look_At_Silence;

      procedure Claim_Newest
        (Which : out Slot; Found : out Boolean; Coming : out Boolean) is
      begin
         Claim (Uses, Which, Found);
         Coming := Is_On;
      end Claim_Newest;

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

   procedure Publish (Which : Slot; At_Time : Time) is
      Awaited : Boolean;
   begin
      Store.Publish (Which, At_Time, Awaited);
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

   procedure Wait_Newest (Which : out Slot; Found : out Boolean) is
      Coming : Boolean;
   begin
      loop
         Store.Claim_Newest (Which, Found, Coming);
         exit when Found or else not Coming;
         Changed.Wait_In_Job (Trace.Camera);
      end loop;
   end Wait_Newest;

end Vision.Frames;
