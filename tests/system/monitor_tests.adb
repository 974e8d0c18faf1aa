--  SPDX-License-Identifier: GPL-3.0-or-later
--  F4 to F6: service and loss of the monitor.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Dialogues;             use Dialogues;
with Emulators;
with Expectations;          use Expectations;
with Images;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Network_Links;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;

procedure Monitor_Tests is

   type Natural_Array is array (Positive range <>) of Natural;

   Lost_And_Back : constant String :=
     "stops, log monitor lost, over, tell silent off, status moving 0,"
     & " connect, initial, ROPN AACK, RSOW AACK, RGFW AACK, RSTP AACK";
   --  Stop on the wire, session closed, new monitor admitted, initial state,
   --  all works again

   procedure Answers_Are_Prompt is
      --  F4: 10 ms. Here only the order of magnitude with images and positions
      --  streaming; the benchmark has the figures.
      Count : constant := 100;
      R     : Rig;
      Taken : Samples.Set;
      Start : Instant;
      Item  : Message;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R, Positions => True);
      for Number in 1 .. Count loop
         R.Monitor.Skip_To_Now;
         Start := Now;
         R.Monitor.Send_Line ("what");
         Item := R.Monitor.Next_Answer;
         Check (Item.Label = "ACER", "not the answer: " & Item.Label);
         Taken.Add (Item.Time - Start);
         delay 0.023;
      end loop;
      Note ("median " & Milliseconds (Taken.Quantile (0.5)));
      Check_Within (Taken.Quantile (0.5), 0.01, "the median answer");
      Check_Within (Taken.Usual_Worst (20), 0.1, "the slowest of 20");
   end Answers_Are_Prompt;

   procedure Answers_In_Order is
      --  Rule 1: quick answers wait for the slow ones before them
      R : Rig;
   begin
      Assemble (R);
      Play (R, "ROPN AACK, tell delay 45");
      R.Monitor.Skip_To_Now;
      R.Monitor.Send
        ("RPIN" & ASCII.LF & "what" & ASCII.LF & "RGBT" & ASCII.LF
         & "CPCO" & ASCII.LF & "RGST" & ASCII.LF & "MSSG:hello" & ASCII.LF
         & "CCLS" & ASCII.LF & "RSOW" & ASCII.LF & "CASA" & ASCII.LF
         & "RCLS" & ASCII.LF & "RPIN" & ASCII.LF);
      for Label of Words ("AACK ACER RBLV ANAK RCST AACK AACK ANAK AACK ANAK")
      loop
         Check_Label (R.Monitor.Next, Label, "an answer");
      end loop;
      R.Monitor.Expect_Silence ("AACK ANAK ACER ATIM", 0.3);
   end Answers_In_Order;

   procedure Answers_Held_Apart is
      --  Rule 7: unsolicited messages are held back while a command waits for
      --  its answer, 950 ms at most.
      In_Flight : constant Duration := 0.01;
      --  message in transit when the command came
      Trials    : constant := 25;

      R    : Rig;
      Item : Message;

      procedure Take_Next is
         --  Other messages, but no answer other than AACK
      begin
         Item := R.Monitor.Next;
         Check (Item.Label not in "    " | "ATIM" | "ANAK" | "ACRJ" | "ACER",
                "RPIN was answered " & Item.Label);
      end Take_Next;

      procedure Measure_Answers is
         Start   : Instant;
         Between : Natural := 0;
      begin
         for Trial in 1 .. Trials loop
            R.Monitor.Skip_To_Now;
            Start := Now;
            R.Monitor.Send_Line ("RPIN");
            loop
               Take_Next;
               exit when Item.Label = "AACK";
               if Item.Time - Start > In_Flight then
                  Between := Between + 1;
               end if;
            end loop;
            delay 0.037;
         end loop;
         Note (Between'Image & " of" & Trials'Image
               & " answers had a message before them");
         Check_In_Time (Between <= Trials / 8,
                        Between'Image & " unasked messages before an answer");
      end Measure_Answers;

      function Longest_Wait return Duration is
         --  Commands of 60 ms each, for 2 s and more: images are still sent in
         --  between
         Count   : constant := 35;
         Longest : Duration := 0.0;
         Last    : Instant;
      begin
         R.Monitor.Skip_To_Now;
         Last := Now;
         for Number in 1 .. Count loop
            R.Monitor.Send_Line ("RPIN");
         end loop;
         for Number in 1 .. Count loop
            loop
               Take_Next;
               if Item.Label = "CIMG" then
                  Longest := Duration'Max (Longest, Item.Time - Last);
                  Last := Item.Time;
               end if;
               exit when Item.Label = "AACK";
            end loop;
         end loop;
         return Duration'Max (Longest, Now - Last);
      end Longest_Wait;

      Waits : Samples.Set;

   begin
      Assemble (R, Camera => True);
      R.Monitor.Expect ("ROPN", "AACK");
      Open_Camera (R, Positions => True);
      R.Emulator.Tell ("delay 60");
      Measure_Answers;
      for Turn in 1 .. 3 loop
         Waits.Add (Longest_Wait);
         Note ("longest wait for an image " & Milliseconds (Waits.Last));
      end loop;
      Check_Within (Waits.Quantile (0.5), 1.3, "images held back");
      Check (Waits.Quantile (0.5) > 0.9, "images not held back");
   end Answers_Held_Apart;

   procedure Messages_Kept_Apart is
      --  The existing monitor takes all that one recv returns as one message.
      --  A few short gaps are tolerated: a delayed reader shortens the next
      --  one
      Unasked_Gap : constant Duration := 0.018;
      Answer_Gap  : constant Duration := 0.003;
      --  20 and 4 ms, less the variation on the way to the reader

      R : Rig;

      function Is_Unasked (Item : Message) return Boolean is
        (Item.Label in "CIMG" | "CPOS" | "RBLV");
      Close    : Natural := 0;
      Unasked  : Natural := 0;
      Item     : Message;
      Previous : Message;
   begin
      Assemble (R, Camera => True);
      Start_Robot (R);
      Open_Camera (R, Positions => True);
      R.Monitor.Skip_To_Now;
      for Number in 1 .. 40 loop
         R.Monitor.Send_Line ((if Number mod 2 = 0 then "RMOV:1" else "RGST"));
         delay 0.11;
      end loop;
      loop
         Item := R.Monitor.Next (Within => 0.0);
         exit when Item.Number = 0;
         if Is_Unasked (Item) then
            Unasked := Unasked + 1;
         end if;
         if Previous.Number > 0 and then
             ((Is_Unasked (Item)
               and then Item.Time - Previous.Time < Unasked_Gap)
              or else
                (not Is_Unasked (Item) and then Is_Unasked (Previous)
                 and then Item.Time - Previous.Time < Answer_Gap))
         then
            Close := Close + 1;
         end if;
         Previous := Item;
      end loop;
      Note (Close'Image & " of" & Unasked'Image
            & " unasked messages were close to another");
      Check_In_Time
        (Unasked > 60, "only" & Unasked'Image & " unasked messages");
      Check_In_Time (Close <= Unasked / 25, Close'Image & " messages close");
   end Messages_Kept_Apart;

   procedure Late_Reader is
      --  Like the existing monitor on a busy machine: one recv per turn, and
      --  its result is one message. 5 to 15 ms of delay for each message; or,
      --  with commands in between, the same time after each message: a delay
      --  for each would merge an answer with the image 4 ms before
      Least      : constant Duration := 0.005;
      Most       : constant Duration := 0.015;
      Tolerance  : constant Duration := 0.001;
      In_Flight  : constant Duration := 0.03;
      --  in transit to the reader when the command was sent
      Hold_Limit : constant Duration := 0.95;
      R          : Rig;

      procedure Open_Slowly (Taking : Positive) is
         --  Time that a camera takes to open, ms
         Start   : Instant;
         Item    : Message;
         Between : Natural := 0;
      begin
         R.Emulator.Tell ("camera opening" & Taking'Image);
         R.Monitor.Skip_To_Now;
         Start := Now;
         R.Monitor.Send_Line ("COPN");
         loop
            Item := R.Monitor.Next;
            exit when Item.Label = "AACK";
            Check (Item.Label = "RBLV", Item.Label & " instead of AACK");
            if Item.Time - Start > In_Flight then
               Between := Between + 1;
            end if;
         end loop;
         Note ("camera open after " & Milliseconds (Item.Time - Start));
         Check_In_Time (Between = 0 or else Item.Time - Start > Hold_Limit,
                        Between'Image & " levels before the camera's answer");
         R.Monitor.Expect ("CCLS", "AACK");
         delay 0.1;
         --  commands in a row, without such a gap between them, hold a level
         --  back together
      end Open_Slowly;

      procedure Measure (With_Commands : Boolean) is
         All_Sent : Natural := 0;
         Lost     : Natural := 0;
         Excused  : Natural := 0;
         First    : Positive;
         Last     : Natural;
         Number   : Positive;
         Size     : Positive;
      begin
         R.Monitor.Skip_To_Now;
         First := R.Monitor.Count + 1;
         for Count in 1 .. 50 loop
            if With_Commands then
               R.Monitor.Expect
                 ((if Count mod 3 = 0 then "RPIN"
                   elsif Count mod 3 = 1 then "RMOV:1" else "CPCO"),
                  "AACK");
            end if;
            delay 0.2 + 0.007 * (Count mod 10);
         end loop;
         Last := R.Monitor.Count;
         Number := First;
         while Number <= Last loop
            Size := 1;
            while Number + Size <= Last
              and then R.Monitor.Element (Number + Size).Group
                       = R.Monitor.Element (Number).Group
            loop
               Size := Size + 1;
            end loop;
            All_Sent := All_Sent + Size;
            if Size = 1 then
               null;
            elsif R.Monitor.Element (Number).Late <= Most + Tolerance then
               Lost := Lost + Size;
            else
               Excused := Excused + Size;
            end if;
            Number := Number + Size;
         end loop;
         Note (Lost'Image & " of" & All_Sent'Image & " messages lost, and"
               & Excused'Image & " because the reader was too late");
         Check_In_Time (All_Sent - Excused > 200, "too few messages to judge");
         Check_In_Time (Lost * 200 <= All_Sent, Lost'Image & " messages lost");
      end Measure;

   begin
      Assemble (R, Camera => True);
      Start_Robot (R);
      R.Monitor.Be_Late (Least, Most, To_Each => True);
      for Taking of Natural_Array'(300, 500, 700, 900) loop
         Open_Slowly (Taking);
      end loop;
      R.Emulator.Tell ("camera opening 0");
      Open_Camera (R, Positions => True);
      for With_Commands in Boolean loop
         R.Monitor.Be_Late (Least, Most, To_Each => not With_Commands);
         Measure (With_Commands);
      end loop;
   end Late_Reader;

   procedure No_Gap_On_Request is
      R     : Rig;
      Image : Message;
      Gaps  : Samples.Set;
   begin
      Assemble (R, Camera => True, Supervisor_Options => "--message-gap 0");
      Open_Camera (R, Positions => True);
      R.Monitor.Skip_To_Now;
      for Number in 1 .. 15 loop
         Image := R.Monitor.Next_Of ("CIMG");
         Gaps.Add (R.Monitor.Next_Of ("CPOS").Time - Image.Time);
      end loop;
      Check_Within (Gaps.Quantile (0.5), 0.003, "the median gap");
   end No_Gap_On_Request;

   procedure Slow_Monitor is
      Buffers : constant := 20;
      --  images
      R     : Rig;
      Item  : Message;
      Old   : Natural := 0;
      Found : Boolean;
      X, Y  : Float;
      Truth : Emulators.Truth;
   begin
      Assemble (R, Camera => True, Connected => False);
      R.Monitor.Connect (R.Supervisor.Port, Receive_Buffer => 16_384);
      R.Monitor.Keep_Images (100);
      R.Emulator.Tell ("pose 20 30 0");
      Open_Camera (R);

      --  Nothing is read for 3.5 s, that is 35 images; then at most the two
      --  buffers are in transit, no backlog: soon the robot is shown where it
      --  has been for a second
      R.Monitor.Pause;
      R.Monitor.Send_Line ("what");
      delay 2.5;
      R.Emulator.Tell ("pose 60 30 0");
      delay 1.0;
      Truth := R.Emulator.Pose;
      R.Monitor.Skip_To_Now;
      R.Monitor.Resume;
      Item := R.Monitor.Next_Answer;
      Check (Item.Label = "ACER", "the answer was lost");
      loop
         Item := R.Monitor.Next_Of ("CIMG");
         Images.Find_Marker (R.Monitor.Image (Item.Number), Found, X, Y);
         exit when Found and then abs (X - Truth.Cx) < 5.0
           and then abs (Y - Truth.Cy) < 5.0;
         Old := Old + 1;
         Check (Old <= Buffers, "old images were kept for the monitor");
      end loop;
      Note (Old'Image & " old images after a stall");

      --  Slow, about a third of the rate of the images: answers come, in their
      --  order
      R.Monitor.Limit_Reading (100_000);
      R.Monitor.Await ("CIMG", Count => 3);
      for Number in 1 .. 3 loop
         R.Monitor.Expect ("what", "ACER");
         R.Monitor.Await ("CIMG");
      end loop;
      R.Monitor.Limit_Reading (0);
      R.Monitor.Expect ("CCLS", "AACK");
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Slow_Monitor;

   procedure Lost_With_Orders is
      --  They do not follow the stop
      R : Rig;
   begin
      Assemble (R);
      Play (R, Forward & ", tell delay 50");
      for Number in 1 .. 50 loop
         R.Monitor.Send_Line ("RMOV:500");
      end loop;
      Play (R, "seen M=500, reset, " & Lost_And_Back);
      declare
         Wire : constant String := R.Emulator.Wire_Text;
         Stop : constant Natural := Index (Wire, "M=0 ");
         Next : constant Natural := Index (Wire, "M=32767 ");
      begin
         Check (Next > Stop and then Index (Wire (Stop .. Next), "M=500") = 0,
                "an order after the stop: " & Wire);
      end;
   end Lost_With_Orders;

   procedure Telnet_Commands is
      --  Those of a Ctrl-C before a stop must not make it unknown; here also
      --  before the first line of all
      Ctrl_C : constant String :=
        Character'Val (16#FF#) & Character'Val (16#F4#)
        & Character'Val (16#FF#) & Character'Val (16#FD#) & ASCII.ACK;
      R      : Rig;
   begin
      Assemble (R);
      R.Monitor.Send (Ctrl_C);
      Move_Forward (R);
      R.Monitor.Send (Ctrl_C);
      R.Monitor.Expect ("RSTP", "AACK");
      R.Emulator.Await_Status ("moving", "0");
      --  a synch: its last byte is urgent
      R.Monitor.Send ((1 => Character'Val (16#FF#)));
      R.Monitor.Send_Urgent (Character'Val (16#F2#));
      R.Monitor.Expect ("RSTP", "AACK");
      R.Monitor.Send_Line ("RPIN" & Ctrl_C);
      Check_Label (R.Monitor.Next_Answer, "AACK", "a command before it");
      R.Monitor.Send_Line ("RG" & Ctrl_C & "FW");
      Check_Label (R.Monitor.Next_Answer, "ACER", "a command around it");
   end Telnet_Commands;

   procedure Lost_With_Everything_On is
      --  F6: exactly as at start-up: no arena, no positions, no images
      R    : Rig;
      Mark : Natural;
   begin
      Assemble (R, Camera => True);
      Play (R, "ROPN AACK, RSWW AACK, " & With_Positions & ", CASA CIMG,"
            & " send CACO, comes CPOS, RGLF AACK, clear, reset, stops,"
            & " log monitor lost, over, status viewers 0, connect, initial");
      R.Emulator.Clear_Journal;
      Mark := R.Monitor.Count;
      Open_Camera (R);
      R.Monitor.Await ("CIMG", Count => 5);
      Check (Images.Seen (R.Monitor.Last_Image).Coloured < Images.Drawn,
             "something is drawn in the new session's images");
      for Number in Mark + 1 .. R.Monitor.Count loop
         Check (R.Monitor.Element (Number).Label not in "CPOS" | "RBLV",
                "unasked " & R.Monitor.Element (Number).Label);
      end loop;
      Play (R, "unused");
   end Lost_With_Everything_On;

   Vanish_Limit : constant Duration := 5.5;
   --  F5: 5 s, and half a second for this machine

   function Short_Info return String is
     (Programs.Preload ("libshort_info.so"));
   --  Launches with a kernel that gives no more than 4 bytes of TCP_INFO

   procedure Expect_Vanished
     (R : in out Rig; Since : Instant; Talking : Boolean := False)
   is
      --  Talking: the monitor does not know, and goes on saying something
      Ends : constant Instant := Since + Patience;
   begin
      while Talking
        and then not R.Supervisor.Says ("monitor lost")
        and then Now < Ends
      loop
         R.Monitor.Send_Line ("MSSG:still here");
         delay 0.1;
      end loop;
      R.Supervisor.Expect_Log ("monitor lost");
      Check
        (not R.Supervisor.Says ("it has taken nothing"), "taken for stalled");
      Check_Within
        (R.Supervisor.Time_Of ("monitor lost") - Since, Vanish_Limit,
         "finding the loss");
   end Expect_Vanished;

   procedure Expect_New_Session (R : in out Rig) is
      --  Of the next monitor, without a message from the one before
   begin
      R.Supervisor.Expect_Log ("session closed");
      Connect (R);
      Expect_Initial_State (R);
   end Expect_New_Session;

   procedure Expect_Stop_After_Loss (R : in out Rig) is
      Stop : constant Emulators.Note := R.Emulator.Await_On_Wire ("M=0");
   begin
      Check_Within (Stop.First - R.Supervisor.Time_Of ("monitor lost"),
                    0.5, "the stop");
   end Expect_Stop_After_Loss;

   procedure Add_Cut
     (Name      : String;
      Streaming : Boolean := False;
      How       : Network_Links.Cut_Kind := Network_Links.Cable_Pulled;
      Talking   : Boolean := False;
      Short     : Boolean := False)
   is

      procedure Run is
         Link : Network_Links.Link;
         R    : Rig;
         Time : Instant;
      begin
         Link.Make;
         Assemble (R, Camera => Streaming, Bind => "0.0.0.0",
                   Launcher => (if Short then Short_Info else ""));
         R.Monitor.Connect (R.Supervisor.Port, Network_Links.Supervisor_Side,
                            Namespace => Link.Namespace);
         if Streaming then
            Open_Camera (R);
         end if;
         Move_Forward (R);
         delay 1.0;
         Time := Now;
         Link.Cut (How);
         Expect_Vanished (R, Time, Talking);
         Expect_Stop_After_Loss (R);
         Expect_New_Session (R);
      end Run;

   begin
      Add (Name, Run'Access, In_Time => True);
   end Add_Cut;

   procedure Present_With_Short_Info is
      --  Idle, then with images, for longer than a vanished one has; then
      --  it leaves
      R : Rig;
   begin
      Assemble (R, Camera => True, Launcher => Short_Info);
      R.Supervisor.Expect_Log ("no TCP_INFO");
      delay 5.5;
      Open_Camera (R);
      delay 5.5;
      R.Monitor.Expect ("what", "ACER");
      Check (not R.Supervisor.Says ("monitor lost"), "present, yet lost");
      R.Monitor.Close;
      --  closed, or reset if an image was in transit
      R.Supervisor.Expect_Log ("monitor lost: connection");
      Expect_New_Session (R);
   end Present_With_Short_Info;

   procedure Vanished_Before_A_Message is
      --  The first message to it, when the camera is open, ends the kernel's
      --  keep-alive 3 s after the cut
      Link : Network_Links.Link;
      R    : Rig;
      Time : Instant;
   begin
      Link.Make;
      Assemble (R, Camera => True, Bind => "0.0.0.0",
                Supervisor_Options => "--log-level debug");
      R.Emulator.Tell ("camera opening 3000");
      R.Monitor.Connect (R.Supervisor.Port, Network_Links.Supervisor_Side,
                         Namespace => Link.Namespace);
      R.Monitor.Send_Line ("COPN");
      R.Supervisor.Expect_Log ("received COPN");
      Time := Now;
      Link.Cut;
      Expect_Vanished (R, Time);
      Expect_New_Session (R);
   end Vanished_Before_A_Message;

   Silence_Limit : constant Duration := 1.0;
   --  From the last sign of life to the stop

   procedure Announced_And_Silent is
      --  A monitor that says nothing, and one that has announced signs of life
      Plain     : Rig;
      Announced : Rig;
      Last      : Instant;
      Stop      : Emulators.Note;
   begin
      Assemble (Plain);
      Move_Forward (Plain);
      Assemble (Announced);
      if Announced.Supervisor.Says ("no TCP_INFO") then
         Skip ("this kernel does not tell when data came");
      end if;
      Move_Forward (Announced);
      Last := Now;
      Announced.Monitor.Send_Line ("LIVE");
      Stop := Announced.Emulator.Await_On_Wire ("M=0");
      Check_Within (Stop.First - Last, Silence_Limit, "the stop");
      Announced.Supervisor.Expect_Log
        ("monitor lost: its program has been silent for longer");
      Expect_New_Session (Announced);

      --  what one has announced, another does not owe
      Announced.Monitor.Expect ("RPIN", "ANAK");
      delay 2.0;
      Check (Announced.Supervisor.Count_Of ("monitor lost") = 1,
             "the next monitor was given up");
      Check (not Plain.Supervisor.Says ("monitor lost")
             and then Plain.Emulator.Status ("moving") = "1",
             "a monitor that has announced nothing was given up");
   end Announced_And_Silent;

   procedure Silent_For_Too_Long is
      --  It announces nothing, but the supervisor is told what to allow
      R    : Rig;
      Last : Instant;
      Stop : Emulators.Note;
   begin
      Assemble (R, Supervisor_Options => "--monitor-silence 2");
      if R.Supervisor.Says ("no TCP_INFO") then
         Skip ("this kernel does not tell when data came");
      end if;
      Move_Forward (R);
      for I in 1 .. 4 loop
         delay 1.0;
         R.Monitor.Expect ("what", "ACER");
      end loop;
      Last := Now;
      Check
        (R.Emulator.Status ("moving") = "1", "one that speaks is given up");
      Stop := R.Emulator.Await_On_Wire ("M=0");
      Check (Stop.First - Last >= 1.9, "too soon");
      R.Supervisor.Expect_Log
        ("monitor lost: its program has been silent for longer");
      Expect_New_Session (R);
   end Silent_For_Too_Long;

   procedure Start_Console (R : in out Rig; Tool : in out Child) is
      --  The project's own monitor, which drives
   begin
      Assemble (R, Connected => False);
      if R.Supervisor.Says ("no TCP_INFO") then
         Skip ("this kernel does not tell when data came");
      end if;
      Tool.Start
        (Programs.Monitor,
         Words ("--script - --port" & Positive'Image (R.Supervisor.Port)),
         "console monitor");
      for Line of Words ("ROPN RSOW RGFW") loop
         Tool.Put_Line (Line);
      end loop;
      R.Emulator.Await_Status ("moving", "1");
   end Start_Console;

   procedure Console_Frozen is
      R    : Rig;
      Tool : Child;
      Time : Instant;
   begin
      Start_Console (R, Tool);
      Time := Now;
      Tool.Send_Signal (Libc.Sigstop);
      R.Emulator.Await_Status ("moving", "0");
      Check_Within (Now - Time, Silence_Limit, "the stop");
      R.Supervisor.Expect_Log ("monitor lost: its program has been silent");
      Expect_New_Session (R);
   end Console_Frozen;

   procedure Announced_In_Time is
      --  As long as they live they are kept: a console that waits, and who
      --  says a line each 500 ms, of whatever kind
      Console, R : Rig;
      Tool       : Child;
   begin
      Announced_And_Silent;
      Console_Frozen;
      Start_Console (Console, Tool);
      Assemble (R);
      Move_Forward (R);
      for Number in 1 .. 4 loop
         for Line of Words ("LIVE MSSG:here RGST") loop
            R.Monitor.Send_Line (Line);
            delay 0.5;
         end loop;
      end loop;
      Check_In_Time (not R.Supervisor.Says ("monitor lost")
                     and then not Console.Supervisor.Says ("monitor lost"),
                     "a living monitor was given up");
   end Announced_In_Time;

   procedure Stalled is
      --  Two at once: one reads again after 10 s, the other never does
      Patient, Dead : Rig;
      Time          : Instant;
      Lost          : Duration;
   begin
      Assemble (Patient, Camera => True);
      Assemble (Dead, Camera => True);
      Open_Camera (Patient);
      Open_Camera (Dead);
      Move_Forward (Dead);
      Patient.Monitor.Pause;
      Dead.Monitor.Pause;
      Time := Now;
      delay 10.0;
      Check (not Patient.Supervisor.Says ("monitor lost")
             and then not Dead.Supervisor.Says ("monitor lost"),
             "a monitor that reads nothing for 10 s counts as lost");
      Patient.Monitor.Resume;
      Patient.Monitor.Expect ("what", "ACER");
      Dead.Supervisor.Expect_Log ("monitor lost");
      Lost := Dead.Supervisor.Time_Of ("monitor lost") - Time;
      Note ("lost after " & Milliseconds (Lost));
      Check_In_Time (Lost > 14.0 and then Lost < 18.0,
                     "15 s without reading were " & Milliseconds (Lost));
      Expect_Stop_After_Loss (Dead);
      Expect_New_Session (Dead);
      Check (not Patient.Supervisor.Says ("monitor lost"),
             "the patient monitor was given up");
      Patient.Monitor.Expect ("CCLS", "AACK");
   end Stalled;

   procedure None_Is_Forgotten is
      --  Of those who come while a session is being ended one is in command
      --  then; the others, also those for whom there was no place, are told
      R        : Rig;
      Crowd    : array (1 .. 20) of Client;
      Admitted : Natural := 0;
   begin
      Assemble (R);
      Start_Robot (R);
      R.Emulator.Tell ("silent on");
      --  so its end takes a while
      R.Monitor.Close;
      for Visitor of Crowd loop
         Visitor.Connect (R.Supervisor.Port);
         Visitor.Send_Line ("RPIN");
      end loop;
      for Visitor of Crowd loop
         if Visitor.Next.Label = "ANAK" then
            Admitted := Admitted + 1;
         end if;
      end loop;
      Check (Admitted = 1, Admitted'Image & " admitted");
   end None_Is_Forgotten;

   procedure Second_Is_Refused is
      R      : Rig;
      Second : Client;
      Item   : Message;
   begin
      Assemble (R);
      Start_Robot (R);
      for Attempt in 1 .. 5 loop
         Second.Connect (R.Supervisor.Port);
         Item := Second.Next;
         Check (Item.Label = "MSSG" and then Length (Item.Data) > 0,
                "the second monitor is told " & Item.Label);
         Check (Second.Closed_By_Peer /= Open,
                "the second monitor is not closed");
         Second.Close;
         R.Monitor.Expect ("RPIN", "AACK");
      end loop;

      --  Many at once
      declare
         Crowd : array (1 .. 12) of Client;
      begin
         for Visitor of Crowd loop
            Visitor.Connect (R.Supervisor.Port);
         end loop;
         R.Monitor.Expect ("RPIN", "AACK");
         for Visitor of Crowd loop
            Check (Visitor.Closed_By_Peer /= Open
                   and then Visitor.Count_Of ("MSSG") = 1,
                   "one of many is not told and closed");
         end loop;
      end;

      --  One that sends commands at once is not in command
      R.Emulator.Clear_Journal;
      Second.Connect (R.Supervisor.Port);
      if Second.Try_Send ("RGFW" & ASCII.LF) then
         null;  --  it may have been closed before
      end if;
      Check (Second.Closed_By_Peer /= Open
             and then Second.Count = Second.Count_Of ("MSSG"),
             "the second monitor is answered");
      R.Monitor.Expect ("RGST", "RCST:0");
      Check (R.Emulator.Wire_Text = "",
             "the second monitor commands the robot");
   end Second_Is_Refused;

   procedure Lines_In_Pieces is
      --  TCP is a stream: a command may arrive byte by byte
      R    : Rig;
      Text : constant String := "ROPN" & ASCII.LF & "RSOW" & ASCII.LF
        & "RTRN:-12" & ASCII.CR & ASCII.LF & "what" & ASCII.LF;
   begin
      Assemble (R);
      for Piece of Text loop
         R.Monitor.Send ((1 => Piece));
         delay 0.005;
      end loop;
      for Number in 1 .. 3 loop
         Check_Label (R.Monitor.Next_Answer, "AACK", "an answer");
      end loop;
      Check (R.Monitor.Next_Answer.Label = "ACER", "no ACER");
      Check (R.Emulator.Count_Of ("T=-12") = 1, "no T=-12 on the wire");
   end Lines_In_Pieces;

begin
   Add ("F03_Rule_1_Answers_In_Order", Answers_In_Order'Access);
   Add ("F03_Lines_In_Pieces", Lines_In_Pieces'Access);
   Script ("F03_Line_Ends_Tolerated",
           "ROPN" & ASCII.CR & " AACK, RSOW" & ASCII.CR & " AACK, RMOV:5"
           & ASCII.CR & " AACK, RPIN: AACK, RPIN:" & ASCII.CR
           & " AACK, sent M=5 1");
   --  The existing monitor appends a separator to every label
   Add ("F03_Telnet_Commands_Skipped", Telnet_Commands'Access);
   Script ("F03_Log_Message_Unanswered",
           "send MSSG:the user says hello, send MSSG, send CACO, send CAIN,"
           & " silence 0.3 AACK ANAK ACRJ ATIM, RPIN ANAK");
   Add ("F04_Answers_Are_Prompt", Answers_Are_Prompt'Access, Timed => True);
   Add ("F04_Messages_Kept_Apart", Messages_Kept_Apart'Access, Timed => True);
   Add ("F04_Reader_As_The_Existing_Monitor",
        Late_Reader'Access, Timed => True);
   Add ("F04_No_Gap_On_Request", No_Gap_On_Request'Access, Timed => True);
   Add ("F04_Rule_7_Answers_Held_Apart",
        Answers_Held_Apart'Access, Timed => True);
   Add ("F04_F15_Slow_Monitor", Slow_Monitor'Access);
   Script ("F05_F06_Monitor_Lost_Orderly",
           Forward & ", close, " & Lost_And_Back, In_Time => True);
   Script ("F05_F06_Monitor_Lost_By_Reset",
           Forward & ", reset, " & Lost_And_Back, In_Time => True);
   Script ("F05_F06_Monitor_Lost_By_Half_Close",
           Forward & ", half-close, closed, " & Lost_And_Back,
           In_Time => True);
   --  one that has stopped sending is not in command
   Script ("F05_F06_Monitor_Lost_With_Half_A_Line",
           Forward & ", part RGB, close, " & Lost_And_Back
           & ", part RMOV:12, close, over, connect, RPIN ANAK",
           In_Time => True);
   --  it is not the beginning of the next monitor's first
   Add ("F06_Monitor_Lost_With_Orders_Waiting",
        Lost_With_Orders'Access, In_Time => True);
   Script ("F06_Monitor_Lost_While_Robot_Is_Silent",
           Forward & ", tell silent on, close, " & Lost_And_Back,
           In_Time => True);
   Add ("F06_Monitor_Lost_With_Everything_On",
        Lost_With_Everything_On'Access, In_Time => True);
   Add_Cut ("F05_Monitor_Vanished_While_Idle");
   Add_Cut ("F05_Monitor_Vanished_While_Streaming", Streaming => True);
   Add ("F05_Monitor_Present_Without_Tcp_Info",
        Present_With_Short_Info'Access);
   Add_Cut ("F05_Monitor_Vanished_Idle_Without_Tcp_Info", Short => True);
   Add_Cut ("F05_Monitor_Vanished_Streaming_Without_Tcp_Info",
            Streaming => True, Short => True);
   Add ("F05_Monitor_Vanished_Before_A_Message",
        Vanished_Before_A_Message'Access, In_Time => True);
   Add_Cut ("F05_Monitor_Machine_Fallen_Silent", Streaming => True,
            How => Network_Links.Monitor_Gone);
   Add_Cut ("F05_Own_Interface_Down", How => Network_Links.Interface_Down);
   Add_Cut ("F05_Own_Address_Gone", Streaming => True,
            How => Network_Links.Address_Gone);
   Add_Cut ("F05_Own_Route_Gone", How => Network_Links.Route_Gone,
            Talking => True);
   Add_Cut ("F05_Cut_To_Monitor", How => Network_Links.Dropped_There,
            Talking => True);
   Add_Cut ("F05_Cut_From_Monitor", Streaming => True,
            How => Network_Links.Dropped_Here, Talking => True);
   Add ("F05_Monitor_Stalled", Stalled'Access, Timed => True);
   Add ("Never_Moves_On_For_A_Silent_Monitor", Announced_And_Silent'Access);
   Add ("Never_Moves_On_Beyond_Monitor_Silence", Silent_For_Too_Long'Access);
   Add ("Never_Moves_On_For_A_Frozen_Console", Console_Frozen'Access);
   Add ("Never_Moves_On_For_Long", Announced_In_Time'Access, Timed => True);
   Add ("F02_None_Is_Forgotten", None_Is_Forgotten'Access);
   Add ("F02_Second_Monitor_Is_Refused", Second_Is_Refused'Access);
end Monitor_Tests;
