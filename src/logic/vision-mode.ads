--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision (F14 to F19): the effect of each command and event,
--  and what is to be sent. The vision tasks carry it out.

package Vision.Mode with SPARK_Mode, Pure is

   type Stage_Kind is
     (Closed,      --  no camera
      Opening,     --  requested, not yet open
      Streaming,   --  periodic images
      Searching,   --  arena requested: no images
      Deciding);   --  its image has been sent: no images until the decision

   type State is record
      Stage       : Stage_Kind := Closed;
      Position_On : Boolean    := False;  --  F18, F19
      Confirmed   : Boolean    := False;  --  an arena has been confirmed
   end record
   with Dynamic_Predicate =>
     (if State.Stage in Closed | Opening
      then not State.Position_On and then not State.Confirmed);
   --  The initial state: camera closed, nothing computed, no arena. Without
   --  a camera it is always so

   function Images_Flow (S : State) return Boolean is (S.Stage = Streaming);
   --  Periodic images are sent

   function Is_Open (S : State) return Boolean is
     (S.Stage in Streaming | Searching | Deciding);

   function Uses_Arena (S : State) return Boolean is (S.Confirmed);
   --  The arena is drawn and limits the search for robots

   procedure Ask_Open (S : in out State; Needed : out Boolean)
   with
     Pre  => S.Stage /= Opening,
     Post => Needed = not Is_Open (S'Old)
       and then S = (if Needed then (Opening, False, False) else S'Old);
   --  F14. Needed: the camera must be opened now

   procedure Opened (S : in out State; Success : Boolean)
   with
     Post => S =
       (if S'Old.Stage /= Opening then S'Old
        elsif Success then (Streaming, False, False)
        else (Closed, False, False));
   --  The camera is open, or could not be opened. No effect if it has been
   --  closed meanwhile

   procedure Close (S : out State)
   with Post => S = (Closed, False, False);
   --  F16, F6, and a failure of the camera

   procedure Ask_Arena (S : in out State; Accepted : out Boolean)
   with
     Post => Accepted = Is_Open (S'Old)
       and then S =
         (if Accepted then (Searching, S'Old.Position_On, S'Old.Confirmed)
          else S'Old);
   --  F17: the images pause, the search begins

   procedure Searched (S : in out State; Found : Boolean)
   with
     Post => S =
       (if S'Old.Stage /= Searching then S'Old
        elsif Found then (Deciding, S'Old.Position_On, S'Old.Confirmed)
        else (Streaming, S'Old.Position_On, S'Old.Confirmed));
   --  F17: an image with the arena is sent and the decision is awaited, or
   --  none was found and the images resume

   procedure Decide
     (S : in out State; Confirm : Boolean; Valid : out Boolean)
   with
     Post => Valid = (S'Old.Stage = Deciding)
       and then S =
         (if Valid then (Streaming, S'Old.Position_On, Confirm)
          else S'Old);
   --  F17: kept or discarded; in both cases the images resume. No effect if no
   --  decision is awaited

   procedure Ask_Position
     (S : in out State; On : Boolean; Accepted : out Boolean)
   with
     Post => Accepted = (Is_Open (S'Old) or else not On)
       and then S =
         (if Accepted then (S'Old.Stage, On, S'Old.Confirmed) else S'Old);
   --  F18, F19. Refused if the camera is not open; switching off twice is
   --  accepted

   --  Properties of all sequences

   type Event is
     (Open_Order,
      Camera_Opened,
      Camera_Missing,
      Camera_Closed,
      Arena_Order,
      Arena_Found,
      No_Arena_Found,
      Confirmation,
      Rejection,
      Position_Order,
      Position_End,
      Image_Due)         --  the period of the images
   with Ghost;

   type History is array (Positive range <>) of Event with Ghost;

   procedure Prove_Arena (Events : History) with Ghost;
   --  From the initial state, for any sequence: exactly one image is sent
   --  between an arena order and its decision (the one with the arena, once it
   --  is found; no periodic ones), and an arena is in use only from its
   --  confirmation to the next rejection or closing of the camera. Asserted in
   --  the body

end Vision.Mode;
