--  SPDX-License-Identifier: GPL-3.0-or-later
--  The outbox: images pass from hand to hand, and whoever waits is woken.

with Ada.Real_Time;    use Ada.Real_Time;

with AUnit.Assertions; use AUnit.Assertions;

with Image_Messages;   use Image_Messages;
with Mailboxes;
with Monitor_Protocol;
with Orders;           use Orders;
with Outbox;
with Send_Order;       use Send_Order;

package body Outbox_Tests is

   use all type Monitor_Protocol.Answer_Kind;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Made_Here : Message_Access := new Message;  --  to be filled next
   Sent_Here : Message_Access := new Message;  --  taken last

   procedure Begin_Anew;
   --  A session with nothing in it.

   procedure Check (Kind : Choice; Image : String := "");
   --  What is taken next; the image's text.

   procedure Fill (Text : String);

   procedure Put_Picture (Text : String);
   --  A periodic image.

   procedure Test_Images (T : in out Any_Test);
   procedure Test_Arena (T : in out Any_Test);
   procedure Test_Answers (T : in out Any_Test);

   ----------------
   -- Begin_Anew --
   ----------------

   procedure Begin_Anew is
      Next : Ticket;
   begin
      Outbox.Close_Session (Next);
      Assert (Next > 0, "numbers begin at 1");
      Outbox.Open_Session;
   end Begin_Anew;

   -----------
   -- Check --
   -----------

   procedure Check (Kind : Choice; Image : String := "") is
      Next : Mailboxes.Item;
      Gap  : Send_Order.Milliseconds;
   begin
      Outbox.Take (20, Time_First, Next, Sent_Here, Gap);
      Assert (Next.Kind = Kind, Next.Kind'Image & " taken");
      Assert (Next.Is_Image = (Image /= ""), "is it an image?");
      if Image /= "" then
         Assert (Sent_Here.Data (1 .. Sent_Here.Length) = Image,
                 Image & " taken");
      end if;
   end Check;

   ----------
   -- Fill --
   ----------

   procedure Fill (Text : String) is
   begin
      Made_Here.Length := Text'Length;
      Made_Here.Data (1 .. Text'Length) := Text;
   end Fill;

   ----------
   -- Name --
   ----------

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Outbox"));

   -----------------
   -- Put_Picture --
   -----------------

   procedure Put_Picture (Text : String) is
      Made : Mailboxes.Generation;
   begin
      Outbox.Get_Generation (Made);
      Fill (Text);
      Outbox.Put_Image (Made_Here, Made);
      Assert (Made_Here /= null and then Made_Here /= Sent_Here,
              "another one to be filled");
   end Put_Picture;

   --------------------
   -- Register_Tests --
   --------------------

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Images'Access, "images go round");
      Register_Routine (T, Test_Arena'Access, "an answer that is an image");
      Register_Routine (T, Test_Answers'Access, "answers, and who waits");
   end Register_Tests;

   ------------------
   -- Test_Answers --
   ------------------

   procedure Test_Answers (T : in out Any_Test) is
      pragma Unreferenced (T);
      First, Second : Order;
      Count         : Order_Count;
      Any           : Boolean;
      At_Time       : Time;
   begin
      Begin_Anew;
      Outbox.Reserve (First);
      Outbox.Reserve (Second);
      Assert (First.Owed and then Second.Owed, "both are owed");
      Assert (Second.Number = First.Number + 1, "numbers in a row");
      Outbox.Put_Battery (Battery_Full);
      Outbox.Wait_Held;
      Outbox.Get_Hold_End (Any, At_Time);
      Assert (Any and then At_Time > Clock, "held back");
      Outbox.Answer_Nothing (Second);
      Outbox.Wait;
      Check (Nothing);
      Outbox.Answer (First, Refused);
      Outbox.Wait;
      Outbox.Get_Waiting (Count);
      Assert (Count = 2, "two wait");
      Check (Send_Order.Answer);
      Outbox.Get_Waiting (Count);
      Assert (Count = 0, "nobody waits");
      Check (Battery);
      Assert (not First.Owed and then not Second.Owed, "nothing is owed");
   end Test_Answers;

   ----------------
   -- Test_Arena --
   ----------------

   procedure Test_Arena (T : in out Any_Test) is
      pragma Unreferenced (T);
      Item : Order;
   begin
      Begin_Anew;
      for Turn in 1 .. 3 loop
         Put_Picture ("CIMG:periodic");
         Outbox.Reserve (Item);
         Fill ("CIMG:arena");
         Outbox.Answer_With_Image (Item, Made_Here);
         Assert (not Item.Owed, "answered");
         Check (Send_Order.Answer, "CIMG:arena");
         Check (Send_Order.Image, "CIMG:periodic");
      end loop;
   end Test_Arena;

   -----------------
   -- Test_Images --
   -----------------

   procedure Test_Images (T : in out Any_Test) is
      pragma Unreferenced (T);
      Made : Mailboxes.Generation;
   begin
      Begin_Anew;
      for Turn in 1 .. 3 loop
         Put_Picture ("CIMG:one");
         Put_Picture ("CIMG:second");
         Check (Image, "CIMG:second");
         Check (Nothing);
      end loop;
      Outbox.Get_Generation (Made);
      Outbox.Stop_Images;
      Fill ("CIMG:late");
      Outbox.Put_Image (Made_Here, Made);
      Check (Nothing);
   end Test_Images;

end Outbox_Tests;
