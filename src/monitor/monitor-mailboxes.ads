--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor, and its order: one answer per
--  command, in the order of the commands; and unsolicited messages, only the
--  newest of each kind, except texts. Images are stored elsewhere.

with Ada.Real_Time;
with Bounded_Queues;
with Monitor.Answer_Queues;
with Monitor.Notices;
with Monitor.Protocol;   use Monitor.Protocol;
with Monitor.Send_Order; use Monitor.Send_Order;
with Orders;
with Schedule;

package Monitor.Mailboxes with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Mailboxes);

   use type Ada.Real_Time.Time;
   use type Ada.Real_Time.Time_Span;
   use all type Monitor.Answer_Queues.Queue;
   use all type Monitor.Answer_Queues.State_Kind;
   use type Orders.Ticket;

   subtype Time is Ada.Real_Time.Time;

   type Generation is mod 2 ** 32;
   --  Of periodic images: an image of an older generation is not sent

   type Notice_Kind is (User_Text, Lost, Progress, Ending, Level, Place);
   --  Of the robot: lost (F9), the battery's level, its place in an image. Of
   --  a mission: progress and end

   subtype Newest_Kind is Notice_Kind range Lost .. Place;
   --  A newer one replaces one that still waits

   type Notice is record
      Kind   : Notice_Kind := User_Text;
      Line   : Short_Text;
      Number : Orders.Ticket := 0;
      --  of Progress and Ending: the command that asked for the mission
      Made   : Generation := 0;
      --  of Place: that of its image
   end record;
   --  An unsolicited message without an image

   function Told (Item : Monitor.Notices.Notice) return Notice is
     ((User_Text, Monitor.Notices.Line_Of (Item), others => <>));

   type Line_Array is array (Newest_Kind) of Short_Text;

   package Text_Queues is new Bounded_Queues (Short_Text, 8);

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

   function Ending (H : Hold) return Time is
     (if H.Since - H.First > Schedule.Hold_Limit
      then H.First + Schedule.Hold_Limit + Schedule.Hold_Limit
      else H.Since + Schedule.Hold_Limit)
   with Pre => H.On;
   --  One command holds the messages back for the limit at most. Commands that
   --  follow each other without time for a message hold them back for twice
   --  the limit

   type Mailbox is record
      Open     : Boolean := False;
      --  a monitor is in command
      Busy     : Boolean := False;
      --  the message taken last is being sent
      Answers  : Monitor.Answer_Queues.Queue;
      Arena    : Boolean := False;
      --  the image that answers an arena request waits
      First    : Orders.Ticket := 0;
      --  no command of this session has a lower number
      Texts    : Text_Queues.Queue;
      Lines    : Line_Array;
      --  No_Line: none waits
      Image    : Boolean := False;
      Made     : Generation := 0;
      Held     : Hold;
      Last     : Choice := Nothing;
      --  the choice taken last in this session
      Imaged   : Boolean := False;
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
   end record;
   --  The message to send next

   function Commands (B : Mailbox) return Orders.Order_Count is
     (Length (B.Answers));
   --  Commands that wait for their answers

   function Is_Full (B : Mailbox) return Boolean is
     (Commands (B) = Orders.Capacity);

   function Next_Number (B : Mailbox) return Orders.Ticket is
     (Next_Number (B.Answers));
   --  The number of the next command

   function Holds (B : Mailbox; Number : Orders.Ticket) return Boolean is
     (Holds (B.Answers, Number));
   --  The command has a place in the queue

   function Is_Awaited (B : Mailbox; Number : Orders.Ticket) return Boolean
   is (Is_Awaited (B.Answers, Number));
   --  The command waits for its answer

   function First (B : Mailbox) return Monitor.Answer_Queues.Answer is
     (First_Answer (B.Answers))
   with Pre => Commands (B) > 0;
   --  The next answer to be sent, which may not be available yet

   function Is_Waiting (B : Mailbox; Kind : Newest_Kind) return Boolean is
     (B.Lines (Kind).Length > 0);

   function Is_Wanted (B : Mailbox; Item : Notice) return Boolean is
     (B.Open
      and then
        (case Item.Kind is
            when Progress =>
              Item.Number >= B.First and then not Is_Waiting (B, Ending),
            when Ending   => Item.Number >= B.First,
            when Place    => Item.Made = B.Made,
            when others   => True));
   --  Not without a session, nor from an earlier one or of an image of
   --  another generation; and no progress after the end

   function Kind_Of (B : Mailbox; Chosen : Unsolicited) return Newest_Kind is
     (case Chosen is
         when Robot_Lost => Lost,
         when Mission    =>
           (if Is_Waiting (B, Ending) then Ending else Progress),
         when Battery    => Level,
         when others     => Place);

   function Waits (B : Mailbox) return Waiting is
     ((Open     => B.Open,
       Commands => Commands (B) > 0,
       Ready    => First_Is_Ready (B.Answers),
       Messages =>
         (Robot_Lost => Is_Waiting (B, Lost),
          Text       => Text_Queues.Length (B.Texts) > 0,
          Mission    =>
            Is_Waiting (B, Ending) or else Is_Waiting (B, Progress),
          Battery    => Is_Waiting (B, Level),
          Position   => Is_Waiting (B, Place),
          Image      => B.Image),
       Released => B.Held.Released,
       Last     => B.Last,
       Imaged   => B.Imaged))
   with Post => (if Waits'Result.Ready then Waits'Result.Commands);

   function Is_Quiet (B : Mailbox) return Boolean is
     (not Any_Unsolicited (Waits (B))
      and then not B.Held.On
      and then not B.Held.Released);
   --  No unsolicited message waits, and nothing is held back

   type Status is record
      Busy      : Boolean;
      --  the sender uses the connection
      Commands  : Orders.Order_Count;
      --  that wait for their answers
      End_Waits : Boolean;
      --  the end of a mission has not been sent yet
      Made      : Generation;
      --  of the images that are sent
   end record;

   function Status_Of (B : Mailbox) return Status is
     ((B.Busy, Commands (B), Is_Waiting (B, Ending), B.Made));

   --  The session

   procedure Open_Session (B : in out Mailbox)
   with
     Post => B.Open
       and then Is_Quiet (B)
       and then B.Last = Nothing
       and then not B.Imaged
       and then B.Answers = B'Old.Answers
       and then B.First = Next_Number (B);
   --  A monitor has been admitted

   procedure Close_Session (B : in out Mailbox; Next : out Orders.Ticket)
   with
     Post => not B.Open
       and then Is_Quiet (B)
       and then Commands (B) = 0
       and then not B.Arena
       and then B.Made = B'Old.Made + 1
       and then B.Busy = B'Old.Busy
       and then Next = Next_Number (B'Old)
       and then Next_Number (B) = Next;
   --  Empties the box. All earlier commands have numbers below Next

   --  The answers

   type Reservation is (Reserved, Full, Closed);

   procedure Reserve
     (B      : in out Mailbox;
      Now    : Time;
      Number : out Orders.Ticket;
      Result : out Reservation)
   with
     Post => Number = Next_Number (B'Old)
       and then Result =
         (if not B.Open then Closed
          elsif Is_Full (B'Old) then Full
          else Reserved)
       and then B.Open = B'Old.Open
       and then B.Lines = B'Old.Lines
       and then
         (if Result = Reserved then
             Commands (B) = Commands (B'Old) + 1
             and then Next_Number (B) = Number + 1
          else B.Answers = B'Old.Answers);
   --  Adds a place for the answer to the next command

   procedure Put_Answer
     (B : in out Mailbox; Number : Orders.Ticket; Line : Short_Text)
   with
     Post => Next_Number (B) = Next_Number (B'Old)
       and then Commands (B) <= Commands (B'Old)
       and then B.Arena = B'Old.Arena
       and then B.Lines = B'Old.Lines;
   --  The answer to a command; no effect if its session has ended. No_Line: it
   --  needs none, but later ones may wait for it

   procedure Put_Arena
     (B        : in out Mailbox;
      Number   : Orders.Ticket;
      Accepted : out Boolean;
      Kept     : out Boolean)
   with
     Post => Accepted =
         (not Holds (B'Old, Number) or else not B'Old.Arena)
       and then Kept =
         (Holds (B'Old, Number) and then not B'Old.Arena)
       and then B.Arena = (B'Old.Arena or else Kept)
       and then B.Lines = B'Old.Lines;
   --  The image that answers an arena request. Not accepted while the one
   --  before waits; not kept if its session has ended

   --  Unsolicited messages

   procedure Put (B : in out Mailbox; Item : Notice; Now : Time)
   with
     Post => B.Open = B'Old.Open
       and then B.Made = B'Old.Made
       and then
         (if Is_Wanted (B'Old, Item) and then Item.Kind = User_Text then
             Text_Queues.Element_At (B.Texts, Text_Queues.Length (B.Texts)) =
               Item.Line)
       and then
         (for all Kind in Newest_Kind =>
            B.Lines (Kind) =
              (if not Is_Wanted (B'Old, Item) then B'Old.Lines (Kind)
               elsif Kind = Item.Kind then Item.Line
               elsif Kind = Progress and then Item.Kind = Ending then No_Line
               else B'Old.Lines (Kind)));
   --  No effect where it is not wanted. If there is no room for a text, the
   --  oldest is dropped

   procedure Put_Image
     (B    : in out Mailbox;
      Made : Generation;
      Now  : Time;
      Kept : out Boolean)
   with
     Post => B.Open = B'Old.Open
       and then B.Lines = B'Old.Lines
       and then B.Made = B'Old.Made
       and then Kept = (B.Open and then Made = B.Made)
       and then B.Image = (B'Old.Image or else Kept);
   --  Kept: it replaces an image that still waits

   procedure Stop_Images (B : in out Mailbox)
   with
     Post => B.Made = B'Old.Made + 1
       and then not B.Image
       and then (for all Kind in Newest_Kind =>
                   B.Lines (Kind) =
                     (if Kind = Place then No_Line else B'Old.Lines (Kind)));
   --  Begins a new generation and drops the waiting image of the older one

   --  The sending

   function Due (B : Mailbox; Between : Milliseconds) return Milliseconds is
     (Gap (Waits (B), Monitor.Send_Order.Next (Waits (B)), Between));
   --  Minimum time from the last message to the most urgent one now; Between:
   --  the gap between two unsolicited messages

   procedure Take
     (B         : in out Mailbox;
      Between   : Milliseconds;
      Now       : Time;
      Last_Sent : Time;
      Next      : out Item;
      Gap       : out Milliseconds;
      Left      : out Boolean)
   with
     Post => Left = (B'Old.Busy and then not B'Old.Open)
       and then Gap = Due (B'Old, Between)
       and then Next.Kind =
         (if Now >= Last_Sent + Ada.Real_Time.Milliseconds (Gap)
          then Monitor.Send_Order.Next (Waits (B'Old))
          else Nothing)
       and then B.Busy = (Next.Kind /= Nothing)
       and then Next.Unsent = B.Busy
       and then B.Open = B'Old.Open
       and then
         (case Next.Kind is
             when Nothing    => not Next.Is_Image,
             when Answer     =>
               (if First (B'Old).State = Ready_Text then
                   Next.Line = First (B'Old).Line)
               and then Next.Is_Image =
                 (First (B'Old).State = Ready_Image)
               and then (if Next.Is_Image then not B.Arena)
               and then Commands (B) < Commands (B'Old),
             when Text       =>
               Next.Line = Text_Queues.Element_At (B'Old.Texts, 1)
               and then not Next.Is_Image,
             when Robot_Lost | Mission | Battery | Position =>
               Next.Line = B'Old.Lines (Kind_Of (B'Old, Next.Kind))
               and then not Next.Is_Image,
             when Image      => Next.Is_Image and then not B.Image)
       and then
         (for all Kind in Newest_Kind =>
            B.Lines (Kind) =
              (if Next.Kind in Robot_Lost | Mission | Battery | Position
                 and then Kind = Kind_Of (B'Old, Next.Kind)
               then No_Line
               else B'Old.Lines (Kind)));
   --  The message taken before has been sent, or could not be. Takes the most
   --  urgent message that may be sent now, if any: Gap after the last one,
   --  which was sent at Last_Sent. Left: the session of the message before has
   --  ended meanwhile

   --  The hold (docs/wire.md, rule 7)

   function Hold_End (B : Mailbox) return Time is
     (if B.Held.On and then not B.Held.Released then Ending (B.Held)
      else Ada.Real_Time.Time_Last);
   --  Until then unsolicited messages are held back; Time_Last: they are not

   procedure End_Hold (B : in out Mailbox; Now : Time)
   with
     Post => B.Held.Released =
         (B'Old.Held.Released
          or else (B.Held.On and then Now >= Ending (B.Held)))
       and then B.Held.On = B'Old.Held.On
       and then B.Lines = B'Old.Lines;
   --  Ends the hold if its time has come

end Monitor.Mailboxes;
