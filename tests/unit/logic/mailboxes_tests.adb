--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits for the monitor: order of the answers, the newest image, what is
--  next, the gap and the hold, by a clock of the test's own.

with Ada.Real_Time;

with AUnit.Assertions;   use AUnit.Assertions;

with Commands; use Commands;
with Monitor.Mailboxes;  use Monitor.Mailboxes;
with Monitor.Notices;
with Monitor.Protocol; use Monitor.Protocol;
with Schedule;
with Unit_Runs; use Unit_Runs;

procedure Mailboxes_Tests is

   use type Ada.Real_Time.Time;
   use type Ada.Real_Time.Time_Span;

   function Ms (Count : Integer) return Ada.Real_Time.Time_Span
   renames Ada.Real_Time.Milliseconds;

   Between : constant := 20;

   B   : Mailbox;
   Now : Time;
   --  Of the test

   procedure Answer
     (Number : Ticket; Line : Monitor.Protocol.Short_Text := Acknowledged) is
   begin
      Put_Answer
        (B, Number,
         ((if Line.Length > 0 then Ready_Text else Ready_Nothing), Line));
   end Answer;

   procedure Begin_Anew is
      --  A session with nothing in it.
   begin
      Now := Ada.Real_Time.Clock;
      Close_Session (B);
      Assert (B.Next > 0, "numbers begin at 1");
      Open_Session (B);
   end Begin_Anew;

   procedure Check
     (Kind : Choice; Text : String := ""; Kept : Natural := Between)
   is
      --  What is taken next, Kept ms after the one before; Text without its
      --  line feed, empty for an image.
      Next : Monitor.Mailboxes.Item;
      Left : Boolean;
   begin
      Take (B, Between, Now, Now - Ms (Kept), Next, Left);
      Assert (Next.Kind = Kind, Text & ": " & Next.Kind'Image);
      Assert (Next.Unsent = (Kind /= Nothing), "to be sent");
      if Kind /= Nothing and then not Next.Is_Image then
         Assert (Next.Line.Data (1 .. Next.Line.Length) = Text & Line_Feed,
                 Text & ", not " & Next.Line.Data (1 .. Next.Line.Length));
      end if;
      Assert (not Left, "the session lasts");
   end Check;

   procedure Check_Gap (Expected : Natural) is
      Due : constant Milliseconds := Gap (B, Next (B), Between);
   begin
      Assert (Due = Expected, "the gap is" & Due'Image);
   end Check_Gap;

   function Is_Held return Boolean is
     (Hold_End (B) < Ada.Real_Time.Time_Last);
   --  Unsolicited messages are held back

   procedure Check_Hold (Held : Boolean) is
   begin
      Assert (Is_Held = Held, "held back: " & Is_Held'Image);
   end Check_Hold;

   procedure Pass (Span : Ada.Real_Time.Time_Span) is
      --  The time passes.
   begin
      Now := Now + Span;
      End_Hold (B, Now);
   end Pass;

   function Place return Ticket is
      --  Of the next command.
      Number : Ticket;
      Result : Reservation;
   begin
      Reserve (B, Now, Number, Result);
      Assert (Result = Reserved, "reserved");
      return Number;
   end Place;

   procedure Put_Image is
      Kept : Boolean;
   begin
      Put_Image (B, B.Made, Now, Kept);
      Assert (Kept, "the image is kept");
   end Put_Image;

   procedure Put (Kind : Notice_Kind; Text : String; Number : Ticket := 0) is
   begin
      Put (B, (Kind, Short (Text), Number, B.Made), Now);
   end Put;

   procedure Put_Battery is
   begin
      Put (Battery, "RBLV:2");
   end Put_Battery;

   procedure Put_End (Number : Ticket; Text : String) is
   begin
      Put (Ending, Text, Number);
   end Put_End;

   procedure Put_Progress (Number : Ticket; Text : String) is
   begin
      Put (Progress, Text, Number);
   end Put_Progress;

   procedure Test_Arena is
      First, Second  : Ticket;
      Accepted, Kept : Boolean;
   begin
      Begin_Anew;
      First := Place;
      Second := Place;
      Put_Arena (B, Second, Accepted, Kept);
      Assert (Accepted and then Kept, "kept for its turn");
      Put_Arena (B, First, Accepted, Kept);
      Assert (not Accepted, "the one before waits still");
      Answer (First);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check (Monitor.Mailboxes.Answer);
      Put_Arena (B, Second, Accepted, Kept);
      Assert (Accepted and then not Kept, "answered already");
      Check (Nothing);
   end Test_Arena;

   procedure Test_Full is
      First  : Ticket;
      Number : Ticket;
      Result : Reservation;
   begin
      Begin_Anew;
      First := Place;
      for I in 2 .. Capacity loop
         Assert (Place = First + Ticket (I) - 1, "numbers in a row");
      end loop;
      Assert (Pending (B) = Capacity, "full");
      Reserve (B, Now, Number, Result);
      Assert (Result = Full, "no more room");
      Answer (First);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Assert (Place = First + Capacity, "room again");
   end Test_Full;

   procedure Test_Gap is
   begin
      Begin_Anew;
      Put (Position, "CPOS:one");
      Put_Image;
      Check_Gap (0);
      Check (Image, Kept => 0);
      Check_Gap (20);
      Put_Image;
      Put (Position, "CPOS:two");
      Check (Nothing, Kept => 19);
      Check (Position, "CPOS:two");
      Answer (Place);
      Check_Gap (4);
      Check (Nothing, Kept => 3);
      Check (Monitor.Mailboxes.Answer, "AACK", Kept => 4);
      Check_Gap (20);
      Check (Nothing, Kept => 19);
      Check (Image);
      Check_Gap (0);
      Check (Nothing);
   end Test_Gap;

   procedure Test_Gaps is

      procedure Check
        (Last, Sent : Choice;
         Between    : Milliseconds;
         Expected   : Milliseconds;
         Released   : Boolean := False)
      is
         Value : constant Milliseconds :=
           Gap
             ((Last   => Last,
               Held   => (Released => Released, others => <>),
               others => <>),
              Sent, Between);
      begin
         Assert (Value = Expected,
                 Sent'Image & " after " & Last'Image & ":" & Value'Image);
      end Check;

      After_Command : constant Choice := Monitor.Mailboxes.Answer;

   begin
      Check (Nothing, Image, 20, 0);
      Check (Image, Position, 20, 20);
      Check (Position, Battery, 20, 20);
      Check (Image, After_Command, 20, 4);
      Check (Image, After_Command, 3, 3);
      Check (Image, After_Command, 0, 0);
      Check (After_Command, After_Command, 20, 0);
      Check (After_Command, Image, 20, 20);
      Check (After_Command, Image, 20, 4, Released => True);
      Check (After_Command, Image, 0, 0, Released => True);
      Check (Image, Battery, 20, 20, Released => True);
      Check (Image, After_Command, 1_000, 4);
      Check (Image, Nothing, 20, 0);
   end Test_Gaps;

   procedure Test_Hold is
      First, Second : Ticket;
   begin
      Begin_Anew;
      First := Place;
      Second := Place;
      Put_Battery;
      Put_Image;
      Assert (Hold_End (B) = Now + Schedule.Hold_Limit, "its end");
      Pass (Schedule.Hold_Limit - Ms (1));
      Check (Nothing);
      Pass (Ms (1));
      Check_Hold (False);
      Answer (First);
      Answer (Second, Monitor.Protocol.Refused);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check (Battery, "RBLV:2");
      Check (Monitor.Mailboxes.Answer, "ACRJ");
      Check (Image);
   end Test_Hold;

   procedure Test_Hold_Of_All is
      --  A command each 10 ms, answered at once, leaves no gap of 20 ms
      Turns : Natural := 0;
   begin
      Begin_Anew;
      Answer (Place);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Put_Battery;
      Check_Hold (False);
      loop
         Answer (Place);
         Check (Monitor.Mailboxes.Answer, "AACK");
         Turns := Turns + 1;
         Assert (Turns <= 2 * 95, "held back for ever");
         Pass (Ms (10));
         exit when not Is_Held;
      end loop;
      Assert (Turns >= 95, "not held back:" & Turns'Image);
      Check (Battery, "RBLV:2", Kept => 10);
   end Test_Hold_Of_All;

   procedure Test_Hold_Of_Each is
      --  However long unsolicited messages have waited for a slow monitor
      Number : Ticket;
   begin
      Begin_Anew;
      Number := Place;
      Put_Battery;
      Put_Image;
      Check_Hold (True);
      Answer (Number);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check (Battery, "RBLV:2");
      Pass (Ms (500));
      Number := Place;
      Assert (Hold_End (B) = Now + Schedule.Hold_Limit, "put off");
      Pass (Schedule.Hold_Limit - Ms (500));
      Check (Nothing);
      Pass (Ms (500));
      Check (Image);
      Answer (Number);
      Check (Monitor.Mailboxes.Answer, "AACK");
   end Test_Hold_Of_Each;

   procedure Test_Mission is
      Number, Stop : Ticket;
   begin
      Begin_Anew;
      Number := Place;
      Answer (Number);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Put_Progress (Number, "MPRG:1;2;300");
      Put_Progress (Number, "MPRG:1;2;200");
      Put_Battery;
      Check (Progress, "MPRG:1;2;200");
      Check (Battery, "RBLV:2");
      Check (Nothing);

      --  the end drops progress, and images do not drop the end

      Put_Progress (Number, "MPRG:2;2;100");
      Put_End (Number, "MEND:done");
      Put_Progress (Number, "MPRG:2;2;90");
      Put (Position, "CPOS:one");
      Put_Image;
      Stop_Images (B);
      Put_Image;
      Check (Ending, "MEND:done");
      Check (Image);
      Check (Nothing);

      --  held back by the command that ends it

      Stop := Place;
      Put_End (Number, "MEND:aborted;order by hand");
      Check_Hold (True);
      Check (Nothing);
      Answer (Stop);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check_Gap (20);
      Check (Ending, "MEND:aborted;order by hand");
      Check (Nothing);
   end Test_Mission;

   procedure Test_Newest is
   begin
      Begin_Anew;
      Put_Image;
      Put_Image;
      Put (B, Told (Monitor.Notices.Camera_Stopped), Now);
      Put (Lost, "ATIM");
      Put (B, Told (Monitor.Notices.Robot_Lost_Empty), Now);
      Check (Lost, "ATIM");
      Check (Text, "MSSG:camera closed: it delivers no images any more");
      Check (Text, "MSSG:robot lost: its battery was empty, it may be off: "
                   & "charge it");
      Put (Lost, "ATIM");
      Check (Lost, "ATIM");
      Check (Image);
      Check (Nothing);
      Put_Image;
      Stop_Images (B);
      Check (Nothing);
   end Test_Newest;

   procedure Test_Old_Mission is
      Old, Next : Ticket;
   begin
      Begin_Anew;
      Old := Place;
      Answer (Old);
      Put_Progress (Old, "MPRG:1;1;300");
      Put_End (Old, "MEND:done");
      Close_Session (B);
      Put_End (Old, "MEND:done");
      Open_Session (B);
      Put_Progress (Old, "MPRG:1;1;300");
      Put_End (Old, "MEND:done");
      Check (Nothing);
      Next := Place;
      Answer (Next);
      Put_End (Next, "MEND:done");
      Put_End (Old, "MEND:aborted;monitor lost");
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check (Ending, "MEND:done");
   end Test_Old_Mission;

   procedure Test_Order is
      First, Second, Third : Ticket;
   begin
      Begin_Anew;
      First := Place;
      Second := Place;
      Third := Place;
      Put_Image;
      Answer (Third, Monitor.Protocol.Refused);
      Check (Nothing);
      Answer (Second, No_Line);
      Answer (First);
      Answer (First, Monitor.Protocol.Timed_Out);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check (Monitor.Mailboxes.Answer, "ACRJ");
      Check (Image);
   end Test_Order;

   procedure Test_Stale is
      Old, Next : Ticket;
      Kept      : Boolean;
      Made      : constant Generation := B.Made;
   begin
      Begin_Anew;
      Old := Place;
      Begin_Anew;
      Next := Place;
      Assert (Next > Old, "no number twice");
      Answer (Old, Monitor.Protocol.Refused);
      Answer (Next + 1, Monitor.Protocol.Refused);
      Put_Image (B, Made, Now, Kept);
      Assert (not Kept, "an image of another session");
      Check (Nothing);
      Answer (Next);
      Check (Monitor.Mailboxes.Answer, "AACK");
   end Test_Stale;

   procedure Test_Turns is
   begin
      Begin_Anew;
      Put_Image;
      Put (Position, "CPOS:one");
      --  a monitor so slow that there are always new ones of both
      for Round in 1 .. 3 loop
         Put_Battery;
         Check (Battery, "RBLV:2");
         Check (Image);
         Put_Image;
         Put_Battery;
         Check (Battery, "RBLV:2");
         Check (Position, "CPOS:one");
         Put (Position, "CPOS:one");
      end loop;
      --  one without the other
      B.Image := False;
      Check (Position, "CPOS:one");
      for Round in 1 .. 2 loop
         Put_Image;
         Check (Image);
      end loop;
   end Test_Turns;

   procedure Test_Urgency is
      Number : Ticket;
   begin
      Begin_Anew;
      Number := Place;
      Put_Image;
      Put (Position, "CPOS:one");
      Put_Battery;
      Put_End (Number, "MEND:done");
      Put (Text, "MSSG:text");
      Put (Lost, "ATIM");
      Answer (Number);
      Check (Monitor.Mailboxes.Answer, "AACK");
      Check (Lost, "ATIM");
      Check (Text, "MSSG:text");
      Check (Ending, "MEND:done");
      Check (Battery, "RBLV:2");
      Check (Image);
      Check (Position, "CPOS:one");
      Check (Nothing);
      Put_Image;
      B.Open := False;
      Check (Nothing);
   end Test_Urgency;

begin
   Run_Test ("most urgent first", Test_Urgency'Access);
   Run_Test ("image and position in turn", Test_Turns'Access);
   Run_Test ("the gap by default", Test_Gaps'Access);
   Run_Test ("answers in order", Test_Order'Access);
   Run_Test ("the newest image wins", Test_Newest'Access);
   Run_Test ("an answer that is an image", Test_Arena'Access);
   Run_Test ("rule 7: the hold", Test_Hold'Access);
   Run_Test ("each command has its hold", Test_Hold_Of_Each'Access);
   Run_Test ("commands without end hold no longer", Test_Hold_Of_All'Access);
   Run_Test ("the gap and the turns", Test_Gap'Access);
   Run_Test ("progress and end", Test_Mission'Access);
   Run_Test ("a mission of another session", Test_Old_Mission'Access);
   Run_Test ("numbers out of date", Test_Stale'Access);
   Run_Test ("room for 256", Test_Full'Access);
end Mailboxes_Tests;
