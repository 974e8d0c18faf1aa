--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision (F14 to F19): what each order and event changes, and
--  what is to be sent. The vision's tasks carry it out.

with Commands; use Commands;

package Vision.Mode with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Mode);  --  proved

   type Stage_Kind is
     (Closed,      --  no camera
      Opening,     --  requested, not yet open
      Streaming,   --  periodic images
      Searching,   --  arena requested: no images
      Deciding);   --  its image has been sent: no images until the decision

   type State is record
      Stage       : Stage_Kind := Closed;
      Position_On : Boolean    := False;  --  F18, F19
      Confirmed   : Boolean    := False;
      --  an arena has been: it is drawn and limits the search for robots
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

   function Counts (S : State; Number : Ticket) return Boolean is
     (Number >= S.First);
   --  The order's session has not ended

   type Change is
     (Open_Order,       --  F14
      Camera_Opened,
      Camera_Missing,   --  it could not be opened
      Camera_Closed,    --  F6, F16, and a failure of the camera
      Arena_Order,      --  F17: the images pause, the search begins
      Arena_Found,      --  its image is sent, and the decision awaited
      Arena_Missing,    --  the images resume
      Confirmation,     --  the arena is used from now on, the images resume
      Rejection,        --  none is used, the images resume
      Position_Start,   --  F18
      Position_End);    --  F19

   function Is_Possible (S : State; What : Change) return Boolean is
     (case What is
         when Open_Order                     => S.Stage = Closed,
         when Camera_Opened | Camera_Missing => S.Stage = Opening,
         when Arena_Order | Position_Start   => Is_Open (S),
         when Arena_Found | Arena_Missing    => S.Stage = Searching,
         when Confirmation | Rejection       => S.Stage = Deciding,
         when Camera_Closed | Position_End   => True);

   function After
     (S : State; What : Change; Found : Arena_Corners := No_Arena)
      return State
   is (Stage       =>
         (case What is
             when Open_Order                    => Opening,
             when Camera_Missing | Camera_Closed => Closed,
             when Arena_Order                   => Searching,
             when Arena_Found                   => Deciding,
             when Camera_Opened | Arena_Missing
                | Confirmation | Rejection      => Streaming,
             when Position_Start | Position_End => S.Stage),
       Position_On =>
         (S.Position_On or else What = Position_Start)
         and then What not in Position_End | Camera_Closed,
       Confirmed   =>
         (S.Confirmed or else What = Confirmation)
         and then What not in Rejection | Camera_Closed,
       Arena       =>
         (case What is
             when Confirmation              => S.Candidate,
             when Rejection | Camera_Closed => No_Arena,
             when others                    => S.Arena),
       Candidate   => (if What = Arena_Found then Found else S.Candidate),
       First       => S.First)
   with Pre => Is_Possible (S, What);
   --  Found: of Arena_Found

end Vision.Mode;
