--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits for the monitor: order of the answers, the newest image, what is
--  next, the gap and the hold, by a clock of the test's own.

with Ada.Real_Time;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Commands; use Commands;
with Monitor.Mailboxes;  use Monitor.Mailboxes;
with Monitor.Protocol; use Monitor.Protocol;
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

   Number : array (Character range 'a' .. 'c') of Ticket;
   --  Of the commands of a script

   procedure Begin_Anew is
      --  A session with nothing in it.
   begin
      Now := Ada.Real_Time.Clock;
      Close_Session (B);
      Assert (B.Next > 0, "numbers begin at 1");
      Open_Session (B);
   end Begin_Anew;

   procedure Check
     (Kind   : Choice;
      Text   : String  := "";
      Kept   : Natural := Between;
      Script : String  := "")
   is
      --  What is taken next, Kept ms after the one before; Text without its
      --  line feed, empty for an image.
      Next : Monitor.Mailboxes.Item;
      Left : Boolean;
   begin
      Take (B, Between, Now, Now - Ms (Kept), Next, Left);
      Assert (Next.Kind = Kind,
              Text & ": " & Next.Kind'Image & " in " & Script);
      Assert (Next.Unsent = (Kind /= Nothing), "to be sent");
      if Kind /= Nothing and then not Next.Is_Image then
         Assert (Next.Line.Data (1 .. Next.Line.Length) = Text & Line_Feed,
                 Text & ", not " & Next.Line.Data (1 .. Next.Line.Length)
                 & " in " & Script);
      end if;
      Assert (not Left, "the session lasts");
   end Check;

   function Is_Held return Boolean is
     (Hold_End (B) < Ada.Real_Time.Time_Last);
   --  Unsolicited messages are held back

   function Place return Ticket is
      --  Of the next command.
      Number : Ticket;
      Result : Reservation;
   begin
      Reserve (B, Now, Number, Result);
      Assert (Result = Reserved, "reserved");
      return Number;
   end Place;

   function Line_Of (Word : String) return Short_Text is
     (Short (Head (Word, Word'Length)));
   --  Head makes its first index 1

   function Kind_Of (Line : String) return Choice is
     (if Line = "" then Nothing
      elsif Line = "image" then Image
      elsif Head (Line, 4) = "ATIM" then Lost
      elsif Head (Line, 4) = "MSSG" then Text
      elsif Head (Line, 4) = "MEND" then Ending
      elsif Head (Line, 4) = "MPRG" then Progress
      elsif Head (Line, 4) = "RBLV" then Battery
      elsif Head (Line, 4) = "CPOS" then Position
      else Answer);

   procedure Play (Script : String) is
      --  Its words: "new", "closed" and "reopened" are of the session, "stop"
      --  of the images; a command "a", "b" or "c" arrives; "a=LINE" answers
      --  it, "a=" with nothing; "image" and a line put an unsolicited message,
      --  "a/LINE" one of the mission that it began; "+N": so many ms pass;
      --  ">LINE" or ">image" is taken next, ">" nothing, "N>" so many ms after
      --  the one before; "gap=N"; "held" and "free": unsolicited ones are held
      --  back, or not; "hold=N": for so many ms

      procedure Put (Line : String; Of_Mission : Ticket := 0) is
      begin
         Put (B, (Kind_Of (Line), Line_Of (Line), Of_Mission, B.Made), Now);
      end Put;

      procedure Carry_Out (Word : String) is
         First : Character renames Word (Word'First);
         Taken : constant Natural := Index (Word, ">");
         Rest  : constant String := Word (Word'First + 2 .. Word'Last);
         Kept  : Boolean;
      begin
         if Word = "new" then
            Begin_Anew;
         elsif Word = "closed" then
            Close_Session (B);
         elsif Word = "reopened" then
            Open_Session (B);
         elsif Word = "stop" then
            Stop_Images (B);
         elsif Word = "image" then
            Put_Image (B, B.Made, Now, Kept);
            Assert (Kept, "the image is kept");
         elsif Word in "held" | "free" then
            Assert (Is_Held = (Word = "held"), "not " & Word & ": " & Script);
         elsif Taken > 0 then
            Check
              (Kind_Of (Word (Taken + 1 .. Word'Last)),
               Word (Taken + 1 .. Word'Last),
               (if Taken = Word'First then Between
                else Natural'Value (Word (Word'First .. Taken - 1))),
               Script);
         elsif First = '+' then
            Now := Now + Ms (Integer'Value (Word));
            End_Hold (B, Now);
         elsif Head (Word, 5) = "hold=" then
            Assert (Hold_End (B) = Now + Ms (Integer'Value (Tail (Word, 3))),
                    "not " & Word & ": " & Script);
         elsif Head (Word, 4) = "gap=" then
            Assert (Gap (B, Next (B), Between)'Image = " "
                    & Word (Word'First + 4 .. Word'Last),
                    "not " & Word & ": " & Script);
         elsif Word'Length = 1 then
            Number (First) := Place;
         elsif Word (Word'First + 1) = '/' then
            Put (Rest, Number (First));
         elsif Word (Word'First + 1) = '=' then
            Put_Answer
              (B, Number (First),
               (if Rest = "" then (Ready_Nothing, No_Line)
                else (Ready_Text, Line_Of (Rest))));
         else
            Put (Word);
         end if;
      end Carry_Out;

   begin
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

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
      Put_Answer (B, First, (Ready_Text, Acknowledged));
      Check (Answer, "AACK");
      Check (Answer);
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
      Put_Answer (B, First, (Ready_Text, Acknowledged));
      Check (Answer, "AACK");
      Assert (Place = First + Capacity, "room again");
   end Test_Full;

   procedure Test_Hold_Of_All is
      --  A command each 10 ms, answered at once, leaves no gap of 20 ms
      Turns : Natural := 0;
   begin
      Play ("new a a=AACK >AACK RBLV:2 free");
      loop
         Play ("a a=AACK >AACK");
         Turns := Turns + 1;
         Assert (Turns <= 2 * 95, "held back for ever");
         Play ("+10");
         exit when not Is_Held;
      end loop;
      Assert (Turns >= 95, "not held back:" & Turns'Image);
      Play ("10>RBLV:2");
   end Test_Hold_Of_All;

begin
   Run_Scripts
     (Play'Access,
      "most urgent first: new a image CPOS:one RBLV:2 a/MEND:done MSSG:text "
      & "ATIM a=AACK >AACK >ATIM >MSSG:text >MEND:done >RBLV:2 >image "
      & ">CPOS:one >"

      --  a monitor so slow that there are always new ones of both; then one
      --  without the other
      & "|image and position in turn: new image CPOS:one"
      & 3 * " RBLV:2 >RBLV:2 >image image RBLV:2 >RBLV:2 >CPOS:one CPOS:one"
      & " >image >CPOS:one image >image image >image"

      & "|answers in order: new a b c image c=ACRJ > b= a=AACK a=ACER >AACK "
      & ">ACRJ >image"

      & "|the newest image wins: new image image MSSG:one ATIM MSSG:two >ATIM "
      & ">MSSG:one >MSSG:two ATIM >ATIM >image > image stop >"

      --  however long unsolicited messages have waited for a slow monitor
      & "|rule 7, the hold of each command: new a b RBLV:2 image hold=950 "
      & "+949 > +1 free a=AACK b=ACRJ >AACK >RBLV:2 >ACRJ >image "
      & "new a RBLV:2 image held a=AACK >AACK >RBLV:2 +500 b hold=950 +450 > "
      & "+500 >image b=AACK >AACK"

      & "|the gap and the turns: new CPOS:one image gap=0 0>image gap=20 "
      & "image CPOS:two 19> >CPOS:two a a=AACK gap=4 3> 4>AACK gap=20 19> "
      & ">image gap=0 >"

      --  the end drops progress, and images do not drop the end; it is held
      --  back by the command that ends the mission
      & "|progress and end: new a a=AACK >AACK a/MPRG:1;2;300 a/MPRG:1;2;200 "
      & "RBLV:2 >MPRG:1;2;200 >RBLV:2 > "
      & "a/MPRG:2;2;100 a/MEND:done a/MPRG:2;2;90 CPOS:one image stop image "
      & ">MEND:done >image > "
      & "b a/MEND:aborted held > b=AACK >AACK gap=20 >MEND:aborted >"

      & "|a mission of another session: new a a=AACK a/MPRG:1;1;300 "
      & "a/MEND:done closed a/MEND:done reopened a/MPRG:1;1;300 a/MEND:done > "
      & "b b=AACK b/MEND:done a/MEND:aborted >AACK >MEND:done");
   Run_Test ("an answer that is an image", Test_Arena'Access);
   Run_Test ("commands without end hold no longer", Test_Hold_Of_All'Access);
   Run_Test ("room for 256", Test_Full'Access);
end Mailboxes_Tests;
