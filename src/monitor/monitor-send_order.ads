--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which waiting message is sent to the monitor next (docs/wire.md, rules 1
--  and 7), answers before unsolicited messages; and how long after the last
--  one.

with Options;

package Monitor.Send_Order with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Send_Order);

   type Choice is
     (Nothing,
      Answer,        --  to a command
      Robot_Lost,    --  the unsolicited ones, most urgent first
      Text,
      Mission,       --  its end, else its progress
      Battery,
      Position,
      Image);        --  alternates with Position: they belong together

   subtype Sent_Kind is Choice range Answer .. Image;

   subtype Unsolicited is Choice range Robot_Lost .. Image;

   type Unsolicited_Set is array (Unsolicited) of Boolean;

   type Waiting is record
      Open     : Boolean := False;
      --  a monitor is in command
      Commands : Boolean := False;
      --  commands wait for their answers ...
      Ready    : Boolean := False;
      --  ... and the answer to the first of them is available
      Messages : Unsolicited_Set := (others => False);
      --  the unsolicited messages that wait ...
      Released : Boolean := False;
      --  ... and have been held back for long enough (rule 7)
      Last     : Choice := Nothing;
      --  sent last in this session
      Imaged   : Boolean := False;
      --  an image has been sent since the last position
   end record;

   subtype Milliseconds is Options.Milliseconds;

   Answer_Gap : constant Milliseconds := 4;
   --  at most, before an answer (docs/wire.md)

   function Any_Unsolicited (W : Waiting) return Boolean is
     (for some Kind in Unsolicited => W.Messages (Kind));

   function First_Unsolicited (W : Waiting) return Unsolicited is
     (if W.Messages (Robot_Lost) then Robot_Lost
      elsif W.Messages (Text) then Text
      elsif W.Messages (Mission) then Mission
      elsif W.Messages (Battery) then Battery
      elsif W.Messages (Position)
        and then (W.Imaged or else not W.Messages (Image))
      then Position
      else Image)
   with
     Pre  => Any_Unsolicited (W),
     Post => W.Messages (First_Unsolicited'Result)
       and then (for all Kind in Robot_Lost .. Battery =>
                   (if Kind < First_Unsolicited'Result then
                       not W.Messages (Kind)))
       and then
         (if W.Messages (Position) and then W.Messages (Image) then
            First_Unsolicited'Result /=
              (if W.Imaged then Image else Position));

   function Next (W : Waiting) return Choice is
     (if not W.Open then Nothing
      elsif W.Ready
        and then not (Any_Unsolicited (W) and then W.Released
                      and then W.Last = Answer)
      then Answer
      elsif Any_Unsolicited (W) and then (not W.Commands or else W.Released)
      then First_Unsolicited (W)
      else Nothing)
   with
     Pre  => (if W.Ready then W.Commands),
     Post =>
       --  only what waits, and only in a session
       (case Next'Result is
           when Nothing => True,
           when Answer  => W.Open and then W.Ready,
           when Unsolicited => W.Open and then W.Messages (Next'Result))

       --  an answer precedes unsolicited messages, unless these have been held
       --  back for long enough; then the two alternate
       and then
         (if W.Open and then W.Ready then
            (if not W.Released or else W.Last /= Answer
               or else not Any_Unsolicited (W)
             then Next'Result = Answer
             else Next'Result in Unsolicited))

       --  while an answer is awaited, unsolicited messages are held back for a
       --  limited time
       and then
         (if W.Commands and then not W.Ready and then not W.Released then
             Next'Result = Nothing)
       and then
         (if W.Open and then Any_Unsolicited (W)
            and then (W.Released or else not W.Commands)
          then Next'Result /= Nothing);

   function Gap
     (W : Waiting; Sent : Choice; Between : Milliseconds) return Milliseconds
   is
     (if W.Last = Nothing or else Sent = Nothing
        or else (W.Last = Answer and then Sent = Answer)
      then 0
      elsif Sent = Answer or else (W.Last = Answer and then W.Released)
      then Milliseconds'Min (Between, Answer_Gap)
      else Between)
   with
     Post => Gap'Result <= Between
       and then (if Sent = Answer then Gap'Result <= Answer_Gap)
       and then (if Sent in Unsolicited and then W.Last in Unsolicited then
                    Gap'Result = Between);
   --  Minimum time from the last message to Sent; Between is the gap between
   --  two unsolicited messages. It also applies after an answer, as the
   --  monitor takes time to process one. An endless sequence of answers does
   --  not block unsolicited messages

end Monitor.Send_Order;
