--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks, and exchanges images by reference;
--  Monitor.Mailboxes decides.

with Ada.Real_Time; use Ada.Real_Time;
with Event;
with Schedule;
with Trace;

package body Monitor.Outbox with SPARK_Mode is

   use type Monitor.Mailboxes.Reservation;

   package Room is new Event (Schedule.Th_Receive_From_Mon);
   package Work is new Event (Schedule.Th_Send_To_Mon);
   package Arena_Room is new Event (Schedule.Th_Arene);
   package Sender_Left is new Event (Schedule.Th_Com_Mon_Perdue);

   procedure Exchange (Left, Right : in out Message_Access)
   with
     Pre  => Left /= null or else Right /= null,
     Post => Left /= null
   is
      --  Swaps the two, unless Right is a message that the box is yet to get
      Kept : Message_Access;
   begin
      if Right /= null then
         Kept := Left;
         Left := Right;
         Right := Kept;
      end if;
   end Exchange;

   protected Box with Priority => Schedule.Outbox_Ceiling is
      procedure Fill (First, Second : in out Message_Access)
      with Pre => First /= null and then Second /= null;
      --  The box gets its messages for images
      procedure Open_Session;
      procedure Close_Session (Next : out Commands.Ticket);
      procedure Get (Value : out Monitor.Mailboxes.Status);
      procedure Reserve
        (Number : out Commands.Ticket;
         Result : out Monitor.Mailboxes.Reservation);
      procedure Answer
        (Number : Commands.Ticket;
         Line   : Monitor.Protocol.Short_Text;
         Full   : out Boolean);
      --  Full: before, so somebody may wait for room
      procedure Answer_With_Image
        (Number   : Commands.Ticket;
         Image    : in out Message_Access;
         Accepted : out Boolean)
      with Pre => Image /= null, Post => Image /= null;
      procedure Put (Item : Monitor.Mailboxes.Notice);
      procedure Put_Image
        (Image : in out Message_Access; Made : Monitor.Mailboxes.Generation)
      with Pre => Image /= null, Post => Image /= null;
      procedure Stop_Images;
      procedure Take
        (Between   : Monitor.Mailboxes.Milliseconds;
         Last_Sent : Time;
         Next      : out Monitor.Mailboxes.Item;
         Image     : in out Message_Access;
         Left      : out Boolean;
         Full      : out Boolean)
      with
        Pre  => Image /= null,
        Post => Next.Unsent = (Next.Kind /= Monitor.Mailboxes.Nothing)
          and then Image /= null;
   private
      Mail     : Monitor.Mailboxes.Mailbox;
      Arena    : Message_Access := null;  --  of an arena order
      Periodic : Message_Access := null;
   end Box;

   protected body Box is

      procedure Fill (First, Second : in out Message_Access) is
      begin
         Exchange (Arena, First);
         Exchange (Periodic, Second);
      end Fill;

      procedure Open_Session is
      begin
         Monitor.Mailboxes.Open_Session (Mail);
      end Open_Session;

      procedure Close_Session (Next : out Commands.Ticket) is
      begin
         Monitor.Mailboxes.Close_Session (Mail);
         Next := Mail.Next;
      end Close_Session;

      procedure Get (Value : out Monitor.Mailboxes.Status) is
      begin
         Value := Monitor.Mailboxes.Status_Of (Mail);
      end Get;

      procedure Reserve
        (Number : out Commands.Ticket;
         Result : out Monitor.Mailboxes.Reservation)
      is
         Now : constant Time := Clock;
      begin
         Monitor.Mailboxes.Reserve (Mail, Now, Number, Result);
      end Reserve;

      procedure Answer
        (Number : Commands.Ticket;
         Line   : Monitor.Protocol.Short_Text;
         Full   : out Boolean) is
      begin
         Full := Monitor.Mailboxes.Pending (Mail) = Commands.Capacity;
         Monitor.Mailboxes.Put_Answer
           (Mail, Number,
            ((if Line.Length > 0 then Monitor.Mailboxes.Ready_Text
              else Monitor.Mailboxes.Ready_Nothing), Line));
      end Answer;

      procedure Answer_With_Image
        (Number   : Commands.Ticket;
         Image    : in out Message_Access;
         Accepted : out Boolean)
      is
         Kept : Boolean;
      begin
         Monitor.Mailboxes.Put_Arena (Mail, Number, Accepted, Kept);
         if Kept then
            Exchange (Image, Arena);
         end if;
      end Answer_With_Image;

      procedure Put (Item : Monitor.Mailboxes.Notice) is
         Now : constant Time := Clock;
      begin
         Monitor.Mailboxes.Put (Mail, Item, Now);
      end Put;

      procedure Put_Image
        (Image : in out Message_Access; Made : Monitor.Mailboxes.Generation)
      is
         Now  : constant Time := Clock;
         Kept : Boolean;
      begin
         Monitor.Mailboxes.Put_Image (Mail, Made, Now, Kept);
         if Kept then
            Exchange (Image, Periodic);
         end if;
      end Put_Image;

      procedure Stop_Images is
      begin
         Monitor.Mailboxes.Stop_Images (Mail);
      end Stop_Images;

      procedure Take
        (Between   : Monitor.Mailboxes.Milliseconds;
         Last_Sent : Time;
         Next      : out Monitor.Mailboxes.Item;
         Image     : in out Message_Access;
         Left      : out Boolean;
         Full      : out Boolean)
      is
         Now : constant Time := Clock;
      begin
         Full := Monitor.Mailboxes.Pending (Mail) = Commands.Capacity;
         Monitor.Mailboxes.End_Hold (Mail, Now);
         Monitor.Mailboxes.Take (Mail, Between, Now, Last_Sent, Next, Left);
         if Next.Kind = Monitor.Mailboxes.Image then
            Exchange (Image, Periodic);
         elsif Next.Is_Image then
            Exchange (Image, Arena);
         end if;
      end Take;

   end Box;

   First  : Message_Access := new Message;
   Second : Message_Access := new Message;
   --  The box's own

   procedure Answer
     (Order : in out Commands.Order; Line : Monitor.Protocol.Short_Text)
   is
      Full : Boolean;
   begin
      Box.Answer (Order.Number, Line, Full);
      Order.Owed := False;
      Work.Set (Order.Number);
      if Full then
         Room.Set;
      end if;
   end Answer;

   procedure Answer_With_Image
     (Order : in out Commands.Order; Image : in out Message_Access)
   is
      Accepted : Boolean;
   begin
      loop
         pragma Loop_Invariant (Image /= null);
         Box.Answer_With_Image (Order.Number, Image, Accepted);
         exit when Accepted;
         Arena_Room.Wait_In_Job (Trace.Room);
      end loop;
      Order.Owed := False;
      Work.Set (Order.Number);
   end Answer_With_Image;

   procedure Close_Session (Next : out Commands.Ticket) is
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
   begin
      Box.Put (Item);
      Work.Set;
   end Put;

   procedure Put_Image
     (Image : in out Message_Access; Made : Monitor.Mailboxes.Generation) is
   begin
      Box.Put_Image (Image, Made);
      Work.Set;
   end Put_Image;

   procedure Reserve (Order : in out Commands.Order) is
      Result : Monitor.Mailboxes.Reservation;
   begin
      loop
         Box.Reserve (Order.Number, Result);
         exit when Result /= Monitor.Mailboxes.Full;
         Room.Wait_In_Job (Trace.Room);
      end loop;
      Order.Owed := Result = Monitor.Mailboxes.Reserved;
      if Order.Owed then
         Trace.Put
           (Trace.Received, Schedule.Th_Receive_From_Mon, Order.Number,
            Commands.Table (Order.Command.Name).Label & "  ");
      end if;
   end Reserve;

   procedure Stop_Images is
   begin
      Box.Stop_Images;
   end Stop_Images;

   procedure Take
     (Between   : Monitor.Mailboxes.Milliseconds;
      Last_Sent : Ada.Real_Time.Time;
      Next      : in out Monitor.Mailboxes.Item;
      Image     : in out Message_Access)
   is
      Left : Boolean;
      Full : Boolean;
   begin
      Box.Take (Between, Last_Sent, Next, Image, Left, Full);
      if Left then
         Sender_Left.Set;
      end if;
      if Full then
         Room.Set;
      end if;
      if Next.Kind = Monitor.Mailboxes.Answer and then Next.Is_Image then
         Arena_Room.Set;
      end if;
   end Take;

   procedure Wait (Hold_End : Time) is
      Ignored : Boolean;
   begin
      if Hold_End = Time_Last then
         Work.Wait;
      else
         Work.Wait_Until (Hold_End, Ignored);
      end if;
   end Wait;

   procedure Wait_Sender is
      Known : Monitor.Mailboxes.Status;
   begin
      --  the event may be a late one of the previous session
      loop
         Box.Get (Known);
         exit when not Known.Busy;
         Sender_Left.Wait_In_Job (Trace.Tasks);
      end loop;
   end Wait_Sender;

begin
   Box.Fill (First, Second);
end Monitor.Outbox;
