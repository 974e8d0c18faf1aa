--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor: one answer a command, in the order
--  of the commands; and the unasked messages, of which only the newest counts.

with Ada.Real_Time;
with Image_Slots;
with Monitor_Protocol;
with Orders;
with Send_Order;
with Texts;

package Outbox with SPARK_Mode is

   Max_Jpeg : constant := Image_Slots.Max_Jpeg;
   --  Bytes of the largest image that can be sent (a multiple of 3)

   subtype Message_Buffer is Image_Slots.Message_Buffer;
   subtype Message_Length is Image_Slots.Message_Length;

   type Generation is mod 2 ** 32;
   --  Of the periodic images: an image made for an older one is not sent

   ---------------------------
   -- For the session tasks --
   ---------------------------

   procedure Open_Session with Annotate => (GNATprove, Terminating);
   --  Empties the box: a monitor has been admitted

   procedure Close_Session (Next : out Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Empties the box and frees whoever waits for it. Commands have lower
   --  numbers than Next so far

   procedure Wait_Sender;
   --  Until the sender has left the connection of the session just closed.
   --  For th_comMonPerdue only

   ------------------
   -- The answers  --
   ------------------

   procedure Reserve (Number : out Orders.Ticket; Open : out Boolean);
   --  A place for the answer of the next command; waits while as many as
   --  may wait do (PROTOCOL rule 2). Open is false when the session has
   --  ended meanwhile. For th_receiveFromMon only

   procedure Answer
     (Number : Orders.Ticket; Kind : Monitor_Protocol.Answer_Kind)
   with Annotate => (GNATprove, Terminating);
   --  The answer of one command; without effect if its session has ended

   procedure Answer_Nothing (Number : Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  The command has no answer, but later ones have waited for it

   procedure Answer_With_Image
     (Number : Orders.Ticket;
      Data   : Message_Buffer;
      Length : Message_Length);
   --  The image that answers an arena search; waits until the one before
   --  has been taken. For th_arene only

   --------------------------
   -- The unasked messages --
   --------------------------

   procedure Put_Robot_Lost with Annotate => (GNATprove, Terminating);
   --  ATIM, unasked (F9)

   procedure Put_Text (Text : Texts.Text)
   with Annotate => (GNATprove, Terminating);
   --  MSSG. Eight may wait; of more the oldest is dropped

   procedure Put_Battery (Kind : Monitor_Protocol.Answer_Kind)
   with Annotate => (GNATprove, Terminating);

   procedure Get_Generation (Current : out Generation)
   with Annotate => (GNATprove, Terminating);

   procedure Put_Position
     (Text   : String;
      Made   : Generation)
   with Annotate => (GNATprove, Terminating);
   --  The line as it is to be sent, at most Position_Length characters

   procedure Put_Image
     (Data   : Message_Buffer;
      Length : Message_Length;
      Made   : Generation)
   with Annotate => (GNATprove, Terminating);
   --  Replaces an image that waits still

   procedure Stop_Images with Annotate => (GNATprove, Terminating);
   --  Begins a new generation; what waits of the older one is dropped

   ------------------
   -- The sending  --
   ------------------

   type Message_Kind is (Nothing, Answer, Unasked);

   procedure Wait;
   --  Until something may be sent, but for the gap after the last message.
   --  For th_sendToMon only

   procedure Get_Gap
     (Between : Send_Order.Milliseconds; Gap : out Send_Order.Milliseconds)
   with Annotate => (GNATprove, Terminating);
   --  How long after the last message the most urgent one may follow now;
   --  Between two unasked ones

   procedure Take
     (Between : Send_Order.Milliseconds;
      Kept    : Send_Order.Milliseconds;
      Kind    : out Message_Kind;
      Data    : in out Message_Buffer;
      Length  : out Message_Length)
   with Annotate => (GNATprove, Terminating);
   --  The most urgent message that may be sent now, if any, and if its gap
   --  is no longer than the one that was Kept: answers first, unless unasked
   --  ones have been held back for long enough. Until Sent the sender counts
   --  as busy. For th_sendToMon only

   procedure Sent with Annotate => (GNATprove, Terminating);
   --  What was taken has been sent, or could not be

   ----------------------------------
   -- The hold (PROTOCOL rule 7)   --
   ----------------------------------

   procedure Wait_Held;
   --  Until unasked messages begin to be held back. For the hold's task only

   procedure Get_Hold_End
     (Any : out Boolean; At_Time : out Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Whether unasked messages are held back still; until when

   procedure End_Hold with Annotate => (GNATprove, Terminating);
   --  Release those whose time has come

   procedure Get_Waiting (Count : out Orders.Order_Count)
   with Annotate => (GNATprove, Terminating);
   --  Commands that wait for their answer

   Position_Length : constant := 128;

end Outbox;
