--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Mode with SPARK_Mode is

   procedure Ask_Open (S : in out State; Needed : out Boolean) is
   begin
      Needed := not Is_Open (S);
      if Needed then
         S.Stage := Opening;
      end if;
   end Ask_Open;

   procedure Opened (S : in out State; Success : Boolean) is
   begin
      if S.Stage = Opening then
         S.Stage := (if Success then Streaming else Closed);
      end if;
   end Opened;

   procedure Close (S : out State) is
   begin
      S := (others => <>);
   end Close;

   procedure Ask_Arena (S : in out State; Accepted : out Boolean) is
   begin
      Accepted := Is_Open (S);
      if Accepted then
         S.Stage := Searching;
      end if;
   end Ask_Arena;

   procedure Searched (S : in out State; Found : Boolean) is
   begin
      if S.Stage = Searching then
         S.Stage := (if Found then Deciding else Streaming);
      end if;
   end Searched;

   procedure Decide
     (S : in out State; Confirm : Boolean; Valid : out Boolean)
   is
   begin
      Valid := S.Stage = Deciding;
      if Valid then
         S.Stage := Streaming;
         S.Confirmed := Confirm;
      end if;
   end Decide;

   procedure Ask_Position
     (S : in out State; On : Boolean; Accepted : out Boolean)
   is
   begin
      Accepted := Is_Open (S) or else not On;
      if Accepted then
         S.Position_On := On;
      end if;
   end Ask_Position;

   procedure Follow
     (S : in out State; What : Event; Sends_Image : out Boolean)
   with Ghost
   is
      --  The effect on S, and whether an image is sent to the monitor: a
      --  periodic one, or the one with the arena
      Ignored : Boolean;
   begin
      Sends_Image := False;
      case What is
         when Open_Order =>
            if S.Stage /= Opening then
               Ask_Open (S, Ignored);
            end if;
         when Camera_Opened | Camera_Missing =>
            Opened (S, Success => What = Camera_Opened);
         when Camera_Closed =>
            Close (S);
         when Arena_Order =>
            Ask_Arena (S, Ignored);
         when Arena_Found | No_Arena_Found =>
            Sends_Image := What = Arena_Found and then S.Stage = Searching;
            Searched (S, Found => What = Arena_Found);
         when Confirmation | Rejection =>
            Decide (S, Confirm => What = Confirmation, Valid => Ignored);
         when Position_Order | Position_End =>
            Ask_Position
              (S, On => What = Position_Order, Accepted => Ignored);
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

end Vision.Mode;
