--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision (F14 to F19): the effect of each order and event,
--  and what is to be sent. The vision tasks carry it out. Orders of an ended
--  session are refused.

with Orders; use Orders;
with Vision.Shapes; use Vision.Shapes;

package Vision.Mode with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Mode);

   type Stage_Kind is
     (Closed,      --  no camera
      Opening,     --  requested, not yet open
      Streaming,   --  periodic images
      Searching,   --  arena requested: no images
      Deciding);   --  its image has been sent: no images until the decision

   type State is record
      Stage       : Stage_Kind := Closed;
      Position_On : Boolean    := False;  --  F18, F19
      Confirmed   : Boolean    := False;  --  an arena has been confirmed:
      Arena       : Arena_Corners := No_Arena;
      Candidate   : Arena_Corners := No_Arena;
      --  the arena that awaits its decision
      First       : Ticket := 0;
      --  number of the session's first order
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

   function Counts (S : State; Number : Ticket) return Boolean is
     (Number >= S.First);
   --  The order's session has not ended

   function Is_Kept (S, Before : State) return Boolean is
     (S.Position_On = Before.Position_On
      and then S.Confirmed = Before.Confirmed
      and then S.Arena = Before.Arena
      and then S.First = Before.First)
   with Ghost;
   --  All but the stage and the candidate

   procedure Begin_Session (S : out State; Number : Ticket)
   with Post => S = State'(First => Number, others => <>);

   procedure Ask_Open
     (S       : in out State;
      Number  : Ticket;
      Needed  : out Boolean;
      Is_Open : out Boolean)
   with
     Post => Needed = (Counts (S, Number) and then S'Old.Stage = Closed)
       and then Is_Open =
         (Counts (S, Number) and then Vision.Mode.Is_Open (S'Old))
       and then (if Needed then S.Stage = Opening and then Is_Kept (S, S'Old)
                 else S = S'Old);
   --  F14. Needed: the camera must be opened now

   procedure Opened
     (S       : in out State;
      Number  : Ticket;
      Success : Boolean;
      Is_Open : out Boolean)
   with
     Post => Is_Open =
         (Success and then Counts (S, Number) and then S'Old.Stage = Opening)
       and then
         (if Counts (S, Number) and then S'Old.Stage = Opening then
             S.Stage = (if Success then Streaming else Closed)
             and then Is_Kept (S, S'Old)
          else S = S'Old);
   --  The camera is open, or could not be opened. No effect if it has been
   --  closed meanwhile

   procedure Close (S : in out State; Was_Open : out Boolean)
   with
     Post => Was_Open = Is_Open (S'Old)
       and then S = State'(First => S'Old.First, others => <>);
   --  F6, and a failure of the camera

   procedure Close_By_Order
     (S : in out State; Number : Ticket; Done : out Boolean)
   with
     Post => Done = Counts (S'Old, Number)
       and then S =
         (if Done then State'(First => S'Old.First, others => <>) else S'Old);
   --  F16

   procedure Ask_Arena
     (S : in out State; Number : Ticket; Accepted : out Boolean)
   with
     Post => Accepted = (Counts (S, Number) and then Is_Open (S'Old))
       and then
         (if Accepted then S.Stage = Searching and then Is_Kept (S, S'Old)
          else S = S'Old);
   --  F17: the images pause, the search begins

   procedure Searched
     (S      : in out State;
      Number : Ticket;
      Found  : Boolean;
      Arena  : Arena_Corners;
      Valid  : out Boolean)
   with
     Post => Valid =
         (Counts (S, Number) and then S'Old.Stage = Searching)
       and then
         (if Valid then
             S.Stage = (if Found then Deciding else Streaming)
             and then S.Candidate = Arena
             and then Is_Kept (S, S'Old)
          else S = S'Old);
   --  F17: an image with the arena is sent and the decision is awaited, or
   --  none was found and the images resume. Not valid: the search has been
   --  cancelled meanwhile

   procedure Decide
     (S       : in out State;
      Number  : Ticket;
      Confirm : Boolean;
      Valid   : out Boolean)
   with
     Post => Valid = (Counts (S, Number) and then S'Old.Stage = Deciding)
       and then
         (if Valid then
             S.Stage = Streaming
             and then S.Position_On = S'Old.Position_On
             and then S.Confirmed = Confirm
             and then S.Arena =
               (if Confirm then S'Old.Candidate else No_Arena)
             and then S.First = S'Old.First
          else S = S'Old);
   --  F17: kept or discarded; in both cases the images resume

   procedure Ask_Position
     (S        : in out State;
      Number   : Ticket;
      On       : Boolean;
      Accepted : out Boolean)
   with
     Post => Accepted =
         (Counts (S, Number) and then (Is_Open (S'Old) or else not On))
       and then
         (if Accepted then
             S.Stage = S'Old.Stage
             and then S.Position_On = On
             and then S.Confirmed = S'Old.Confirmed
             and then S.Arena = S'Old.Arena
             and then S.First = S'Old.First
          else S = S'Old);
   --  F18, F19. Refused if the camera is not open; switching off twice is
   --  accepted

end Vision.Mode;
