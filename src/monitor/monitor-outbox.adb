--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks, and exchanges image messages by reference;
--  Monitor.Mailboxes decides.

with Ada.Real_Time;                use Ada.Real_Time;
with Event;
with Schedule;
with Trace;

package body Monitor.Outbox with SPARK_Mode is

   use type Monitor.Mailboxes.Reservation;
   use type Monitor.Send_Order.Choice;

   subtype Message_Access is Monitor.Image_Messages.Message_Access;

   package Room is new Event;
   package Work is new Event;
   package Arena_Room is new Event;
   package Sender_Left is new Event;

   procedure Exchange (Left, Right : in out Message_Access) is
      --  Swaps the two
      Kept : constant Message_Access := Left;
   begin
      Left := Right;
      Right := Kept;
   end Exchange;

   protected Box with Priority => Schedule.Outbox_Ceiling is
      procedure Fill (First, Second : in out Message_Access);
      --  The box gets its messages for images
      procedure Open_Session;
      procedure Close_Session (Next : out Orders.Ticket);
      procedure Get (Value : out Monitor.Mailboxes.Status);
      procedure Reserve
        (Now    : Time;
         Number : out Orders.Ticket;
         Result : out Monitor.Mailboxes.Reservation);
      procedure Answer
        (Number : Orders.Ticket;
         Line   : Monitor.Protocol.Short_Text;
         Full   : out Boolean);
      --  Full: before, so somebody may wait for room
      procedure Answer_With_Image
        (Number   : Orders.Ticket;
         Message  : in out Message_Access;
         Accepted : out Boolean);
      procedure Put (Item : Monitor.Mailboxes.Notice; Now : Time);
      procedure Put_Image
        (Message : in out Message_Access;
         Made    : Monitor.Mailboxes.Generation;
         Now     : Time);
      procedure Stop_Images;
      procedure Take
        (Between   : Monitor.Send_Order.Milliseconds;
         Now       : Time;
         Last_Sent : Time;
         Next      : out Monitor.Mailboxes.Item;
         Message   : in out Message_Access;
         Gap       : out Monitor.Send_Order.Milliseconds;
         Hold_End  : out Time;
         Left      : out Boolean;
         Full      : out Boolean)
      with Post => Next.Unsent = (Next.Kind in Monitor.Send_Order.Sent_Kind);
   private
      Mail  : Monitor.Mailboxes.Mailbox;
      Arena : Message_Access := null;  --  of an arena order
      Image : Message_Access := null;  --  the periodic image
   end Box;

   protected body Box is

      procedure Fill (First, Second : in out Message_Access) is
      begin
         Exchange (First, Arena);
         Exchange (Second, Image);
      end Fill;

      procedure Open_Session is
      begin
         Monitor.Mailboxes.Open_Session (Mail);
      end Open_Session;

      procedure Close_Session (Next : out Orders.Ticket) is
      begin
         Monitor.Mailboxes.Close_Session (Mail, Next);
      end Close_Session;

      procedure Get (Value : out Monitor.Mailboxes.Status) is
      begin
         Value := Monitor.Mailboxes.Status_Of (Mail);
      end Get;

      procedure Reserve
        (Now    : Time;
         Number : out Orders.Ticket;
         Result : out Monitor.Mailboxes.Reservation) is
      begin
         Monitor.Mailboxes.Reserve (Mail, Now, Number, Result);
      end Reserve;

      procedure Answer
        (Number : Orders.Ticket;
         Line   : Monitor.Protocol.Short_Text;
         Full   : out Boolean) is
      begin
         Full := Monitor.Mailboxes.Is_Full (Mail);
         Monitor.Mailboxes.Put_Answer (Mail, Number, Line);
      end Answer;

      procedure Answer_With_Image
        (Number   : Orders.Ticket;
         Message  : in out Message_Access;
         Accepted : out Boolean)
      is
         Kept : Boolean;
      begin
         Monitor.Mailboxes.Put_Arena (Mail, Number, Accepted, Kept);
         if Kept then
            Exchange (Message, Arena);
         end if;
      end Answer_With_Image;

      procedure Put (Item : Monitor.Mailboxes.Notice; Now : Time) is
      begin
         Monitor.Mailboxes.Put (Mail, Item, Now);
      end Put;

      procedure Put_Image
        (Message : in out Message_Access;
         Made    : Monitor.Mailboxes.Generation;
         Now     : Time)
      is
         Kept : Boolean;
      begin
         Monitor.Mailboxes.Put_Image (Mail, Made, Now, Kept);
         if Kept then
            Exchange (Message, Image);
         end if;
      end Put_Image;

      procedure Stop_Images is
      begin
         Monitor.Mailboxes.Stop_Images (Mail);
      end Stop_Images;

      procedure Take
        (Between   : Monitor.Send_Order.Milliseconds;
         Now       : Time;
         Last_Sent : Time;
         Next      : out Monitor.Mailboxes.Item;
         Message   : in out Message_Access;
         Gap       : out Monitor.Send_Order.Milliseconds;
         Hold_End  : out Time;
         Left      : out Boolean;
         Full      : out Boolean) is
      begin
         Full := Monitor.Mailboxes.Is_Full (Mail);
         Monitor.Mailboxes.End_Hold (Mail, Now);
         Monitor.Mailboxes.Take
           (Mail, Between, Now, Last_Sent, Next, Gap, Left);
         Hold_End := Monitor.Mailboxes.Hold_End (Mail);
         if Next.Is_Image then
            if Next.Kind = Monitor.Send_Order.Answer then
               Exchange (Message, Arena);
            else
               Exchange (Message, Image);
            end if;
         end if;
      end Take;

   end Box;

   First  : Message_Access := new Monitor.Image_Messages.Message;
   Second : Message_Access := new Monitor.Image_Messages.Message;
   --  The box's own

   procedure Wake_Sender (Number : Orders.Ticket := 0)
   with Annotate => (GNATprove, Terminating);
   --  The box may contain a message to be sent

   procedure Answer
     (Order : in out Orders.Order; Line : Monitor.Protocol.Short_Text)
   is
      Full : Boolean;
   begin
      Box.Answer (Order.Number, Line, Full);
      Order.Owed := False;
      Wake_Sender (Order.Number);
      if Full then
         Room.Set;
      end if;
   end Answer;

   procedure Answer_With_Image
     (Order : in out Orders.Order; Message : in out Message_Access)
   is
      Accepted : Boolean;
   begin
      loop
         Box.Answer_With_Image (Order.Number, Message, Accepted);
         exit when Accepted;
         Trace.Wait (Schedule.Th_Arene, Trace.Room);
         Arena_Room.Wait;
         Trace.Resume (Schedule.Th_Arene);
      end loop;
      Order.Owed := False;
      Wake_Sender (Order.Number);
   end Answer_With_Image;

   procedure Close_Session (Next : out Orders.Ticket) is
   begin
      Box.Close_Session (Next);
      Room.Set;
      Arena_Room.Set;
   end Close_Session;

   procedure Get (Value : out Monitor.Mailboxes.Status) is
   begin
      Box.Get (Value);
   end Get;

   procedure Open_Session is
   begin
      Box.Open_Session;
   end Open_Session;

   procedure Put (Item : Monitor.Mailboxes.Notice) is
      Now : constant Time := Clock;
   begin
      Box.Put (Item, Now);
      Wake_Sender;
   end Put;

   procedure Put_Image
     (Message : in out Message_Access; Made : Monitor.Mailboxes.Generation)
   is
      Now : constant Time := Clock;
   begin
      Box.Put_Image (Message, Made, Now);
      Wake_Sender;
   end Put_Image;

   procedure Reserve (Order : in out Orders.Order) is
      Result : Monitor.Mailboxes.Reservation;
      Now    : Time;
   begin
      loop
         Now := Clock;
         Box.Reserve (Now, Order.Number, Result);
         exit when Result /= Monitor.Mailboxes.Full;
         Trace.Wait (Schedule.Th_Receive_From_Mon, Trace.Room);
         Room.Wait;
         Trace.Resume (Schedule.Th_Receive_From_Mon);
      end loop;
      Order.Owed := Result = Monitor.Mailboxes.Reserved;
   end Reserve;

   procedure Stop_Images is
   begin
      Box.Stop_Images;
   end Stop_Images;

   procedure Take
     (Between   : Monitor.Send_Order.Milliseconds;
      Last_Sent : Ada.Real_Time.Time;
      Next      : in out Monitor.Mailboxes.Item;
      Image     : in out Message_Access;
      Gap       : out Monitor.Send_Order.Milliseconds;
      Hold_End  : out Time)
   is
      Now  : constant Time := Clock;
      Left : Boolean;
      Full : Boolean;
   begin
      Box.Take
        (Between, Now, Last_Sent, Next, Image, Gap, Hold_End, Left, Full);
      if Left then
         Sender_Left.Set;
      end if;
      if Full then
         Room.Set;
      end if;
      if Next.Kind = Monitor.Send_Order.Answer and then Next.Is_Image then
         Arena_Room.Set;
      end if;
   end Take;

   procedure Wait (Hold_End : Time) is
      Was_Set : Boolean;
   begin
      if Hold_End = Time_Last then
         Work.Wait;
      else
         Work.Wait_Until (Hold_End, Was_Set);
         if not Was_Set then
            Trace.Release (Schedule.Th_Send_To_Mon, Hold_End);
         end if;
      end if;
   end Wait;

   procedure Wait_Sender is
      Known : Monitor.Mailboxes.Status;
   begin
      --  the event may be a late one of the previous session
      loop
         Box.Get (Known);
         exit when not Known.Busy;
         Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Tasks);
         Sender_Left.Wait;
         Trace.Resume (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Wait_Sender;

   procedure Wake_Sender (Number : Orders.Ticket := 0) is
   begin
      Trace.Release (Schedule.Th_Send_To_Mon, Number);
      Work.Set;
   end Wake_Sender;

begin

   Box.Fill (First, Second);

end Monitor.Outbox;
