--  SPDX-License-Identifier: GPL-3.0-or-later
--  A monitor for tests: one TCP connection, every message stored with its time
--  of arrival, and the ways in which a monitor can be lost.

private with Ada.Finalization;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Expectations;
with Instants; use Instants;

package Monitor_Clients is

   subtype Message_Label is String (1 .. 4);

   Answers : constant String := "AACK ANAK ACRJ ATIM ACER";
   --  Labels of what only answers a command

   type Message is record
      Number : Natural := 0;
      --  1, 2 .. in the order of arrival; 0: none
      Time   : Instant := Never;
      --  when the recv that completed it returned
      Group  : Natural := 0;
      --  The existing monitor treats all data received up to a final line end
      --  as one message: messages of the same group would be one message to it
      Late   : Duration := 0.0;
      --  delay of the reader
      Label  : Message_Label := "    ";
      Data   : Unbounded_String;
      --  the text after the colon; of an image only its first characters
      Size   : Natural := 0;
      --  of the whole line, in bytes, without its end
   end record;

   type Client is tagged limited private;
   --  Closed at the end of its scope

   procedure Connect
     (Object         : in out Client;
      Port           : Positive;
      Address        : String  := "127.0.0.1";
      Source         : String  := "";
      Receive_Buffer : Natural := 0;
      By_Link        : Boolean := False;
      Real_Time      : Boolean := True);
   --  Source is the client's own address; if empty, the system's choice.
   --  Receive_Buffer 0: the system's default. By_Link: from the other end
   --  of the link that has been made (Network_Links), to this one's address.
   --  Real_Time: the receiving task gets the priority Libc.Above_Supervisor if
   --  permitted, so that its times are those of arrival. Raises Failed when
   --  rejected.

   procedure Send (Object : in out Client; Bytes : String);
   --  Sends unchanged; blocks while the supervisor accepts nothing, 30 s at
   --  most. Raises Failed when they cannot be sent.

   procedure Send_Urgent (Object : in out Client; Byte : Character);
   --  As telnet does with the end of a synch

   procedure Send_Line (Object : in out Client; Command : String);

   function Try_Send (Object : in out Client; Bytes : String) return Boolean;
   --  False where the supervisor has closed the connection

   --  Messages are taken in their order, each once.

   function Next
     (Object : in out Client; Within : Duration := Expectations.Patience)
      return Message;
   --  Number is 0 if none came

   function Next_Of (Object : in out Client; Labels : String) return Message;
   --  The next message with one of Labels, such as "AACK ANAK"; earlier ones
   --  are skipped. Raises Failed if it does not come.

   procedure Await
     (Object : in out Client; Labels : String; Count : Positive := 1);
   --  Takes the next Count of them

   function Next_Answer
     (Object : in out Client; Command : String := "") return Message;
   --  The next of Answers; RBLV, RCST, CIMG, RVER and CARN only if they answer
   --  Command

   function Ask (Object : in out Client; Command : String) return Message;
   --  Sends Command and takes its answer. Unsolicited messages are skipped.

   procedure Check_Label (Item : Message; Labels : String; What : String);
   --  Raises Failed unless Item has one of Labels; Too_Late if it is ATIM

   procedure Expect (Object : in out Client; Command, Answer : String);
   --  The same unless Answer is the answer to Command

   procedure Skip_To_Now (Object : in out Client);
   --  Discards the messages that have arrived and were not taken

   procedure Expect_Silence
     (Object : in out Client; Labels : String; For_Time : Duration);
   --  Raises Failed if one of Labels comes

   --  All messages received, taken or not

   function Count (Object : Client) return Natural;
   function Element (Object : Client; Number : Positive) return Message;
   function Count_Of (Object : Client; Label : Message_Label) return Natural;
   function Image (Object : Client; Number : Natural := 0) return String;
   --  The base64 text of message Number, or of the newest image, if it is
   --  among the newest hundred; else ""
   function Broken_Images (Object : Client) return Natural;
   --  Images whose text cannot be the base64 of a JPEG

   --  Reading

   procedure Pause (Object : in out Client);
   procedure Resume (Object : in out Client);
   --  Between the two, nothing is read from the socket
   procedure Limit_Reading (Object : in out Client; Rate : Natural);
   --  Bytes per second; 0: no limit
   procedure Be_Late
     (Object : in out Client; Least, Most : Duration; To_Each : Boolean)
     with Pre => Least <= Most;
   --  From now on the reader is delayed by a random time: for each group
   --  received, or only after each, while it processes it

   --  The end

   type Closing is (Open, Orderly, Broken);

   function Closed_By_Peer
     (Object : Client; Within : Duration := Expectations.Patience)
      return Closing;
   --  Waits until the supervisor has closed the connection

   procedure Half_Close (Object : in out Client);
   --  Nothing more is sent, but still read
   procedure Close (Object : in out Client);
   --  Orderly
   procedure Reset (Object : in out Client);
   --  Abortive: the supervisor gets a reset

   function Left_At (Object : Client) return Instant;
   --  When the last of these was done to the connection: just before the call
   --  of the system; Never before

private

   type Parts;
   type Parts_Access is access Parts;

   type Client is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
      Left  : Instant := Never;
   end record;

   overriding procedure Finalize (Object : in out Client);

end Monitor_Clients;
