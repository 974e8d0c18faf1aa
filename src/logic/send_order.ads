--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which of the messages that wait goes to the monitor next (PROTOCOL rules 1
--  and 7): answers before what is unasked, images last of all.

package Send_Order with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Send_Order);
   --  A claim that GNATprove checks: every subprogram ends

   type Choice is
     (Nothing,
      Answer,        --  to a command
      Robot_Lost,    --  the unasked ones, most urgent first
      Text,
      Battery,
      Position,
      Image);

   subtype Unasked is Choice range Robot_Lost .. Image;

   type Unasked_Set is array (Unasked) of Boolean;

   type Waiting is record
      Open     : Boolean := False;
      --  a monitor is in command
      Commands : Boolean := False;
      --  commands wait for their answers ...
      Ready    : Boolean := False;
      --  ... and the answer to the first of them is there
      Messages : Unasked_Set := (others => False);
      --  the unasked ones that wait ...
      Released : Boolean := False;
      --  ... and have been held back for long enough (rule 7)
      Answered : Boolean := False;
      --  what was sent last was an answer
   end record;

   function Any_Unasked (W : Waiting) return Boolean is
     (for some Kind in Unasked => W.Messages (Kind));

   function First_Unasked (W : Waiting) return Unasked is
     (if W.Messages (Robot_Lost) then Robot_Lost
      elsif W.Messages (Text) then Text
      elsif W.Messages (Battery) then Battery
      elsif W.Messages (Position) then Position
      else Image)
   with
     Pre  => Any_Unasked (W),
     Post => W.Messages (First_Unasked'Result)
       and then (for all Kind in Unasked =>
                   (if Kind < First_Unasked'Result then
                       not W.Messages (Kind)));

   function Next (W : Waiting) return Choice is
     (if not W.Open then Nothing
      elsif W.Ready
        and then not (Any_Unasked (W) and then W.Released
                      and then W.Answered)
      then Answer
      elsif Any_Unasked (W) and then (not W.Commands or else W.Released)
      then First_Unasked (W)
      else Nothing)
   with
     Pre  => (if W.Ready then W.Commands),
     Post =>
       --  only what is there, and that only to a monitor
       (case Next'Result is
           when Nothing => True,
           when Answer  => W.Open and then W.Ready,
           when Unasked => W.Open and then W.Messages (Next'Result))

       --  an answer goes before all that is unasked, unless that has waited
       --  for long enough; then the two take turns
       and then
         (if W.Open and then W.Ready then
            (if not W.Released or else not W.Answered
               or else not Any_Unasked (W)
             then Next'Result = Answer
             else Next'Result in Unasked))

       --  while an answer is awaited the unasked are held back, but not for
       --  ever
       and then
         (if W.Commands and then not W.Ready and then not W.Released then
             Next'Result = Nothing)
       and then
         (if W.Open and then Any_Unasked (W)
            and then (W.Released or else not W.Commands)
          then Next'Result /= Nothing)

       --  an image is the last of the unasked
       and then
         (if Next'Result = Image then
            (for all Kind in Unasked =>
               (if Kind /= Image then not W.Messages (Kind))));

end Send_Order;
