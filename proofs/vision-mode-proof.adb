--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Mode.Proof with SPARK_Mode is

   procedure Follow
     (S : in out State; What : Event; Sends_Image : out Boolean)
   is
      --  The effect on S, and whether an image is sent to the monitor: a
      --  periodic one, or the one with the arena
      Number               : constant Ticket := S.First;
      Ignored, Ignored_Too : Boolean;
   begin
      Sends_Image := False;
      case What is
         when Open_Order =>
            Ask_Open (S, Number, Ignored, Ignored_Too);
         when Camera_Opened | Camera_Missing =>
            Opened (S, Number, What = Camera_Opened, Ignored);
         when Camera_Closed =>
            Close (S, Ignored);
         when Arena_Order =>
            Ask_Arena (S, Number, Ignored);
         when Arena_Found | No_Arena_Found =>
            Sends_Image := What = Arena_Found and then S.Stage = Searching;
            Searched (S, Number, What = Arena_Found, No_Arena, Ignored);
         when Confirmation | Rejection =>
            Decide (S, Number, What = Confirmation, Ignored);
         when Position_Order | Position_End =>
            Ask_Position (S, Number, What = Position_Order, Ignored);
         when Image_Due =>
            Sends_Image := Images_Flow (S);
      end case;
   end Follow;

   procedure Prove_Arena (Events : History) is
      S      : State;
      Before : State;
      Image  : Boolean;
      Asked  : Boolean := False;  --  an arena order awaits its decision
      Images : Natural := 0;      --  sent since that order
      Kept   : Boolean := False;  --  an arena has been confirmed
   begin
      for What of Events loop
         pragma Loop_Invariant
           (Asked = (S.Stage in Searching | Deciding));
         pragma Loop_Invariant
           (if Asked then Images = (if S.Stage = Deciding then 1 else 0));
         pragma Loop_Invariant (Uses_Arena (S) = Kept);
         Before := S;
         Follow (S, What, Image);
         if Asked and then Image then
            Images := Images + 1;
         end if;
         case What is
            when Arena_Order =>
               if Is_Open (Before) then
                  Asked := True;
                  Images := 0;
               end if;
            when No_Arena_Found =>
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
         pragma Assert (Uses_Arena (S) = Kept);
      end loop;
   end Prove_Arena;

end Vision.Mode.Proof;
