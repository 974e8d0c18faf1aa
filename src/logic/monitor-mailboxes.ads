--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor, and its order: one answer per
--  command, in the order of the commands; and unsolicited messages, only the
--  newest of each kind, except texts. Images are stored elsewhere.

with Ada.Real_Time;
with Monitor.Answer_Queues;
with Monitor.Message_Holds;
with Monitor.Notice_Queues;
with Monitor.Notices;
with Monitor.Protocol;
with Monitor.Send_Order; use Monitor.Send_Order;
with Orders;

package Monitor.Mailboxes with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Mailboxes);

   use type Ada.Real_Time.Time;
   use all type Monitor.Answer_Queues.Queue;
   use all type Monitor.Answer_Queues.State_Kind;
   use type Monitor.Protocol.Short_Text;
   use type Orders.Ticket;

   subtype Short_Text is Monitor.Protocol.Short_Text;
   subtype Time is Ada.Real_Time.Time;

   type Generation is mod 2 ** 32;
   --  Of periodic images: an image of an older generation is not sent

   type Mailbox is record
      Open     : Boolean := False;
      --  a monitor is in command
      Busy     : Boolean := False;
      --  the message taken last is being sent
      Answers  : Monitor.Answer_Queues.Queue;
      Arena    : Boolean := False;
      --  the image that answers an arena request waits
      Lost     : Boolean := False;
      Told     : Monitor.Notice_Queues.Queue;
      First    : Orders.Ticket := 0;
      --  no command of this session has a lower number
      Progress : Short_Text;
      Ended    : Short_Text;
      --  progress and end of a mission
      Battery  : Boolean := False;
      Level    : Short_Text;
      Position : Short_Text;
      Image    : Boolean := False;
      Made     : Generation := 0;
      Hold     : Monitor.Message_Holds.Hold;
      Released : Boolean := False;
      --  unsolicited messages have been held back for long enough
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

   function Mission_Waits (B : Mailbox) return Boolean is
     (B.Ended.Length > 0 or else B.Progress.Length > 0);

   function Is_Current (B : Mailbox; Number : Orders.Ticket) return Boolean is
     (B.Open and then Number >= B.First);
   --  The command is one of this session

   function Waits (B : Mailbox) return Waiting is
     ((Open     => B.Open,
       Commands => Commands (B) > 0,
       Ready    => First_Is_Ready (B.Answers),
       Messages => (Robot_Lost                  => B.Lost,
                    Text                        =>
                      Monitor.Notice_Queues.Length (B.Told) > 0,
                    Mission                     => Mission_Waits (B),
                    Monitor.Send_Order.Battery  => B.Battery,
                    Monitor.Send_Order.Position => B.Position.Length > 0,
                    Monitor.Send_Order.Image    => B.Image),
       Released => B.Released,
       Last     => B.Last,
       Imaged   => B.Imaged))
   with Post => (if Waits'Result.Ready then Waits'Result.Commands);

   function Is_Quiet (B : Mailbox) return Boolean is
     (not Any_Unsolicited (Waits (B))
      and then not B.Hold.On
      and then not B.Released);
   --  No unsolicited message waits, and nothing is held back

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

   type Place is (Reserved, Full, Closed);

   procedure Reserve
     (B      : in out Mailbox;
      Now    : Time;
      Number : out Orders.Ticket;
      Result : out Place;
      Begun  : out Boolean)
   with
     Post => Number = Next_Number (B'Old)
       and then Result =
         (if not B.Open then Closed
          elsif Commands (B'Old) = Orders.Capacity then Full
          else Reserved)
       and then B.Open = B'Old.Open
       and then B.Ended = B'Old.Ended
       and then
         (if Result = Reserved then
             Commands (B) = Commands (B'Old) + 1
             and then Next_Number (B) = Number + 1
          else B.Answers = B'Old.Answers and then not Begun);
   --  Adds a place for the answer to the next command. Begun, here and below:
   --  unsolicited messages begin to be held back

   procedure Put_Answer
     (B : in out Mailbox; Number : Orders.Ticket; Line : Short_Text)
   with
     Post => Next_Number (B) = Next_Number (B'Old)
       and then Commands (B) <= Commands (B'Old)
       and then B.Arena = B'Old.Arena
       and then B.Ended = B'Old.Ended;
   --  The answer to a command; no effect if its session has ended

   procedure Put_No_Answer (B : in out Mailbox; Number : Orders.Ticket)
   with
     Post => Next_Number (B) = Next_Number (B'Old)
       and then Commands (B) <= Commands (B'Old)
       and then B.Arena = B'Old.Arena
       and then B.Ended = B'Old.Ended;
   --  The command needs no answer, but later ones may wait for it

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
       and then B.Ended = B'Old.Ended;
   --  The image that answers an arena request. Not accepted while the one
   --  before waits; not kept if its session has ended

   --  Unsolicited messages; without a session none is kept

   procedure Put_Lost
     (B     : in out Mailbox;
      Empty : Boolean;
      Now   : Time;
      Begun : out Boolean)
   with Post => B.Lost = (B'Old.Lost or else B.Open)
     and then B.Open = B'Old.Open
     and then B.Ended = B'Old.Ended;
   --  The robot is lost (F9). Empty: its battery was, which the user is told

   procedure Put_Notice
     (B     : in out Mailbox;
      Told  : Monitor.Notices.Notice;
      Now   : Time;
      Begun : out Boolean)
   with Post => B.Open = B'Old.Open
     and then B.Ended = B'Old.Ended
     and then (if B.Open then Monitor.Notice_Queues.Length (B.Told) > 0);
   --  If there is no room, the oldest is dropped

   procedure Put_Progress
     (B      : in out Mailbox;
      Number : Orders.Ticket;
      Line   : Short_Text;
      Now    : Time;
      Begun  : out Boolean)
   with Post => B.Open = B'Old.Open
     and then B.Ended = B'Old.Ended
     and then B.Progress =
       (if Is_Current (B, Number) and then B.Ended.Length = 0 then Line
        else B'Old.Progress);
   --  Of the mission that was asked for by the command Number

   procedure Put_End
     (B      : in out Mailbox;
      Number : Orders.Ticket;
      Line   : Short_Text;
      Now    : Time;
      Begun  : out Boolean)
   with Post => B.Open = B'Old.Open
     and then
       (if Is_Current (B, Number) then
           B.Ended = Line and then B.Progress.Length = 0
        else B.Ended = B'Old.Ended and then B.Progress = B'Old.Progress);
   --  The same for its end, which stays until it is taken or the session ends.
   --  Progress that still waits is dropped

   procedure Put_Battery
     (B     : in out Mailbox;
      Level : Short_Text;
      Now   : Time;
      Begun : out Boolean)
   with Post => B.Open = B'Old.Open
     and then B.Ended = B'Old.Ended
     and then (if B.Open then B.Battery and then B.Level = Level);

   procedure Put_Position
     (B     : in out Mailbox;
      Line  : Short_Text;
      Made  : Generation;
      Now   : Time;
      Begun : out Boolean)
   with Post => B.Open = B'Old.Open
     and then B.Ended = B'Old.Ended
     and then B.Made = B'Old.Made
     and then B.Position =
       (if B.Open and then Made = B.Made then Line else B'Old.Position);

   procedure Put_Image
     (B     : in out Mailbox;
      Made  : Generation;
      Now   : Time;
      Kept  : out Boolean;
      Begun : out Boolean)
   with Post => B.Open = B'Old.Open
     and then B.Ended = B'Old.Ended
     and then B.Made = B'Old.Made
     and then Kept = (B.Open and then Made = B.Made)
     and then B.Image = (B'Old.Image or else Kept);
   --  Kept: it replaces an image that still waits

   procedure Stop_Images (B : in out Mailbox)
   with Post => B.Made = B'Old.Made + 1
     and then B.Ended = B'Old.Ended
     and then not B.Image
     and then B.Position.Length = 0;
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
       and then (if Next.Kind /= Mission then B.Ended = B'Old.Ended)
       and then
         (case Next.Kind is
             when Nothing    => not Next.Is_Image,
             when Answer     =>
               (if First (B'Old).State = Ready_Text then
                   not Next.Is_Image
                   and then Next.Line = First (B'Old).Line)
               and then Next.Is_Image =
                 (First (B'Old).State = Ready_Image)
               and then (if Next.Is_Image then not B.Arena)
               and then Commands (B) < Commands (B'Old),
             when Robot_Lost =>
               Next.Line = Monitor.Protocol.Timed_Out
               and then not Next.Is_Image
               and then not B.Lost,
             when Text       =>
               Next.Line = Monitor.Notices.Line_Of
                 (Monitor.Notice_Queues.Element_At (B'Old.Told, 1))
               and then not Next.Is_Image,
             when Mission    =>
               Next.Line =
                 (if B'Old.Ended.Length > 0 then B'Old.Ended
                  else B'Old.Progress)
               and then not Next.Is_Image
               and then B.Ended.Length = 0
               and then (if B'Old.Ended.Length = 0 then
                            B.Progress.Length = 0),
             when Battery    =>
               Next.Line = B'Old.Level
               and then not Next.Is_Image
               and then not B.Battery,
             when Position   =>
               Next.Line = B'Old.Position
               and then not Next.Is_Image
               and then B.Position.Length = 0,
             when Image      => Next.Is_Image and then not B.Image);
   --  The message taken before has been sent, or could not be. Takes the most
   --  urgent message that may be sent now, if any: Gap after the last one,
   --  which was sent at Last_Sent. Left: the session of the message before has
   --  ended meanwhile

   --  The hold (docs/wire.md, rule 7)

   function Is_Held (B : Mailbox) return Boolean is
     (B.Hold.On and then not B.Released);
   --  Unsolicited messages are still held back

   procedure End_Hold (B : in out Mailbox; Now : Time)
   with
     Post => B.Released =
       (B'Old.Released
        or else (B.Hold.On
                 and then Now >= Monitor.Message_Holds.Ending (B.Hold)))
       and then B.Hold.On = B'Old.Hold.On
       and then B.Ended = B'Old.Ended;
   --  Ends the hold if its time has come

end Monitor.Mailboxes;
