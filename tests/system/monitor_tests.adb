--  SPDX-License-Identifier: GPL-3.0-or-later
--  F4 to F6: service and loss of the monitor.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
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
with Supervisors;

procedure Monitor_Tests is

   Lost_And_Back : constant String :=
     ", stops, log monitor lost, over, tell silent off, status moving 0,"
     & " connect, " & Initial & ", " & Started & ", RGFW AACK, RSTP AACK";
   --  Stop on the wire, session closed, new monitor admitted, initial state,
   --  all works again

   procedure Answers_Are_Prompt (R : in out Rig) is
      --  F4: 10 ms. Here only the order of magnitude with images and positions
      --  streaming; the benchmark has the figures.
      Taken : Samples.Set;
      Start : Instant;
      Item  : Message;
   begin
      for Number in 1 .. 100 loop
         Start := Now;
         Item := R.Monitor.Ask ("what");
         Check_Label (Item, "ACER", "what");
         Taken.Add (Item.Time - Start);
         delay 0.023;
      end loop;
      Note ("median " & Milliseconds (Taken.Quantile (0.5)));
      Check_Within (Taken.Quantile (0.5), 0.01, "the median answer");
      Check_Within (Taken.Usual_Worst (20), 0.1, "the slowest of 20");
   end Answers_Are_Prompt;

   procedure Answers_Held_Apart (R : in out Rig) is
      --  Rule 7: unsolicited messages are held back while a command waits for
      --  its answer, 950 ms at most.
      In_Flight : constant Duration := 0.01;
      --  message in transit when the command came
      Trials    : constant := 25;

      Item    : Message;
      Start   : Instant;
      Between : Natural := 0;
      Waits   : Samples.Set;

      procedure Take_Next is
         --  Other messages, but no answer other than AACK
      begin
         Item := R.Monitor.Next;
         Check (Item.Label not in "    " | "ATIM" | "ANAK" | "ACRJ" | "ACER",
                "RPIN was answered " & Item.Label);
      end Take_Next;

      function Longest_Wait return Duration is
         --  Commands of 60 ms each, for 2 s and more: images are still sent in
         --  between
         Count   : constant := 35;
         Longest : Duration := 0.0;
         Last    : Instant := Now;
      begin
         R.Monitor.Skip_To_Now;
         R.Monitor.Send (Count * ("RPIN" & ASCII.LF));
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
      for Turn in 1 .. 3 loop
         Waits.Add (Longest_Wait);
         Note ("longest wait for an image " & Milliseconds (Waits.Last));
      end loop;
      Check_Within (Waits.Quantile (0.5), 1.3, "images held back");
      Check (Waits.Quantile (0.5) > 0.9, "images not held back");
   end Answers_Held_Apart;

   procedure Late_Reader (R : in out Rig) is
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

      procedure Open_Slowly (Taking : String) is
         --  Time that a camera takes to open, ms
         Start   : Instant;
         Item    : Message;
         Between : Natural := 0;
      begin
         R.Emulator.Tell ("camera opening " & Taking);
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
         Play (R, "CCLS AACK, wait 0.1");
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
      R.Monitor.Be_Late (Least, Most, To_Each => True);
      for Taking of Words ("300 500 700 900") loop
         Open_Slowly (Taking);
      end loop;
      Play (R, "tell camera opening 0, " & With_Positions);
      for With_Commands in Boolean loop
         R.Monitor.Be_Late (Least, Most, To_Each => not With_Commands);
         Measure (With_Commands);
      end loop;
   end Late_Reader;

   procedure No_Gap_On_Request (R : in out Rig) is
      Image : Message;
      Gaps  : Samples.Set;
   begin
      R.Monitor.Skip_To_Now;
      for Number in 1 .. 15 loop
         Image := R.Monitor.Next_Of ("CIMG");
         Gaps.Add (R.Monitor.Next_Of ("CPOS").Time - Image.Time);
      end loop;
      Check_Within (Gaps.Quantile (0.5), 0.003, "the median gap");
   end No_Gap_On_Request;

   procedure Slow_Monitor (R : in out Rig) is
      Buffers : constant := 20;
      --  images
      Item  : Message;
      Old   : Natural := 0;
      Found : Boolean;
      X, Y  : Float;
      Truth : Emulators.Truth;
   begin
      R.Monitor.Connect (R.Supervisor.Port, Receive_Buffer => 16_384);

      --  Nothing is read for 3.5 s, that is 35 images; then at most the two
      --  buffers are in transit, no backlog: soon the robot is shown where it
      --  has been for a second
      Play (R, "tell pose 20 30 0, " & With_Images & ", pause, send what,"
            & " wait 2.5, tell pose 60 30 0, wait 1");
      Truth := R.Emulator.Pose;
      R.Monitor.Skip_To_Now;
      R.Monitor.Resume;
      Play (R, "answer ACER");
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
      Play (R, "comes CIMG, comes CIMG, what ACER, comes CIMG", Times => 3);
      R.Monitor.Limit_Reading (0);
      R.Monitor.Expect ("CCLS", "AACK");
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Slow_Monitor;

   procedure Lost_With_Orders (R : in out Rig) is
      --  They do not follow the stop
      Wire : constant String := R.Emulator.Wire_Text;
      Stop : constant Natural := Index (Wire, "M=0 ");
      Next : constant Natural := Index (Wire, "M=32767 ");
   begin
      Check (Next > Stop and then Index (Wire (Stop .. Next), "M=500") = 0,
             "an order after the stop: " & Wire);
   end Lost_With_Orders;

   Ctrl_C : constant String :=
     Character'Val (16#FF#) & Character'Val (16#F4#)
     & Character'Val (16#FF#) & Character'Val (16#FD#) & ASCII.ACK;
   --  As telnet sends it

   procedure Telnet_Synch (R : in out Rig) is
      --  Its last byte is urgent
   begin
      R.Monitor.Send ((1 => Character'Val (16#FF#)));
      R.Monitor.Send_Urgent (Character'Val (16#F2#));
      Play (R, "RSTP AACK, send RPIN" & Ctrl_C & ", answer AACK, send RG"
            & Ctrl_C & "FW, answer ACER");
   end Telnet_Synch;

   procedure Lost_With_Everything_On (R : in out Rig) is
      --  F6: exactly as at start-up: no arena, no positions, no images
      Mark : constant Natural := R.Monitor.Count;
   begin
      Play (R, With_Images);
      R.Monitor.Await ("CIMG", Count => 5);
      Check (Images.Seen (R.Monitor.Image).Coloured < Images.Drawn,
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
         Play (R, "send MSSG:still here, wait 0.1");
      end loop;
      Play (R, "said monitor lost, unsaid it has taken nothing");
      Check_Within
        (R.Supervisor.Time_Of ("monitor lost") - Since, Vanish_Limit,
         "finding the loss");
   end Expect_Vanished;

   procedure Expect_Stop_After_Loss (R : in out Rig) is
      Stop : constant Emulators.Note := R.Emulator.Await_On_Wire ("M=0");
   begin
      Check_Within (Stop.First - R.Supervisor.Time_Of ("monitor lost"),
                    0.5, "the stop");
      Play (R, Renewed);
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
         R.Monitor.Connect (R.Supervisor.Port, By_Link => True);
         Play (R, (if Streaming then With_Images & ", " else "")
               & Forward & ", wait 1");
         Time := Now;
         Network_Links.Cut (How);
         Expect_Vanished (R, Time, Talking);
         Expect_Stop_After_Loss (R);
      end Run;

   begin
      Add (Name, Run'Access, In_Time => True);
   end Add_Cut;

   procedure Present_With_Short_Info is
      --  Idle, then with images, for longer than a vanished one has; then it
      --  leaves: closed, or reset if an image was in transit
      R : Rig;
   begin
      Assemble (R, Camera => True, Launcher => Short_Info);
      Play (R, "said no TCP_INFO, wait 5.5, " & With_Images & ", wait 5.5,"
            & " what ACER, unsaid monitor lost, close,"
            & " log monitor lost: connection, " & Renewed);
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
      R.Monitor.Connect (R.Supervisor.Port, By_Link => True);
      Play (R, "tell camera opening 3000, send COPN, log received COPN");
      Time := Now;
      Network_Links.Cut;
      Expect_Vanished (R, Time);
      Play (R, Renewed);
   end Vanished_Before_A_Message;

   Silence_Limit : constant Duration := 1.0;
   --  From the last sign of life to the stop

   Is_Silent : constant String :=
     "monitor lost: its program has been silent for longer";

   procedure Need_Tcp_Info (R : Rig) is
   begin
      if R.Supervisor.Says ("no TCP_INFO") then
         Skip ("this kernel does not tell when data came");
      end if;
   end Need_Tcp_Info;

   procedure Announced_And_Silent is
      --  A monitor that says nothing, and one that has announced signs of life
      Plain     : Rig;
      Announced : Rig;
      Last      : Instant;
   begin
      Assemble (Plain);
      Play (Plain, Forward);
      Assemble (Announced);
      Need_Tcp_Info (Announced);
      Play (Announced, Forward);
      Last := Now;
      Announced.Monitor.Send_Line ("LIVE");
      Check_Within (Announced.Emulator.Await_On_Wire ("M=0").First - Last,
                    Silence_Limit, "the stop");
      --  what one has announced, another does not owe
      Play (Announced, "said " & Is_Silent & ", " & Renewed
            & ", RPIN ANAK, wait 2");
      Check (Announced.Supervisor.Count_Of ("monitor lost") = 1,
             "the next monitor was given up");
      Check (not Plain.Supervisor.Says ("monitor lost")
             and then Plain.Emulator.Status ("moving") = "1",
             "a monitor that has announced nothing was given up");
   end Announced_And_Silent;

   procedure Silent_For_Too_Long (R : in out Rig) is
      --  It announces nothing, but the supervisor is told what to allow
      Last : Instant;
   begin
      Need_Tcp_Info (R);
      Play (R, Forward);
      Play (R, "wait 1, what ACER", Times => 4);
      Last := Now;
      Check
        (R.Emulator.Status ("moving") = "1", "one that speaks is given up");
      Check (R.Emulator.Await_On_Wire ("M=0").First - Last >= 1.9, "too soon");
      Play (R, "said " & Is_Silent & ", " & Renewed);
   end Silent_For_Too_Long;

   procedure Start_Console (R : in out Rig; Tool : in out Child) is
      --  The project's own monitor, which drives
   begin
      Assemble (R, Connected => False);
      Need_Tcp_Info (R);
      Supervisors.Start_Monitor
        (Tool, R.Supervisor.Port, "ROPN|RSOW|RGFW");
      Play (R, "status moving 1");
   end Start_Console;

   procedure Console_Frozen is
      R    : Rig;
      Tool : Child;
      Time : Instant;
   begin
      Start_Console (R, Tool);
      Time := Now;
      Tool.Send_Signal (Libc.Sigstop);
      Play (R, "status moving 0");
      Check_Within (Now - Time, Silence_Limit, "the stop");
      Play (R, "said " & Is_Silent & ", " & Renewed);
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
      Play (R, Forward);
      Play (R, "send LIVE, wait 0.5, send MSSG:here, wait 0.5, send RGST,"
            & " wait 0.5", Times => 4);
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
      Play (Patient, With_Images);
      Play (Dead, With_Images & ", " & Forward);
      Patient.Monitor.Pause;
      Dead.Monitor.Pause;
      Time := Now;
      delay 10.0;
      Play (Dead, "unsaid monitor lost");
      Play (Patient, "unsaid monitor lost");
      Patient.Monitor.Resume;
      Play (Patient, "what ACER");
      Play (Dead, "said monitor lost");
      Lost := Dead.Supervisor.Time_Of ("monitor lost") - Time;
      Note ("lost after " & Milliseconds (Lost));
      Check_In_Time (Lost > 14.0 and then Lost < 18.0,
                     "15 s without reading were " & Milliseconds (Lost));
      Expect_Stop_After_Loss (Dead);
      Play (Patient, "unsaid monitor lost, CCLS AACK");
   end Stalled;

   procedure None_Is_Forgotten (R : in out Rig) is
      --  Of those who come while a session is being ended one is in command
      --  then; the others, also those for whom there was no place, are told
      Crowd    : array (1 .. 20) of Client;
      Admitted : Natural := 0;
   begin
      for Visitor of Crowd loop
         Visitor.Connect (R.Supervisor.Port);
         Visitor.Send_Line ("RPIN");
      end loop;
      for Visitor of Crowd loop
         Admitted := Admitted + Boolean'Pos (Visitor.Next.Label = "ANAK");
      end loop;
      Check (Admitted = 1, Admitted'Image & " admitted");
   end None_Is_Forgotten;

   procedure Second_Is_Refused (R : in out Rig) is
      Crowd  : array (1 .. 12) of Client;
      Second : Client;
      Unused : Boolean;
   begin
      for Visitor of Crowd loop
         Visitor.Connect (R.Supervisor.Port);
      end loop;
      R.Monitor.Expect ("RPIN", "AACK");
      for Visitor of Crowd loop
         Check (Visitor.Closed_By_Peer /= Open
                and then Visitor.Count = 1
                and then Visitor.Element (1).Label = "MSSG"
                and then Length (Visitor.Element (1).Data) > 0,
                "one of many is not told and closed");
      end loop;

      --  One that sends commands at once is not in command
      for Attempt in 1 .. 5 loop
         R.Emulator.Clear_Journal;
         Second.Connect (R.Supervisor.Port);
         Unused := Second.Try_Send ("RGFW" & ASCII.LF);
         --  it may have been closed before
         Check (Second.Closed_By_Peer /= Open
                and then Second.Count = Second.Count_Of ("MSSG"),
                "the second monitor is answered");
         Play (R, "RGST RCST:0, wire");
      end loop;
   end Second_Is_Refused;

   procedure Lines_In_Pieces (R : in out Rig) is
      --  TCP is a stream: a command may arrive byte by byte
   begin
      for Piece of String'("ROPN" & ASCII.LF & "RSOW" & ASCII.LF & "RTRN:-12"
                           & ASCII.CR & ASCII.LF & "what" & ASCII.LF)
      loop
         R.Monitor.Send ((1 => Piece));
         delay 0.005;
      end loop;
      Play (R, "answer AACK AACK AACK ACER, sent T=-12 1");
   end Lines_In_Pieces;

begin
   Script ("F03_Rule_1_Answers_In_Order",
           "ROPN AACK, tell delay 45, send RPIN|what|RGBT|CPCO|RGST|MSSG:hello"
           & "|CCLS|RSOW|CASA|RCLS|RPIN, answer AACK ACER RBLV ANAK RCST AACK"
           & " AACK ANAK AACK ANAK, silence 0.3 AACK ANAK ACER ATIM");
   --  Quick answers wait for the slow ones before them
   Script ("F03_Lines_In_Pieces", "", Lines_In_Pieces'Access);
   Script ("F03_Line_Ends_Tolerated",
           "ROPN" & ASCII.CR & " AACK, RSOW" & ASCII.CR & " AACK, RMOV:5"
           & ASCII.CR & " AACK, RPIN: AACK, RPIN:" & ASCII.CR
           & " AACK, sent M=5 1");
   --  The existing monitor appends a separator to every label
   Script ("F03_Telnet_Commands_Skipped",
           "part " & Ctrl_C & ", " & Forward & ", part " & Ctrl_C
           & ", RSTP AACK, status moving 0", Telnet_Synch'Access);
   --  Those of a Ctrl-C before a stop must not make it unknown; here also
   --  before the first line of all
   Script ("F03_Log_Message_Unanswered",
           "send MSSG:the user says hello|MSSG|CACO|CAIN,"
           & " silence 0.3 AACK ANAK ACRJ ATIM, RPIN ANAK");
   Script ("F04_Answers_Are_Prompt", With_Positions, Answers_Are_Prompt'Access,
           Camera => True, Timed => True);
   Script ("F04_Reader_As_The_Existing_Monitor", Started, Late_Reader'Access,
           Camera => True, Timed => True);
   Script ("F04_No_Gap_On_Request", With_Positions, No_Gap_On_Request'Access,
           Camera => True, Supervisor_Options => "--message-gap 0",
           Timed => True);
   Script ("F04_Rule_7_Answers_Held_Apart",
           "ROPN AACK, " & With_Positions & ", tell delay 60",
           Answers_Held_Apart'Access, Camera => True, Timed => True);
   Script ("F04_F15_Slow_Monitor", "", Slow_Monitor'Access, Camera => True,
           Connected => False);
   Script ("F05_F06_Monitor_Lost_Orderly",
           Forward & ", close" & Lost_And_Back, In_Time => True);
   Script ("F05_F06_Monitor_Lost_By_Reset",
           Forward & ", reset" & Lost_And_Back, In_Time => True);
   Script ("F05_F06_Monitor_Lost_By_Half_Close",
           Forward & ", half-close, closed" & Lost_And_Back,
           In_Time => True);
   --  one that has stopped sending is not in command
   Script ("F05_F06_Monitor_Lost_With_Half_A_Line",
           Forward & ", part RGB, close" & Lost_And_Back
           & ", part RMOV:12, close, over, connect, RPIN ANAK",
           In_Time => True);
   --  it is not the beginning of the next monitor's first
   Script ("F06_Monitor_Lost_With_Orders_Waiting",
           Forward & ", tell delay 50, send " & 49 * "RMOV:500|"
           & "RMOV:500, seen M=500, reset" & Lost_And_Back,
           Lost_With_Orders'Access, In_Time => True);
   Script ("F06_Monitor_Lost_While_Robot_Is_Silent",
           Forward & ", tell silent on, close" & Lost_And_Back,
           In_Time => True);
   Script ("F06_Monitor_Lost_With_Everything_On",
           Guarded & ", " & With_Positions & ", CASA CIMG, send CACO,"
           & " comes CPOS, RGLF AACK, clear, reset, stops, log monitor lost,"
           & " over, status viewers 0, connect, " & Initial & ", clear",
           Lost_With_Everything_On'Access, Camera => True, In_Time => True);
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
   Script ("Never_Moves_On_Beyond_Monitor_Silence", "",
           Silent_For_Too_Long'Access,
           Supervisor_Options => "--monitor-silence 2");
   Add ("Never_Moves_On_For_A_Frozen_Console", Console_Frozen'Access);
   Add ("Never_Moves_On_For_Long", Announced_In_Time'Access, Timed => True);
   Script ("F02_None_Is_Forgotten", Started & ", tell silent on, close",
           None_Is_Forgotten'Access);
   --  The end of the session takes a while
   Script ("F02_Second_Monitor_Is_Refused", Started,
           Second_Is_Refused'Access);
end Monitor_Tests;
