--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Mode.Proof with SPARK_Mode is

   procedure Prove_Arena (Changes : History) is
      S      : State;
      Before : State;
      Asked  : Boolean := False;  --  an arena order awaits its decision
      Images : Natural := 0;      --  sent since that order
      Kept   : Boolean := False;  --  an arena has been confirmed
   begin
      for What of Changes loop
         pragma Loop_Invariant
           (Asked = (S.Stage in Searching | Deciding));
         pragma Loop_Invariant
           (if Asked then Images = (if S.Stage = Deciding then 1 else 0));
         pragma Loop_Invariant (S.Confirmed = Kept);
         --  meanwhile none is sent because its time has come
         pragma Assert (if Asked then not Images_Flow (S));
         Before := S;
         if Is_Possible (S, What) then
            S := After (S, What);
            if What = Arena_Found then
               Images := Images + 1;
            end if;
         end if;
         case What is
            when Arena_Order =>
               if Is_Open (Before) then
                  Asked := True;
                  Images := 0;
               end if;
            when Arena_Missing =>
               Asked := Asked and then Before.Stage = Deciding;
            when Camera_Closed =>
               Asked := False;
               Kept := False;
            when Confirmation | Rejection =>
               if Asked and then Images = 1 then
                  pragma Assert (Before.Stage = Deciding);
                  Asked := False;
                  Kept := What = Confirmation;
               else
                  --  no decision before the image has been sent
                  pragma Assert (S = Before);
               end if;
            when others =>
               null;
         end case;
         pragma Assert (S.Confirmed = Kept);
      end loop;
   end Prove_Arena;

end Vision.Mode.Proof;
