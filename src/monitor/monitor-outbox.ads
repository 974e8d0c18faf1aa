--  SPDX-License-Identifier: GPL-3.0-or-later
--  Messages that wait to be sent to the monitor, shared by all tasks.
--  Monitor.Mailboxes decides what is sent when.

with Ada.Real_Time;
with Commands;
with Monitor.Mailboxes;
with Monitor.Protocol;

package Monitor.Outbox with SPARK_Mode is

   use type Monitor.Mailboxes.Choice;

   --  Messages that contain an image. They are large, so they are passed by
   --  reference, with one owner at a time, which GNATprove checks

   Max_Jpeg : constant := 1_048_575;
   --  Bytes of the largest image that can be sent (a multiple of 3)

   Max_Message : constant := 5 + Max_Jpeg / 3 * 4 + 1;
   --  Characters of its message: label, base64, line feed

   subtype Message_Buffer is String (1 .. Max_Message);

   type Message is record
      Data   : Message_Buffer                 := (others => ' ');
      Length : Natural range 0 .. Max_Message := 0;
   end record;
   --  The first Length characters of Data are valid

   type Message_Access is access Message;

   --  The session

   procedure Get (Value : out Monitor.Mailboxes.Status)
   with Annotate => (GNATprove, Terminating);

   procedure Open_Session with Annotate => (GNATprove, Terminating);
   --  A monitor has been admitted

   procedure Close_Session (Next : out Commands.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Empties the box and releases the tasks that wait for it. All earlier
   --  commands have numbers below Next

   procedure Wait_Sender;
   --  Until the sender no longer uses the connection of the closed session.
   --  For th_comMonPerdue only

   --  The answers

   procedure Reserve (Order : in out Commands.Order)
   with Pre => not Order.Owed;
   --  Gives Order its number, and its answer a place; waits while no place is
   --  free (docs/wire.md, rule 2). Then Order is Owed, unless the session has
   --  ended. For th_receiveFromMon only

   procedure Answer
     (Order : in out Commands.Order; Line : Monitor.Protocol.Short_Text)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  No effect if its session has ended. No_Line: the command needs none, but
   --  later ones may wait for its place

   procedure Answer_With_Image
     (Order : in out Commands.Order; Image : in out Message_Access)
   with
     Pre  => Order.Owed and then Image /= null,
     Post => not Order.Owed and then Image /= null;
   --  The image that answers an arena request; waits until the one before has
   --  been taken. Image is exchanged for another one, to be filled next time.
   --  For th_arene only

   --  Unsolicited messages

   procedure Put (Item : Monitor.Mailboxes.Notice)
   with Annotate => (GNATprove, Terminating);
   --  Up to eight texts wait; then the oldest is dropped. A newer message of
   --  any other kind replaces one that still waits, and the end of a mission
   --  its progress. Dropped if its session has ended

   procedure Put_Image
     (Image : in out Message_Access; Made : Monitor.Mailboxes.Generation)
   with
     Pre  => Image /= null,
     Post => Image /= null,
     Annotate => (GNATprove, Terminating);
   --  Replaces an image that still waits. Image is exchanged for another one,
   --  to be filled next time

   procedure Stop_Images with Annotate => (GNATprove, Terminating);
   --  Begins a new generation and drops the waiting image of the older one

   --  The sending

   procedure Wait (Hold_End : Ada.Real_Time.Time);
   --  Until a message has been put into the box, or Hold_End, which Take has
   --  given. For th_sendToMon only

   procedure Take
     (Between   : Monitor.Mailboxes.Milliseconds;
      Last_Sent : Ada.Real_Time.Time;
      Next      : in out Monitor.Mailboxes.Item;
      Image     : in out Message_Access)
   with
     Pre  => not Next.Unsent and then Image /= null,
     Post => Next.Unsent = (Next.Kind /= Monitor.Mailboxes.Nothing)
       and then Image /= null,
     Annotate => (GNATprove, Terminating);
   --  The message taken before has been sent, or could not be. Takes the most
   --  urgent message that may be sent now, if any: Next.Gap after the last
   --  one, which was sent at Last_Sent; Between two unsolicited ones. An image
   --  is returned in Image, whose content is overwritten. For th_sendToMon
   --  only

end Monitor.Outbox;
