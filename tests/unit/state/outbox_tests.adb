--  SPDX-License-Identifier: GPL-3.0-or-later
--  The outbox: images are passed by reference, and waiting tasks are woken.

with Ada.Real_Time;    use Ada.Real_Time;

with Commands; use Commands;
with Monitor.Mailboxes;
with Monitor.Outbox;   use Monitor.Outbox;
with Monitor.Protocol; use Monitor.Protocol;
with Schedule;
with Unit_Runs; use Unit_Runs;

procedure Outbox_Tests is

   use all type Monitor.Mailboxes.Choice;

   Made_Here : Message_Access := new Message;  --  to be filled next
   Sent_Here : Message_Access := new Message;  --  taken last
   Hold_End  : Time := Time_Last;              --  as Take has said it last

   procedure Begin_Anew is
      --  A session with nothing in it.
      Next : Ticket;
   begin
      Monitor.Outbox.Close_Session (Next);
      Assert (Next > 0, "numbers begin at 1");
      Monitor.Outbox.Open_Session;
   end Begin_Anew;

   procedure Check (Kind : Monitor.Mailboxes.Choice; Image : String := "") is
      --  What is taken next; the image's text.
      Next : Monitor.Mailboxes.Item;
   begin
      Monitor.Outbox.Take (20, Time_First, Next, Sent_Here);
      Hold_End := Next.Hold_End;
      Assert (Next.Kind = Kind, Next.Kind'Image & " taken");
      Assert (Next.Is_Image = (Image /= ""), "is it an image?");
      if Image /= "" then
         Assert (Sent_Here.Data (1 .. Sent_Here.Length) = Image,
                 Image & " taken");
      end if;
   end Check;

   procedure Fill (Text : String) is
   begin
      Made_Here.Length := Text'Length;
      Made_Here.Data (1 .. Text'Length) := Text;
   end Fill;

   procedure Put_Picture (Text : String) is
      --  A periodic image.
      Known : Monitor.Mailboxes.Status;
   begin
      Monitor.Outbox.Get (Known);
      Fill (Text);
      Monitor.Outbox.Put_Image (Made_Here, Known.Made);
      Assert (Made_Here /= null and then Made_Here /= Sent_Here,
              "another one to be filled");
   end Put_Picture;

   procedure Test_Answers is
      First, Second : Order;
      Known         : Monitor.Mailboxes.Status;
   begin
      Begin_Anew;
      Monitor.Outbox.Reserve (First);
      Monitor.Outbox.Reserve (Second);
      Assert (First.Owed and then Second.Owed, "both are owed");
      Assert (Second.Number = First.Number + 1, "numbers in a row");
      Monitor.Outbox.Answer (Second, No_Line);
      Monitor.Outbox.Wait (Hold_End);
      Check (Nothing);
      Monitor.Outbox.Answer (First, Monitor.Protocol.Refused);
      Monitor.Outbox.Wait (Hold_End);
      Monitor.Outbox.Get (Known);
      Assert (Known.Pending = 2, "two wait");
      Check (Monitor.Mailboxes.Answer);
      Monitor.Outbox.Get (Known);
      Assert (Known.Pending = 0, "nobody waits");
      Assert (not First.Owed and then not Second.Owed, "nothing is owed");
   end Test_Answers;

   procedure Test_Hold is
      --  Its end wakes the sender, though the answer never comes.
      Begun : Time;
      Item  : Order;
      Next  : Monitor.Mailboxes.Item;
   begin
      Begin_Anew;
      Monitor.Outbox.Reserve (Item);
      Begun := Clock;
      Monitor.Outbox.Put
        ((Monitor.Mailboxes.Battery, Short ("RBLV:2"), others => <>));
      loop
         Monitor.Outbox.Wait (Hold_End);
         Monitor.Outbox.Take (20, Time_First, Next, Sent_Here);
         Hold_End := Next.Hold_End;
         exit when Next.Kind /= Nothing;
      end loop;
      Assert (Next.Kind = Battery, Next.Kind'Image & " taken");
      Assert (Clock >= Begun + Schedule.Hold_Limit, "held back");
      Assert (Hold_End = Time_Last, "held back no more");
      Monitor.Outbox.Answer (Item, Monitor.Protocol.Refused);
   end Test_Hold;

   procedure Test_Images is
      Item  : Order;
      Known : Monitor.Mailboxes.Status;
   begin
      Begin_Anew;
      for Turn in 1 .. 3 loop
         Put_Picture ("CIMG:one");
         Put_Picture ("CIMG:second");
         Check (Image, "CIMG:second");
         Check (Nothing);
      end loop;
      for Turn in 1 .. 3 loop
         Put_Picture ("CIMG:periodic");
         Monitor.Outbox.Reserve (Item);
         Fill ("CIMG:arena");
         Monitor.Outbox.Answer_With_Image (Item, Made_Here);
         Assert (not Item.Owed, "answered");
         Check (Monitor.Mailboxes.Answer, "CIMG:arena");
         Check (Image, "CIMG:periodic");
      end loop;
      Monitor.Outbox.Get (Known);
      Monitor.Outbox.Stop_Images;
      Fill ("CIMG:late");
      Monitor.Outbox.Put_Image (Made_Here, Known.Made);
      Check (Nothing);
   end Test_Images;

begin
   Run_Test ("images go round, also as an answer", Test_Images'Access);
   Run_Test ("answers, and who waits", Test_Answers'Access);
   Run_Test ("the end of the hold", Test_Hold'Access);
end Outbox_Tests;
