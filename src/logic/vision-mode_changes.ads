--  SPDX-License-Identifier: GPL-3.0-or-later
--  The effect of orders and events on the mode of the vision and its arena.
--  Orders of an ended session are refused.

with Orders;
with Vision.Mode;
with Vision.Shapes;

package Vision.Mode_Changes with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Mode_Changes);

   use type Orders.Ticket;
   use type Vision.Mode.Stage_Kind;
   use type Vision.Shapes.Arena_Corners;

   type View is record
      Mode  : Vision.Mode.State;
      Arena : Vision.Shapes.Arena_Corners := Vision.Shapes.No_Arena;
      --  the confirmed one, where Mode.Confirmed
   end record;

   type State is record
      First     : Orders.Ticket := 0;
      --  number of the session's first order
      Seen      : View;
      Candidate : Vision.Shapes.Arena_Corners := Vision.Shapes.No_Arena;
      --  the arena that awaits its decision
   end record;

   function Counts (S : State; Number : Orders.Ticket) return Boolean is
     (Number >= S.First);
   --  The order's session has not ended

   function Is_Open (S : State) return Boolean is
     (Vision.Mode.Is_Open (S.Seen.Mode));

   procedure Begin_Session (S : in out State; Number : Orders.Ticket)
   with Post => S.First = Number
     and then S.Seen.Mode.Stage = Vision.Mode.Closed
     and then S.Seen.Arena = Vision.Shapes.No_Arena;

   procedure Ask_Open
     (S       : in out State;
      Number  : Orders.Ticket;
      Needed  : out Boolean;
      Is_Open : out Boolean)
   with
     Post =>
       (if Counts (S'Old, Number)
          and then S'Old.Seen.Mode.Stage /= Vision.Mode.Opening
        then Is_Open = Vision.Mode_Changes.Is_Open (S'Old)
          and then Needed = not Is_Open
          and then (if Needed then S.Seen.Mode.Stage = Vision.Mode.Opening
                    else S = S'Old)
        else S = S'Old and then not Needed and then not Is_Open);
   --  Needed: the camera must be opened now

   procedure Opened
     (S       : in out State;
      Number  : Orders.Ticket;
      Success : Boolean;
      Is_Open : out Boolean)
   with
     Post =>
       (if Counts (S'Old, Number)
        then Is_Open = Vision.Mode_Changes.Is_Open (S)
        else S = S'Old and then not Is_Open);

   procedure Close (S : in out State; Was_Open : out Boolean)
   with Post => Was_Open = Is_Open (S'Old)
     and then S.Seen.Mode.Stage = Vision.Mode.Closed
     and then S.First = S'Old.First;

   procedure Close_By_Order
     (S : in out State; Number : Orders.Ticket; Done : out Boolean)
   with
     Post => Done = Counts (S'Old, Number)
       and then (if Done then S.Seen.Mode.Stage = Vision.Mode.Closed
                 else S = S'Old);

   procedure Ask_Arena
     (S : in out State; Number : Orders.Ticket; Accepted : out Boolean)
   with
     Post => Accepted = (Counts (S'Old, Number) and then Is_Open (S'Old))
       and then (if Accepted then S.Seen.Mode.Stage = Vision.Mode.Searching
                 else S = S'Old);

   procedure Searched
     (S      : in out State;
      Number : Orders.Ticket;
      Found  : Boolean;
      Arena  : Vision.Shapes.Arena_Corners;
      Valid  : out Boolean)
   with
     Post => Valid =
         (Counts (S'Old, Number)
          and then S'Old.Seen.Mode.Stage = Vision.Mode.Searching)
       and then (if Valid then S.Candidate = Arena else S = S'Old)
       and then S.Seen.Arena = S'Old.Seen.Arena;

   procedure Decide
     (S       : in out State;
      Number  : Orders.Ticket;
      Confirm : Boolean;
      Valid   : out Boolean)
   with
     Post => Valid =
         (Counts (S'Old, Number)
          and then S'Old.Seen.Mode.Stage = Vision.Mode.Deciding)
       and then
         (if Valid then
             S.Seen.Mode.Confirmed = Confirm
             and then S.Seen.Arena =
               (if Confirm then S'Old.Candidate else Vision.Shapes.No_Arena)
          else S = S'Old);

   procedure Ask_Position
     (S        : in out State;
      Number   : Orders.Ticket;
      On       : Boolean;
      Accepted : out Boolean)
   with
     Post => Accepted =
         (Counts (S'Old, Number) and then (Is_Open (S'Old) or else not On))
       and then (if Accepted then S.Seen.Mode.Position_On = On
                 else S = S'Old);

end Vision.Mode_Changes;
