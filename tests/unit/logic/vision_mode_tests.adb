--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision's mode: F14 to F19, by the orders of one session.

with AUnit.Assertions; use AUnit.Assertions;

with Orders;
with Unit_Runs;        use Unit_Runs;
with Vision.Mode;      use Vision.Mode;
with Vision.Shapes;    use Vision.Shapes;

package body Vision_Mode_Tests is

   use type Orders.Ticket;

   Session : constant Orders.Ticket := 5;

   Initial   : constant State := (First => Session, others => <>);
   Streaming : constant State :=
     (Stage => Vision.Mode.Streaming, First => Session, others => <>);

   Arena : constant Arena_Corners := (others => (1, 2));

   S  : State;
   OK : Boolean;

   procedure Search (Found : Boolean) is
   begin
      Ask_Arena (S, Session, OK);
      Assert (OK and then S.Stage = Searching and then not Images_Flow (S),
              "the images stop with the search");
      Searched (S, Session, Found, Arena, OK);
      Assert (OK, "searched");
   end Search;

   procedure Open (Success : Boolean) is
      Is_Open : Boolean;
   begin
      Ask_Open (S, Session, OK, Is_Open);
      Assert (OK and then not Is_Open and then not Images_Flow (S),
              "no images before the camera is there");
      Opened (S, Session, Success, Is_Open);
      Assert (Is_Open = Success, "the outcome");
   end Open;

   procedure Test_Arena is
   begin
      S := Streaming;
      Search (Found => True);
      Assert (S.Stage = Deciding and then not Images_Flow (S)
              and then not Uses_Arena (S), "the decision is awaited");
      Decide (S, Session, Confirm => True, Valid => OK);
      Assert (OK and then Images_Flow (S) and then Uses_Arena (S)
              and then S.Arena = Arena,
              "confirmed: images with the arena");

      --  A second search instead of a decision

      Search (Found => True);
      Ask_Arena (S, Session, OK);
      Assert (OK and then S.Stage = Searching and then Uses_Arena (S),
              "searched again");
      Decide (S, Session, Confirm => False, Valid => OK);
      Assert (not OK and then S.Stage = Searching and then Uses_Arena (S),
              "nothing to decide during the search");
   end Test_Arena;

   procedure Test_Close is
   begin
      for Stage in Vision.Mode.Streaming .. Deciding loop
         S := (Stage, True, True, Arena, Arena, Session);
         Close (S, OK);
         Assert (OK and then S = Initial, "as at first, from " & Stage'Image);
         Open (Success => True);
         Assert (S = Streaming, "arena and positions are forgotten");
      end loop;
      Close_By_Order (S, Session, OK);
      Assert (OK and then S = Initial, "closed");
      Close (S, OK);
      Assert (not OK and then S = Initial, "closing what is closed");
   end Test_Close;

   procedure Test_Forget is
   begin
      S := (Vision.Mode.Streaming, True, True, Arena, No_Arena, Session);
      Search (Found => False);
      Assert (Uses_Arena (S), "a search in vain keeps the arena");
      Search (Found => True);
      Assert (Uses_Arena (S), "kept until the decision");
      Decide (S, Session, Confirm => False, Valid => OK);
      Assert (OK and then not Uses_Arena (S) and then Images_Flow (S)
              and then S.Position_On, "forgotten, the images resume");
   end Test_Forget;

   procedure Test_No_Arena is
   begin
      S := Initial;
      Ask_Arena (S, Session, OK);
      Assert (not OK and then S = Initial, "no camera, no search");
      S := Streaming;
      Search (Found => False);
      Assert (Images_Flow (S) and then not Uses_Arena (S),
              "the images go on");
      Decide (S, Session, Confirm => True, Valid => OK);
      Assert (not OK and then not Uses_Arena (S), "nothing to decide");
   end Test_No_Arena;

   procedure Test_Open is
      Is_Open : Boolean;
   begin
      S := Initial;
      Open (Success => False);
      Assert (S = Initial, "closed again");
      Open (Success => True);
      Assert (S = Streaming, "images flow");
      Ask_Open (S, Session, OK, Is_Open);
      Assert (not OK and then Is_Open and then S = Streaming,
              "open already");

      --  Given up

      S := Initial;
      Ask_Open (S, Session, OK, Is_Open);
      Close (S, Is_Open);
      Opened (S, Session, True, Is_Open);
      Assert (OK and then not Is_Open and then S = Initial,
              "closed stays closed");
   end Test_Open;

   procedure Test_Over is
      Is_Open : Boolean;
      Before  : State;
   begin
      for Stage in Stage_Kind loop
         Before := (Stage => Stage, First => Session, others => <>);
         S := Before;
         Ask_Open (S, Session - 1, OK, Is_Open);
         Assert (not OK and then not Is_Open, "open");
         Opened (S, Session - 1, True, Is_Open);
         Assert (not Is_Open, "opened");
         Close_By_Order (S, Session - 1, OK);
         Assert (not OK, "close");
         Ask_Arena (S, Session - 1, OK);
         Assert (not OK, "arena");
         Searched (S, Session - 1, True, Arena, OK);
         Assert (not OK, "searched");
         Decide (S, Session - 1, True, OK);
         Assert (not OK, "decided");
         Ask_Position (S, Session - 1, False, OK);
         Assert (not OK and then S = Before, "position");
      end loop;
   end Test_Over;

   procedure Test_Position is
   begin
      S := Initial;
      Ask_Position (S, Session, On => True, Accepted => OK);
      Assert (not OK and then not S.Position_On, "no camera, no position");
      Ask_Position (S, Session, On => False, Accepted => OK);
      Assert (OK and then not S.Position_On, "off what is off");
      S := Streaming;
      Ask_Position (S, Session, On => True, Accepted => OK);
      Assert (OK and then S.Position_On and then Images_Flow (S), "on");
      Search (Found => True);
      Assert (S.Position_On, "on during the search");
      Ask_Position (S, Session, On => False, Accepted => OK);
      Assert (OK and then not S.Position_On and then S.Stage = Deciding,
              "off");
   end Test_Position;

   procedure Add_Tests is
   begin
      Add_Test ("F14: the camera opens, or cannot be", Test_Open'Access);
      Add_Test ("F16: a close forgets everything", Test_Close'Access);
      Add_Test ("F17: no images until the decision", Test_Arena'Access);
      Add_Test ("F17: no arena found", Test_No_Arena'Access);
      Add_Test ("F17: a confirmed arena is forgotten", Test_Forget'Access);
      Add_Test ("F18, F19: positions", Test_Position'Access);
      Add_Test ("orders of an ended session", Test_Over'Access);
   end Add_Tests;

end Vision_Mode_Tests;
