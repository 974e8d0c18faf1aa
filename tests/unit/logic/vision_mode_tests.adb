--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision's mode: F14 to F19, and everything from every state.

with AUnit.Assertions; use AUnit.Assertions;

with Vision.Mode;      use Vision.Mode;
with Unit_Runs; use Unit_Runs;

package body Vision_Mode_Tests is

   function Streaming_State return State is
     ((Stage => Streaming, others => <>));

   procedure Test_Arena is
      S  : State := Streaming_State;
      OK : Boolean;
   begin
      Ask_Arena (S, OK);
      Assert (OK and then S.Stage = Searching and then not Images_Flow (S),
              "the images stop with the search");
      Searched (S, Found => True);
      Assert (S.Stage = Deciding and then not Images_Flow (S)
              and then not Uses_Arena (S), "the decision is awaited");
      Decide (S, Confirm => True, Valid => OK);
      Assert (OK and then Images_Flow (S) and then Uses_Arena (S),
              "confirmed: images with the arena");

      --  A second search instead of a decision

      Ask_Arena (S, OK);
      Searched (S, Found => True);
      Ask_Arena (S, OK);
      Assert (OK and then S.Stage = Searching and then Uses_Arena (S),
              "searched again");
      Decide (S, Confirm => False, Valid => OK);
      Assert (not OK and then S.Stage = Searching and then Uses_Arena (S),
              "nothing to decide during the search");
   end Test_Arena;

   procedure Test_Close is
      Initial : constant State := (others => <>);
      S       : State;
      OK      : Boolean;
   begin
      for Stage in Streaming .. Deciding loop
         S := (Stage => Stage, Position_On => True, Confirmed => True);
         Assert (Is_Open (S) and then Uses_Arena (S), "open");
         Close (S);
         Assert (S = Initial, "as at first, from " & Stage'Image);
         Ask_Open (S, OK);
         Assert (OK, "to be opened again");
         Opened (S, Success => True);
         Assert (S = Streaming_State, "arena and positions are forgotten");
      end loop;
      Close (S);
      Assert (S = Initial, "closed");
      Close (S);
      Assert (S = Initial, "closing what is closed");
   end Test_Close;

   procedure Test_Everything is
      Before, S : State;
      OK        : Boolean;
      Count     : Natural := 0;
   begin
      for Stage in Stage_Kind loop
         for Position in Boolean loop
            for Confirmed in Boolean loop
               if Stage in Streaming .. Deciding
                 or else (not Position and then not Confirmed)
               then
                  Before := (Stage, Position, Confirmed);
                  Count := Count + 1;
                  for Flag in Boolean loop
                     S := Before;
                     Opened (S, Flag);
                     Assert
                       ((if Stage /= Opening then S = Before
                         else S.Stage = (if Flag then Streaming
                                         else Closed)),
                        "opened");

                     S := Before;
                     Searched (S, Flag);
                     Assert
                       ((if Stage /= Searching then S = Before
                         else S.Stage = (if Flag then Deciding
                                         else Streaming)
                           and then S.Position_On = Position
                           and then S.Confirmed = Confirmed),
                        "searched");

                     S := Before;
                     Decide (S, Flag, OK);
                     Assert
                       (OK = (Stage = Deciding)
                        and then
                          S = (if OK then (Streaming, Position, Flag)
                               else Before),
                        "decided");

                     S := Before;
                     Ask_Position (S, Flag, OK);
                     Assert
                       (OK = (Is_Open (Before) or else not Flag)
                        and then
                          S = (if OK then (Stage, Flag, Confirmed)
                               else Before),
                        "position");
                  end loop;

                  S := Before;
                  Ask_Arena (S, OK);
                  Assert
                    (OK = Is_Open (Before)
                     and then
                       S = (if OK then (Searching, Position, Confirmed)
                            else Before),
                     "arena");

                  if Stage /= Opening then
                     S := Before;
                     Ask_Open (S, OK);
                     Assert
                       (OK = (Stage = Closed)
                        and then
                          S = (if OK then (Opening, False, False)
                               else Before),
                        "open");
                  end if;
               end if;
            end loop;
         end loop;
      end loop;
      Assert (Count = 14, "two states without and twelve with a camera");
   end Test_Everything;

   procedure Test_Forget is
      S  : State := (Streaming, Position_On => True, Confirmed => True);
      OK : Boolean;
   begin
      Ask_Arena (S, OK);
      Searched (S, Found => False);
      Assert (Uses_Arena (S), "a search in vain keeps the arena");
      Ask_Arena (S, OK);
      Searched (S, Found => True);
      Assert (Uses_Arena (S), "kept until the decision");
      Decide (S, Confirm => False, Valid => OK);
      Assert (OK and then not Uses_Arena (S) and then Images_Flow (S)
              and then S.Position_On, "forgotten, the images resume");
   end Test_Forget;

   procedure Test_Given_Up is
      S  : State;
      OK : Boolean;
   begin
      Ask_Open (S, OK);
      Close (S);
      Opened (S, Success => True);
      Assert (S = State'(others => <>), "closed stays closed");
      Ask_Open (S, OK);
      Assert (OK, "to be opened anew");
   end Test_Given_Up;

   procedure Test_No_Arena is
      S  : State;
      OK : Boolean;
   begin
      Ask_Arena (S, OK);
      Assert (not OK and then S.Stage = Closed, "no camera, no search");
      S := Streaming_State;
      Ask_Arena (S, OK);
      Searched (S, Found => False);
      Assert (Images_Flow (S) and then not Uses_Arena (S),
              "the images go on");
      Decide (S, Confirm => True, Valid => OK);
      Assert (not OK and then not Uses_Arena (S), "nothing to decide");
   end Test_No_Arena;

   procedure Test_Not_Opened is
      S  : State;
      OK : Boolean;
   begin
      Ask_Open (S, OK);
      Opened (S, Success => False);
      Assert (S = State'(others => <>), "closed again");
      Ask_Open (S, OK);
      Assert (OK and then S.Stage = Opening, "tried again");
   end Test_Not_Opened;

   procedure Test_Open is
      S  : State;
      OK : Boolean;
   begin
      Assert (S.Stage = Closed and then not Is_Open (S)
              and then not Images_Flow (S) and then not Uses_Arena (S),
              "closed at first");
      Ask_Open (S, OK);
      Assert (OK and then not Is_Open (S) and then not Images_Flow (S),
              "no images before the camera is there");
      Opened (S, Success => True);
      Assert (Is_Open (S) and then Images_Flow (S), "images flow");
      Ask_Open (S, OK);
      Assert (not OK and then S = Streaming_State, "open already");
   end Test_Open;

   procedure Test_Position is
      S  : State;
      OK : Boolean;
   begin
      Ask_Position (S, On => True, Accepted => OK);
      Assert (not OK and then not S.Position_On, "no camera, no position");
      Ask_Position (S, On => False, Accepted => OK);
      Assert (OK and then not S.Position_On, "off what is off");
      S := Streaming_State;
      Ask_Position (S, On => True, Accepted => OK);
      Assert (OK and then S.Position_On and then Images_Flow (S), "on");
      Ask_Arena (S, OK);
      Assert (S.Position_On, "on during the search");
      Ask_Position (S, On => False, Accepted => OK);
      Assert (OK and then not S.Position_On and then S.Stage = Searching,
              "off");
   end Test_Position;

   procedure Add_Tests is
   begin
      Add_Test ("F14: the camera opens", Test_Open'Access);
      Add_Test ("F14: the camera cannot be opened", Test_Not_Opened'Access);
      Add_Test ("an opening that was given up", Test_Given_Up'Access);
      Add_Test ("F16: a close forgets everything", Test_Close'Access);
      Add_Test ("F17: no images until the decision", Test_Arena'Access);
      Add_Test ("F17: no arena found", Test_No_Arena'Access);
      Add_Test ("F17: a confirmed arena is forgotten", Test_Forget'Access);
      Add_Test ("F18, F19: positions", Test_Position'Access);
      Add_Test ("everything from every state", Test_Everything'Access);
   end Add_Tests;

end Vision_Mode_Tests;
