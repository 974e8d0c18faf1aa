--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor, shared by all tasks.
--  Monitor.Mailboxes says what goes when.

with Ada.Real_Time;
with Monitor.Image_Messages;
with Monitor.Mailboxes;
with Monitor.Notices;
with Monitor.Protocol;
with Monitor.Send_Order;
with Orders;

package Monitor.Outbox with SPARK_Mode is

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

   procedure Reserve (Order : in out Orders.Order)
   with Pre => not Order.Owed;
   --  Gives Order its number, and its answer a place; waits while as many as
   --  may wait do (PROTOCOL rule 2). It is Owed then, unless the session has
   --  ended. For th_receiveFromMon only

   procedure Answer
     (Order : in out Orders.Order; Kind : Monitor.Protocol.Answer_Kind)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  Without effect if its session has ended

   procedure Answer_Nothing (Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  The command has no answer, but later ones have waited for it

   procedure Answer_With_Image
     (Order   : in out Orders.Order;
      Message : in out Monitor.Image_Messages.Message_Access)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed;
   --  The image that answers a search for the arena; waits until the one
   --  before has been taken. Message is another one then, to be filled next
   --  time. For th_arene only

   --------------------------
   -- The unasked messages --
   --------------------------

   procedure Put_Robot_Lost with Annotate => (GNATprove, Terminating);
   --  ATIM, unasked (F9)

   procedure Put_Notice (Told : Monitor.Notices.Notice)
   with Annotate => (GNATprove, Terminating);
   --  MSSG. Eight may wait; of more the oldest is dropped

   procedure Put_Battery (Kind : Monitor.Protocol.Answer_Kind)
   with Annotate => (GNATprove, Terminating);

   procedure Get_Generation (Current : out Monitor.Mailboxes.Generation)
   with Annotate => (GNATprove, Terminating);

   procedure Put_Position
     (Line : Monitor.Mailboxes.Short_Line; Made : Monitor.Mailboxes.Generation)
   with Annotate => (GNATprove, Terminating);

   procedure Put_Image
     (Message : in out Monitor.Image_Messages.Message_Access;
      Made    : Monitor.Mailboxes.Generation)
   with Annotate => (GNATprove, Terminating);
   --  Replaces an image that waits still. Message is another one then, to be
   --  filled next time

   procedure Stop_Images with Annotate => (GNATprove, Terminating);
   --  Begins a new generation; what waits of the older one is dropped

   ------------------
   -- The sending  --
   ------------------

   procedure Wait;
   --  Until something has been put into the box. For th_sendToMon only

   procedure Take
     (Between   : Monitor.Send_Order.Milliseconds;
      Last_Sent : Ada.Real_Time.Time;
      Next      : in out Monitor.Mailboxes.Item;
      Image     : in out Monitor.Image_Messages.Message_Access;
      Gap       : out Monitor.Send_Order.Milliseconds)
   with
     Pre  => not Next.Unsent,
     Post => Next.Unsent = (Next.Kind in Monitor.Send_Order.Sent_Kind),
     Annotate => (GNATprove, Terminating);
   --  What was taken before has been sent, or could not be. The most urgent
   --  message that may be sent now, if any: Gap after the last one, which was
   --  sent at Last_Sent; Between two unasked ones. An image is in Image, whose
   --  former content is no longer needed. For th_sendToMon only

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

end Monitor.Outbox;
