--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision (F14 to F19): what each command and event does to
--  it, and what is to be sent. Decides; the vision tasks carry out.

package Vision_Mode with SPARK_Mode, Pure is

   type Stage_Kind is
     (Closed,      --  no camera
      Opening,     --  asked for, not yet there
      Streaming,   --  periodic images
      Searching,   --  arena asked for: no images
      Deciding);   --  its image has gone out: no images until the decision

   type State is record
      Stage       : Stage_Kind := Closed;
      Position_On : Boolean    := False;  --  F18, F19
      Confirmed   : Boolean    := False;  --  an arena has been confirmed
   end record;
   --  The initial state: camera closed, nothing computed, no arena

   function Is_Consistent (S : State) return Boolean is
     (if S.Stage in Closed | Opening
      then not S.Position_On and then not S.Confirmed);

   function Images_Flow (S : State) return Boolean is (S.Stage = Streaming);
   --  Whether periodic images are sent

   function Is_Open (S : State) return Boolean is
     (S.Stage in Streaming | Searching | Deciding);

   function Uses_Arena (S : State) return Boolean is (S.Confirmed);
   --  Whether the arena is drawn and limits the search for robots

   procedure Ask_Open (S : in out State; Needed : out Boolean)
   with
     Pre  => Is_Consistent (S) and then S.Stage /= Opening,
     Post => Is_Consistent (S) and then Needed = not Is_Open (S'Old)
       and then (if Needed then S.Stage = Opening else S = S'Old);
   --  F14. Needed: the camera is to be opened now

   procedure Opened (S : in out State; Success : Boolean)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Consistent (S)
       and then (if S.Stage /= S'Old.Stage then S'Old.Stage = Opening);
   --  The camera is there, or could not be opened. Without effect where the
   --  opening has been given up meanwhile

   procedure Close (S : out State)
   with Post => Is_Consistent (S) and then S = (others => <>);
   --  F16, F6, and a camera that fails

   procedure Ask_Arena (S : in out State; Accepted : out Boolean)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Consistent (S) and then Accepted = Is_Open (S'Old)
       and then (if Accepted then S.Stage = Searching else S = S'Old);
   --  F17: the images stop, the search begins

   procedure Searched (S : in out State; Found : Boolean)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Consistent (S)
       and then S.Confirmed = S'Old.Confirmed
       and then (if S'Old.Stage = Searching
                 then S.Stage = (if Found then Deciding else Streaming)
                 else S = S'Old);
   --  F17: an image with the arena goes out and the decision is awaited, or
   --  none was found and the images go on as before

   procedure Decide
     (S : in out State; Confirm : Boolean; Valid : out Boolean)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Consistent (S) and then Valid = (S'Old.Stage = Deciding)
       and then (if Valid
                 then S.Stage = Streaming and then S.Confirmed = Confirm
                 else S = S'Old);
   --  F17: kept or forgotten; either way the images resume. Without effect
   --  where no decision is awaited

   procedure Ask_Position
     (S : in out State; On : Boolean; Accepted : out Boolean)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Consistent (S)
       and then Accepted = (Is_Open (S'Old) or else not On)
       and then S.Stage = S'Old.Stage
       and then S.Confirmed = S'Old.Confirmed;
   --  F18, F19. Refused where the camera is not open; switching off what is
   --  off is accepted

end Vision_Mode;
