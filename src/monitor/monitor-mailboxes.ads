--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor, and what is sent next (docs/wire.md,
--  rules 1 and 7): one answer per command, in the order of the commands,
--  before unsolicited messages; of these only the newest of each kind, except
--  texts. The images themselves are in Monitor.Outbox.

with Ada.Real_Time;
with Bounded_Queues;
with Commands;
with Monitor.Protocol; use Monitor.Protocol;
with Options;
with Schedule;

package Monitor.Mailboxes with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Mailboxes);  --  proved

   use type Ada.Real_Time.Time;
   use type Ada.Real_Time.Time_Span;
   use type Commands.Ticket;

   subtype Time is Ada.Real_Time.Time;
   subtype Milliseconds is Options.Milliseconds;

   type Choice is
     (Nothing,
      Answer,        --  to a command
      Lost,          --  the robot (F9): the unsolicited ones, by urgency
      Text,
      Ending,        --  of a mission
      Progress,      --  of a mission
      Battery,
      Position,      --  of the robot in an image
      Image);        --  alternates with Position: they belong together
   --  What is sent next

   subtype Unsolicited is Choice range Lost .. Image;
   subtype Notice_Kind is Choice range Lost .. Position;

   type Generation is mod 2 ** 32;
   --  Of periodic images: an image of an older generation is not sent

   type Notice is record
      Kind   : Notice_Kind := Text;
      Line   : Short_Text;
      Number : Commands.Ticket := 0;
      --  of Progress and Ending: the command that asked for the mission
      Made   : Generation := 0;
      --  of Position: that of its image
   end record;
   --  An unsolicited message without an image

   function Told (Message : String) return Notice is
     ((Text, Short (Log_Label & Separator & Message), others => <>))
   with Pre => Message'Length in 1 .. 80;

   type Answer_State is
     (Awaited,         --  not answered yet
      Ready_Text,
      Ready_Image,
      Ready_Nothing);  --  there is nothing to send

   type Answer_Place is record
      State : Answer_State := Awaited;
      Line  : Short_Text;
      --  of Ready_Text
   end record;
   --  Of the answer to a command, from the arrival of the command

   package Answer_Queues is new Bounded_Queues
     (Answer_Place, Commands.Capacity);

   package Text_Queues is new Bounded_Queues (Short_Text, 8);

   type Line_Array is array (Notice_Kind) of Short_Text;

   type Hold is record
      On       : Boolean := False;
      --  unsolicited messages are or were held back, and none was sent since
      Released : Boolean := False;
      --  they have been held back for long enough
      First    : Time := Ada.Real_Time.Time_First;
      --  when the hold began
      Since    : Time := Ada.Real_Time.Time_First;
      --  when the command that waits now arrived
   end record;
   --  While commands wait for their answers (docs/wire.md, rule 7)

   function End_Of (H : Hold) return Time is
     (if H.Since - H.First > Schedule.Hold_Limit
      then H.First + Schedule.Hold_Limit + Schedule.Hold_Limit
      else H.Since + Schedule.Hold_Limit)
   with Pre => H.On;
   --  One command holds the messages back for the limit at most. Commands that
   --  follow each other without time for a message hold them back for twice
   --  the limit

   type Mailbox is record
      Open    : Boolean := False;
      --  a monitor is in command
      Busy    : Boolean := False;
      --  the message taken last is being sent
      Answers : Answer_Queues.Queue;
      Next    : Commands.Ticket := 1;
      --  the number of the next command: those before have the last places
      First   : Commands.Ticket := 0;
      --  no command of this session has a lower number
      Arena   : Boolean := False;
      --  the image that answers an arena request waits
      Texts   : Text_Queues.Queue;
      Lines   : Line_Array;
      --  the other notices; No_Line: none waits
      Image   : Boolean := False;
      Made    : Generation := 0;
      Held    : Hold;
      Last    : Choice := Nothing;
      --  the choice taken last in this session
      Imaged  : Boolean := False;
      --  an image has been taken since the last position
   end record;

   type Item is record
      Kind     : Choice := Nothing;
      Unsent   : Boolean := False;
      --  not sent yet: the task that has taken it sends it, once
      Is_Image : Boolean := False;
      --  of Answer and Image: the message contains an image
      Line     : Short_Text;
      --  without an image
      Gap      : Milliseconds := 0;
      --  minimum time from the last message to the most urgent one
      Hold_End : Time := Ada.Real_Time.Time_Last;
      --  until then unsolicited messages are held back (docs/wire.md, rule 7);
      --  Time_Last: they are not
   end record;
   --  The message to send next, and when to look again

   --  The commands that wait for their answers

   function Pending (B : Mailbox) return Commands.Order_Count is
     (Answer_Queues.Length (B.Answers));

   function Holds (B : Mailbox; Number : Commands.Ticket) return Boolean is
     (B.Next - Number in 1 .. Commands.Ticket (Pending (B)));
   --  The command waits for its answer

   subtype Age is Answer_Queues.Place;
   --  Of a command that waits; 1: the newest

   function Age_Of (B : Mailbox; Number : Commands.Ticket) return Age is
     (Age (B.Next - Number))
   with
     Pre  => Holds (B, Number),
     Post => Age_Of'Result <= Pending (B);

   function At_Age
     (Q : Answer_Queues.Queue; Old : Age) return Answer_Place is
     (Answer_Queues.Element_At (Q, Answer_Queues.Length (Q) + 1 - Old))
   with Pre => Old <= Answer_Queues.Length (Q);

   function Is_Awaited (B : Mailbox; Number : Commands.Ticket) return Boolean
   is (Holds (B, Number)
       and then At_Age (B.Answers, Age_Of (B, Number)).State = Awaited);

   function First (B : Mailbox) return Answer_Place is
     (Answer_Queues.Element_At (B.Answers, 1))
   with Pre => Pending (B) > 0;
   --  The next answer to be sent, which may not be available yet

   function Is_Ready (B : Mailbox) return Boolean is
     (Pending (B) > 0 and then First (B).State /= Awaited);
   --  It is available

   --  The unsolicited messages that wait

   function Waits (B : Mailbox; Kind : Unsolicited) return Boolean is
     (case Kind is
         when Text   => Text_Queues.Length (B.Texts) > 0,
         when Image  => B.Image,
         when others => B.Lines (Kind).Length > 0);

   function Any_Waits (B : Mailbox) return Boolean is
     (for some Kind in Unsolicited => Waits (B, Kind));

   function Is_Wanted (B : Mailbox; Item : Notice) return Boolean is
     (B.Open
      and then
        (case Item.Kind is
            when Progress => Item.Number >= B.First
                             and then not Waits (B, Ending),
            when Ending   => Item.Number >= B.First,
            when Position => Item.Made = B.Made,
            when others   => True));
   --  Not without a session, nor from an earlier one or of an image of
   --  another generation; and no progress after the end

   --  What is next

   function First_Unsolicited (B : Mailbox) return Unsolicited is
     (if Waits (B, Lost) then Lost
      elsif Waits (B, Text) then Text
      elsif Waits (B, Ending) then Ending
      elsif Waits (B, Progress) then Progress
      elsif Waits (B, Battery) then Battery
      elsif Waits (B, Position) and then (B.Imaged or else not B.Image)
      then Position
      else Image)
   with
     Pre  => Any_Waits (B),
     Post => Waits (B, First_Unsolicited'Result)
       and then (for all Kind in Lost .. Battery =>
                   (if Kind < First_Unsolicited'Result
                    then not Waits (B, Kind)))
       and then
         (if Waits (B, Position) and then B.Image then
            First_Unsolicited'Result /=
              (if B.Imaged then Image else Position));

   function Is_Due (B : Mailbox) return Boolean is
     (Any_Waits (B) and then (Pending (B) = 0 or else B.Held.Released));
   --  An unsolicited message waits, and is not held back

   function Next (B : Mailbox) return Choice is
     (if not B.Open then Nothing
      elsif Is_Ready (B) and then not (Is_Due (B) and then B.Last = Answer)
      then Answer
      elsif Is_Due (B) then First_Unsolicited (B)
      else Nothing);
   --  An answer precedes unsolicited messages. If these have been held back
   --  for long enough, the two alternate

   Answer_Gap : constant Milliseconds := 4;
   --  at most, before an answer (docs/wire.md)

   function Gap
     (B : Mailbox; Sent : Choice; Between : Milliseconds) return Milliseconds
   is
     (if B.Last = Nothing or else Sent = Nothing
        or else (B.Last = Answer and then Sent = Answer)
      then 0
      elsif Sent = Answer or else (B.Last = Answer and then B.Held.Released)
      then Milliseconds'Min (Between, Answer_Gap)
      else Between);
   --  Minimum time from the last message to Sent; Between is the gap between
   --  two unsolicited messages. It also applies after an answer, as the
   --  monitor takes time to process one. An endless sequence of answers does
   --  not block unsolicited messages

   function Hold_End (B : Mailbox) return Time is
     (if B.Held.On and then not B.Held.Released then End_Of (B.Held)
      else Ada.Real_Time.Time_Last);

   type Status is record
      Busy      : Boolean;
      --  the sender uses the connection
      Pending   : Commands.Order_Count;
      --  that wait for their answers
      End_Waits : Boolean;
      --  the end of a mission has not been sent yet
      Made      : Generation;
      --  of the images that are sent
   end record;

   function Status_Of (B : Mailbox) return Status is
     ((B.Busy, Pending (B), Waits (B, Ending), B.Made));

   --  The session

   procedure Open_Session (B : in out Mailbox);
   --  A monitor has been admitted. The box is empty: without a session nothing
   --  is put into it

   procedure Close_Session (B : in out Mailbox)
   with
     Post => not B.Open
       and then not Any_Waits (B)
       and then Pending (B) = 0
       and then B.Made = B'Old.Made + 1
       and then B.Next = B'Old.Next;
   --  Empties the box

   --  The answers

   type Reservation is (Reserved, Full, Closed);

   procedure Reserve
     (B      : in out Mailbox;
      Now    : Time;
      Number : out Commands.Ticket;
      Result : out Reservation)
   with
     Post => B.Lines = B'Old.Lines
       and then Answer_Queues.Begins_With (B.Answers, B'Old.Answers)
       and then
         (if Result = Reserved then
             Number = B'Old.Next
             and then B.Next = Number + 1
             and then Pending (B) = Pending (B'Old) + 1
             and then Is_Awaited (B, Number));
   --  Adds a place for the answer to the next command

   function Is_Answered
     (B, Before : Mailbox; Number : Commands.Ticket; By : Answer_Place)
      return Boolean
   is
     (B.Next = Before.Next
      and then Pending (B) <= Pending (Before)
      and then
        (for all Old in 1 .. Pending (B) =>
           At_Age (B.Answers, Old) =
             (if Is_Awaited (Before, Number)
                and then Old = Age_Of (Before, Number)
              then By
              else At_Age (Before.Answers, Old)))
      and then B.Lines = Before.Lines)
   with Ghost;
   --  The command has the answer By, if it had none. All others have the same
   --  as Before; those at the front that have nothing to send are gone

   procedure Put_Answer
     (B : in out Mailbox; Number : Commands.Ticket; Item : Answer_Place)
   with
     Pre  => Item.State /= Awaited,
     Post => Is_Answered (B, B'Old, Number, Item)
       and then B.Arena = B'Old.Arena;
   --  No effect if it has one already, or its session has ended

   procedure Put_Arena
     (B        : in out Mailbox;
      Number   : Commands.Ticket;
      Accepted : out Boolean;
      Kept     : out Boolean)
   with
     Post => B.Lines = B'Old.Lines
       and then
         (if Kept then Is_Answered (B, B'Old, Number, (Ready_Image, No_Line)));
   --  The image that answers an arena request. Not accepted while the one
   --  before waits; not kept if its session has ended

   --  Unsolicited messages

   procedure Put (B : in out Mailbox; Item : Notice; Now : Time)
   with
     Post => B.Lines (Ending) =
       (if Item.Kind = Ending and then Is_Wanted (B'Old, Item) then Item.Line
        else B'Old.Lines (Ending));
   --  No effect where it is not wanted. If there is no room for a text, the
   --  oldest is dropped

   procedure Put_Image
     (B    : in out Mailbox;
      Made : Generation;
      Now  : Time;
      Kept : out Boolean)
   with
     Post => B.Lines = B'Old.Lines
       and then Kept = (B.Open and then Made = B.Made)
       and then B.Image = (B'Old.Image or else Kept);
   --  Kept: it replaces an image that still waits

   procedure Stop_Images (B : in out Mailbox)
   with
     Post => B.Made = B'Old.Made + 1
       and then not B.Image
       and then B.Lines (Ending) = B'Old.Lines (Ending);
   --  Begins a new generation and drops the waiting image of the older one

   --  The sending

   function Is_Taken (Next : Item; B, Before : Mailbox) return Boolean is
     (case Next.Kind is
         when Nothing => True,
         when Answer  =>
           (if Next.Is_Image then First (Before).State = Ready_Image
            else Next.Line = First (Before).Line)
           and then Pending (B) < Pending (Before),
         when Text    =>
           Next.Line = Text_Queues.Element_At (Before.Texts, 1),
         when Image   => Next.Is_Image and then not B.Image,
         when others  => Next.Line = Before.Lines (Next.Kind))
   with Ghost, Pre => Next.Kind in Nothing | Mailboxes.Next (Before);
   --  It waited in Before, and does not wait in B

   procedure Take
     (B         : in out Mailbox;
      Between   : Milliseconds;
      Now       : Time;
      Last_Sent : Time;
      Next      : out Item;
      Left      : out Boolean)
   with
     Post => Next.Gap = Gap (B'Old, Mailboxes.Next (B'Old), Between)
       and then Next.Kind =
         (if Now >= Last_Sent + Ada.Real_Time.Milliseconds (Next.Gap)
          then Mailboxes.Next (B'Old)
          else Nothing)
       and then Next.Unsent = (Next.Kind /= Nothing)
       and then Is_Taken (Next, B, B'Old)
       and then
         (if Next.Kind /= Ending then
             B.Lines (Ending) = B'Old.Lines (Ending));
   --  As Monitor.Outbox.Take says. Left: the session of the message before has
   --  ended meanwhile

   procedure End_Hold (B : in out Mailbox; Now : Time)
   with Post => B.Lines = B'Old.Lines;
   --  Ends the hold if its time has come

end Monitor.Mailboxes;
