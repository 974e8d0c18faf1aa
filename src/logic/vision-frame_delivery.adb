--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Frame_Delivery with SPARK_Mode is

   function Elapsed
     (First, Last : Time) return Vision.Image_Grid.Microseconds is
      Longest : constant Integer :=
        Integer (Vision.Image_Grid.Microseconds'Last);
   begin
      return Vision.Image_Grid.Microseconds
        (if Last - First >= Microseconds (Longest) then Longest
         else Integer'Max
           (0, Integer'Min (Longest, (Last - First) / Microseconds (1))));
   end Elapsed;

   procedure Begin_Delivery (S : in out State; At_Time : Time) is
   begin
      Begin_Delivery (S.Uses);
      S.Newest_Time := At_Time;
   end Begin_Delivery;

   procedure End_Delivery (S : in out State; Awaited : out Boolean) is
   begin
      End_Delivery (S.Uses);
      Awaited := S.Waits;
      S.Waits := False;
   end End_Delivery;

   procedure Publish
     (S : in out State; Which : Slot; At_Time : Time; Awaited : out Boolean)
   is
   begin
      Publish (S.Uses, Which);
      if Is_Delivering (S.Uses) then
         S.Older_Time := S.Newest_Time;
         S.Newest_Time := At_Time;
      end if;
      Awaited := S.Waits;
      S.Waits := False;
   end Publish;

   procedure Claim_Due
     (S       : in out State;
      Now     : Time;
      Period  : Vision.Image_Grid.Period_Time;
      Which   : out Slot;
      At_Time : out Time;
      Reserve : out Boolean;
      Found   : out Boolean;
      Coming  : out Boolean) is
   begin
      Reserve := Is_Reserve (S, Now, Period);
      if Reserve then
         Claim_Older (S.Uses, Which);
         At_Time := S.Older_Time;
         Found := True;
      else
         Claim_Newest (S.Uses, Which, Found);
         At_Time := S.Newest_Time;
      end if;
      Coming := Is_Delivering (S.Uses);
      S.Waits := Coming and then not Found;
   end Claim_Due;

   procedure Look_At_Silence
     (S : in out State; Now : Time; Awaited : out Boolean) is
   begin
      Awaited := S.Waits and then Is_Silent (S, Now);
      S.Waits := S.Waits and then not Awaited;
   end Look_At_Silence;

end Vision.Frame_Delivery;
