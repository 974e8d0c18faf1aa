--  SPDX-License-Identifier: GPL-3.0-or-later
--  A monitor of the tests: one TCP connection, every message kept with the
--  time of its arrival, and the ways in which a monitor can be lost.

private with Ada.Finalization;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants; use Instants;

package Monitor_Clients is

   subtype Message_Label is String (1 .. 4);

   type Message is record
      Number : Natural := 0;
      --  1, 2 .. in the order of arrival; 0 when there is none
      Time   : Instant := Never;
      --  when the recv that ended it returned
      Group  : Natural := 0;
      --  The existing monitor's reader takes what it receives up to a final
      --  end of line as one message: messages with the same group would be
      --  one for it
      Late   : Duration := 0.0;
      --  how late the reader was
      Label  : Message_Label := "    ";
      Data   : Unbounded_String;
      --  what follows the colon; of an image only its first characters
      Size   : Natural := 0;
      --  of the whole line, in bytes, without its end
   end record;

   type Client is tagged limited private;
   --  Closed when it leaves its scope

   procedure Connect
     (Object         : in out Client;
      Port           : Positive;
      Address        : String  := "127.0.0.1";
      Source         : String  := "";
      Receive_Buffer : Natural := 0;
      Namespace      : String  := "";
      Real_Time      : Boolean := True);
   --  Source is the client's own address, the system's choice where it is
   --  empty. Receive_Buffer 0 leaves the system's. Namespace is that of
   --  Network_Links. Real_Time: the task that receives gets the
   --  priority Libc.Above_Supervisor where that is allowed, so that the
   --  times it notes are those of arrival. Raises Failed when refused.

   function Connects
     (Port : Positive; Address : String := "127.0.0.1") return Boolean;
   --  Whether anybody listens there

   procedure Send (Object : in out Client; Bytes : String);
   --  As they are; blocks while the supervisor takes nothing, 30 s at most.
   --  Raises Failed when they cannot be sent.

   procedure Send_Line (Object : in out Client; Command : String);

   function Try_Send
     (Object : in out Client; Bytes : String) return Boolean;
   --  False where the supervisor has closed the connection

   --  Messages are taken in their order, each once.

   function Next (Object : in out Client; Within : Duration) return Message;
   --  Number 0 when none came

   function Next_Of
     (Object : in out Client; Labels : String; Within : Duration)
      return Message;
   --  The next whose label is one of Labels, such as "AACK ANAK"; those
   --  before it are skipped. Raises Failed when it does not come.

   function Next_Answer
     (Object  : in out Client;
      Within  : Duration := 3.0;
      Command : String   := "") return Message;
   --  The next that is an answer: AACK, ANAK, ACRJ, ATIM, ACER; RBLV, RCST
   --  and CIMG where Command is the one they answer

   function Ask
     (Object : in out Client; Command : String; Within : Duration := 3.0)
      return Message;
   --  Sends Command and takes the answer. Unasked messages are skipped.

   procedure Expect
     (Object  : in out Client;
      Command : String;
      Answer  : String;
      Within  : Duration := 3.0);
   --  Raises Failed unless Answer is the answer to Command. Within has a
   --  margin over the answer's worst case of a few hundred milliseconds.

   procedure Skip_To_Now (Object : in out Client);
   --  Forgets what has arrived and has not been taken

   procedure Expect_Silence
     (Object : in out Client; Labels : String; For_Time : Duration);
   --  Raises Failed if one of Labels comes

   --  All that has arrived, taken or not

   function Count (Object : Client) return Natural;
   function Element (Object : Client; Number : Positive) return Message;
   function Count_Of (Object : Client; Label : Message_Label) return Natural;
   function Bytes_Received (Object : Client) return Natural;
   function Last_Image (Object : Client) return String;
   --  The base64 text of the newest image, "" before the first
   function Broken_Images (Object : Client) return Natural;
   --  Images whose text cannot be the base64 of a JPEG

   procedure Keep_Images (Object : in out Client; Count : Positive);
   function Image (Object : Client; Number : Positive) return String;
   --  The base64 text of message Number, where it is among the newest
   --  images that are kept (1 at first)

   --  Reading

   procedure Pause (Object : in out Client);
   procedure Resume (Object : in out Client);
   --  Nothing is read from the socket in between
   procedure Limit_Reading (Object : in out Client; Rate : Natural);
   --  Bytes a second; 0 is no limit
   procedure Be_Late
     (Object : in out Client; Least, Most : Duration; To_Each : Boolean)
     with Pre => Least <= Most;
   --  From now on the reader is late, by a random time: to each group that
   --  has come, or only after each, which it is busy with

   --  The end

   type Closing is (Open, Orderly, Broken);

   function Closed_By_Peer
     (Object : Client; Within : Duration) return Closing;
   --  Waits until the supervisor has closed the connection

   procedure Half_Close (Object : in out Client);
   --  Nothing more will be sent, but read
   procedure Close (Object : in out Client);
   --  Orderly
   procedure Reset (Object : in out Client);
   --  Abortive: the supervisor gets a reset

private

   type Parts;
   type Parts_Access is access Parts;

   type Client is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
   end record;

   overriding procedure Finalize (Object : in out Client);

end Monitor_Clients;
