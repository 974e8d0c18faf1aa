--  SPDX-License-Identifier: GPL-3.0-or-later
--  Messages that wait to be sent to the monitor, shared by all tasks.
--  Monitor.Mailboxes decides what is sent when.

with Ada.Real_Time;
with Missions.Texts;
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
   --  A monitor has been admitted: empties the box

   procedure Close_Session (Next : out Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Empties the box and releases the tasks that wait for it. All earlier
   --  commands have numbers below Next

   procedure Wait_Sender;
   --  Until the sender no longer uses the connection of the closed session.
   --  For th_comMonPerdue only

   ------------------
   -- The answers  --
   ------------------

   procedure Reserve (Order : in out Orders.Order)
   with Pre => not Order.Owed;
   --  Gives Order its number, and its answer a place; waits while no place is
   --  free (docs/wire.md, rule 2). Then Order is Owed, unless the session has
   --  ended. For th_receiveFromMon only

   procedure Answer
     (Order : in out Orders.Order; Line : Monitor.Protocol.Short_Text)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  No effect if its session has ended

   procedure Answer_Nothing (Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  The command needs no answer, but later ones may wait for it

   procedure Answer_With_Image
     (Order   : in out Orders.Order;
      Message : in out Monitor.Image_Messages.Message_Access)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed;
   --  The image that answers an arena request; waits until the one before has
   --  been taken. Message is exchanged for another one, to be filled next
   --  time. For th_arene only

   --------------------------
   -- Unsolicited messages --
   --------------------------

   procedure Put_Robot_Lost (Empty : Boolean)
   with Annotate => (GNATprove, Terminating);
   --  ATIM, unsolicited (F9), and MSSG if its battery was Empty

   procedure Put_Notice (Told : Monitor.Notices.Notice)
   with Annotate => (GNATprove, Terminating);
   --  MSSG. Up to eight wait; then the oldest is dropped

   procedure Put_Progress
     (Number       : Orders.Ticket;
      Leg, Of_Legs : Missions.Point_Number;
      Distance     : Missions.Texts.Millimetres)
   with Annotate => (GNATprove, Terminating);
   --  MPRG: progress of the mission that was asked for by the command Number;
   --  dropped if its session has ended. Replaces progress that still waits

   procedure Put_End
     (Number   : Orders.Ticket;
      Why      : Missions.Ending;
      Measured : Missions.Percent := 0)
   with Annotate => (GNATprove, Terminating);
   --  MEND: the same for its end. Drops progress that still waits. Waits until
   --  it is sent or the session ends; there must be none that still waits

   procedure Get_End_Waits (Waits : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The end of a mission has not been sent yet

   procedure Put_Battery (Line : Monitor.Protocol.Short_Text)
   with Annotate => (GNATprove, Terminating);

   procedure Get_Generation (Current : out Monitor.Mailboxes.Generation)
   with Annotate => (GNATprove, Terminating);

   procedure Put_Position
     (Line : Monitor.Protocol.Short_Text; Made : Monitor.Mailboxes.Generation)
   with Annotate => (GNATprove, Terminating);

   procedure Put_Image
     (Message : in out Monitor.Image_Messages.Message_Access;
      Made    : Monitor.Mailboxes.Generation)
   with Annotate => (GNATprove, Terminating);
   --  Replaces an image that still waits. Message is exchanged for another
   --  one, to be filled next time

   procedure Stop_Images with Annotate => (GNATprove, Terminating);
   --  Begins a new generation and drops the waiting image of the older one

   ------------------
   -- The sending  --
   ------------------

   procedure Wait;
   --  Until a message has been put into the box. For th_sendToMon only

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
   --  The message taken before has been sent, or could not be. Takes the most
   --  urgent message that may be sent now, if any: Gap after the last one,
   --  which was sent at Last_Sent; Between two unsolicited ones. An image is
   --  returned in Image, whose content is overwritten. For th_sendToMon only

   --  The hold (docs/wire.md, rule 7)

   procedure Wait_Held;
   --  Until unsolicited messages begin to be held back. For th_hold only

   procedure Get_Hold_End
     (Any : out Boolean; At_Time : out Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Whether unsolicited messages are still held back, and until when

   procedure End_Hold with Annotate => (GNATprove, Terminating);
   --  Ends the hold if its time has come

   procedure Get_Waiting (Count : out Orders.Order_Count)
   with Annotate => (GNATprove, Terminating);
   --  Number of commands that wait for their answers

end Monitor.Outbox;
