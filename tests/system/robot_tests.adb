--  SPDX-License-Identifier: GPL-3.0-or-later
--  F7 to F13: the robot, its line and its orders.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Busy_Loops;
with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Interfaces.C;          use Interfaces.C;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Plain_Numbers;         use Plain_Numbers;
with Process_Facts;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;

procedure Robot_Tests is

   procedure Open_Fails is
   begin
      for Path of Words
        ("/dev/no_such_line /dev/null " & Programs.Temporary_Folder & " "
         & Programs.Supervisor)
      loop
         declare
            R : Rig;
         begin
            Start (R, "--serial " & Path);
            Play (R, "ROPN ANAK, RPIN ANAK, RCLS AACK", Times => 2);
         end;
      end loop;
   end Open_Fails;

   procedure Line_In_Use (R : in out Rig) is
      --  Another supervisor is refused, of root too, and other programs of an
      --  ordinary user; the line is free when the first has closed it or was
      --  killed
      Second   : Supervisors.Supervisor;
      Next     : Client;
      Pid      : constant String := Image (Integer (R.Supervisor.Pid));
      Device   : constant String := R.Emulator.Device;
      In_Use   : constant String :=
        Device & ": in use by "
        & Process_Facts.File_Line ("/proc/" & Pid & "/comm")
        & " (process " & Pid & ")";
      --  its name is not destijl where it is emulated
      Deadline : Instant;
   begin
      Second.Start ("--serial " & Device);
      Second.Expect_Log ("no stop was sent on " & In_Use);
      Expect_Console ("--stop --serial " & Device, 1, In_Use);
      Check (R.Emulator.Status ("moving") = "1", "another has stopped it");
      Next.Connect (Second.Port);
      Next.Expect ("ROPN", "ANAK");
      Second.Expect_Log (In_Use);
      Expect_Console ("--check --port 0 --serial " & Device, 1, In_Use);
      Check (Status_Of
               ((if Libc.Geteuid = 0 then Programs.As_User & " " else "")
                & "cat " & Device) = 1,
             "another program reads it");
      Play (R, "RPIN AACK, RCLS AACK");
      Next.Expect ("ROPN", "AACK");
      R.Monitor.Expect ("ROPN", "ANAK");
      Second.Send_Signal (Libc.Sigkill);
      Second.Start ("--serial " & Device);
      Next.Connect (Second.Port);
      Deadline := Now + Patience;
      while Next.Ask ("ROPN").Label /= "AACK" loop
         Check (Now < Deadline, "the line stays in use");
         delay 0.2;
      end loop;
   end Line_In_Use;

   procedure Closed_Though_Nothing_Leaves (R : in out Rig) is
      --  The kernel's close waits up to 30 s for a device that hangs
      Begun : Instant := Now;
   begin
      --  ATIM: if battery requests find the robot lost before
      Check_Label (R.Monitor.Ask ("RCLS"), "AACK ATIM", "RCLS");
      Check_Within (Now - Begun, 0.5, "RCLS");
      if Programs.With_Sockets then
         R.Supervisor.Expect_Log ("its device did not take all");
         Expect_Console
           ("--stop --serial " & R.Emulator.Device, 1, "it takes nothing");
      end if;
      Play (R, "ROPN AACK, connect, RPIN ANAK, thaw, status moving 0,"
            & " ROPN AACK, freeze");
      Begun := Now;
      R.Supervisor.Expect_End;
      Check_Within (Now - Begun, 1.0, "the end");
   end Closed_Though_Nothing_Leaves;

   function Three (Spoilt : String) return String is
     (", tell drop 3, status spoilt " & Spoilt
      & ", silence 0.1 ATIM, RPIN AACK, unsaid robot lost");
   --  Answers lost; so many are since the start

   procedure Silence_Found (R : in out Rig) is
      --  Issue: a lost line is found within 1 s while the robot is started
      Time : Instant;
   begin
      R.Monitor.Skip_To_Now;
      R.Emulator.Tell ("silent on");
      Time := Now;
      Check_Within
        (R.Monitor.Next_Of ("ATIM").Time - Time, 1.5, "finding the loss");
      R.Monitor.Expect_Silence ("ATIM RBLV", For_Time => 1.0);
      Check (R.Supervisor.Count_Of ("robot lost") = 1,
             "the loss is said more than once");
      Play (R, "tell silent off, " & Works_Again);
   end Silence_Found;

   procedure Talking_From_The_Start (R : in out Rig) is
      --  Nor one that has never been in step
   begin
      --  for longer than the orders take
      Play (R, "tell unasked " & 60 * "OO\r", Times => 60);
      Play (R, "send ROPN|RSWW|RPIN|RSOW|RSWW|RPIN, log robot lost: four,"
            & " unsaid robot started", Times => 3);
   end Talking_From_The_Start;

   procedure Talking_Now_And_Then (R : in out Rig) is
      --  Nor one that does so less often than a command takes
      Byte : constant String := "tell unasked OO\r, wait ";

      procedure Talk (Period, Half : String) is
         Mark : constant Natural := R.Supervisor.Count;
      begin
         Play (R, 4 * (Byte & Period & ", ") & Byte & Half
               & ", send $, wait " & Half,
               Each => "ROPN RSWW RSWW RPIN RSOW RPIN RPIN RPIN");
         R.Supervisor.Expect_Log ("robot lost: four", Mark);
      end Talk;

   begin
      Talk ("0.06", "0.03");
      Talk ("0.1", "0.05");
      Play (R, "unsaid robot started");
   end Talking_Now_And_Then;

   function Reloads_Off (R : in out Rig) return Samples.Set is
      --  By how much each reload of the journal is off a second
   begin
      return Off : Samples.Set do
         for Item of R.Emulator.Journal loop
            if Item.Command = "w" then
               Off.Add (abs (Item.Interval - 1.0));
            end if;
         end loop;
         Note (Off.Count'Image & " reloads, the worst by "
               & Milliseconds (Off.Quantile (1.0)) & " off");
      end return;
   end Reloads_Off;

   procedure With_Watchdog (R : in out Rig) is
      --  F11: the robot takes a reload 950 to 1050 ms after the last
      Off : constant Samples.Set := Reloads_Off (R);
   begin
      Check_In_Time (Off.Count = 5, Off.Count'Image & " reloads in 5.6 s");
      Check_Within (Off.Quantile (0.5), 0.05, "what a reload is off");
   end With_Watchdog;

   procedure Watchdog_Kept (R : in out Rig) is
      --  60 s with images, positions, orders and two busy loops; memory
      --  stays flat meanwhile
      Load  : Busy_Loops.Load;
      Start : constant Instant := Now;
      Early : Process_Facts.Footprint;
   begin
      Load.Start;
      while Now - Start < 60.0 loop
         Play (R, "RGFW AACK, wait 0.047, RGLF AACK, wait 0.047, RGBT RBLV,"
               & " wait 0.047, RMOV:-20 AACK, wait 0.047, RGST RCST,"
               & " wait 0.047, RSTP AACK, wait 0.047");
         if Early.Kilobytes = 0 and then Now - Start > 15.0 then
            Early := Process_Facts.Footprint_Of (R.Supervisor.Pid);
         end if;
      end loop;
      Process_Facts.Expect_Flat (R.Supervisor.Pid, Early);
      declare
         Reloads : constant Natural := Reloads_Off (R).Count;
      begin
         Check_In_Time (Reloads >= 58, "only" & Reloads'Image & " reloads");
      end;
      --  without real-time priorities deadlines are not guaranteed, but the
      --  robot keeps running
      if R.Supervisor.Says ("real-time priorities: FIFO") then
         Play (R, "status missed_total 0");
      end if;
      Check (R.Emulator.Status ("disabled_count") = "0", "robot disabled");
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Watchdog_Kept;

   procedure Lost_Reloads (R : in out Rig) is
      --  F11: a lost reload, or its answer, costs one miss at most; two
      --  reloads in a row do not disable the robot

      procedure Lose (Fault : String; Times : Positive; Misses : Natural) is
         Before   : constant Integer :=
           R.Emulator.Status_Number ("missed_total");
         Next     : Instant;
         Interval : Duration := 1.0;
         Missed   : Integer;
         Repeated : Natural := 0;
      begin
         R.Emulator.Clear_Journal;
         Next := R.Emulator.Await_On_Wire ("w").First;
         for Attempt in 1 .. Times loop
            --  not the battery's request 50 ms before the second
            Next := Next + Interval;
            delay Duration'Max (0.0, Next - Now - 0.03);
            R.Emulator.Tell (Fault & " 1000");
            delay Duration'Max (0.0, Next - Now + 0.03);
            R.Emulator.Tell (Fault & " 0");
            Interval := 1.1;
         end loop;
         delay 2.5;
         Next := Never;
         for Item of R.Emulator.Journal loop
            if Item.Command = "w" then
               if Next /= Never and then Item.First - Next > 1.05 then
                  Repeated := Repeated + 1;
               end if;
               Next := Item.First;
            end if;
         end loop;
         Missed := R.Emulator.Status_Number ("missed_total") - Before;
         Note (Fault & Times'Image & ", repeated" & Repeated'Image
               & ", missed" & Missed'Image);
         Check_In_Time (Repeated = Times and then Missed <= Misses,
                        Fault & Times'Image & ", repeated" & Repeated'Image
                        & ", missed" & Missed'Image);
         Check (R.Emulator.Status ("disabled_count") = "0", "robot disabled");
      end Lose;

   begin
      Lose ("lose", Times => 1, Misses => 1);
      Lose ("drop", Times => 1, Misses => 1);
      Lose ("lose", Times => 2, Misses => 2);
   end Lost_Reloads;

   Says_Not_Running : constant String :=
     " comes MSSG:robot no longer runs (watchdog or reset): reset and start"
     & " again,";

   procedure Tenth_Lost (R : in out Rig) is
      --  Of all, so the levels of the battery have theirs too, and one of ten
      --  of these orders may have none for long
      Late   : Natural := 0;
      All_Of : Integer;
      Spoilt : Integer;
   begin
      for Number in 1 .. 400 loop
         exit when Number > 40 and then Late > 0;
         R.Monitor.Send_Line ("RGST");
         declare
            Label : constant String := R.Monitor.Next_Answer ("RGST").Label;
         begin
            Check (Label in "RCST" | "ATIM", Label);
            Late := Late + Boolean'Pos (Label = "ATIM");
         end;
      end loop;
      All_Of := Integer (R.Emulator.Journal.Length);
      Spoilt := R.Emulator.Status_Number ("spoilt");
      Check (Late > 0 and then Late <= Spoilt
             and then abs (Spoilt - All_Of / 10) <= 1,
             Late'Image & " and in all" & Spoilt'Image & " of" & All_Of'Image);
      Play (R, "tell mend, RGST RCST");
   end Tenth_Lost;

   procedure Lost_Command (R : in out Rig) is
      --  The robot does not receive it
   begin
      for Attempt in 1 .. 5 loop
         Play (R, "clear, tell lose 1, RPIN ATIM, RPIN AACK, sent p 2");
         Check (R.Emulator.Journal.First_Element.Answer = "-", "received");
      end loop;
      Play (R, "unsaid robot lost, tell lose 1000000, RPIN ATIM, RPIN ATIM,"
            & " RPIN ATIM, RPIN ATIM, comes ATIM, log robot lost, tell mend, "
            & Works_Again);
   end Lost_Command;

   procedure Movement_Latency (R : in out Rig) is
      --  F12: event-driven, 5 ms. Here only the order of magnitude while
      --  images stream; the benchmark has the figures.
      Count  : constant := 60;
      Sent   : Samples.Set;
      Starts : array (1 .. Count) of Instant;
      Place  : Natural := 0;
   begin
      for Number in Starts'Range loop
         Starts (Number) := Now;
         R.Monitor.Expect
           ((if Number mod 2 = 0 then "RTRN:-30" else "RTRN:30"), "AACK");
         delay 0.029;
      end loop;
      for Item of R.Emulator.Journal loop
         if Index (Item.Command, "T=") = 1 then
            Place := Place + 1;
            Sent.Add (Item.First - Starts (Place));
         end if;
      end loop;
      Check (Place = Count, Place'Image & " orders on the wire");
      Note ("median " & Milliseconds (Sent.Quantile (0.5)) & ", worst "
            & Milliseconds (Sent.Quantile (1.0)));
      Check_Within (Sent.Quantile (0.5), 0.005, "the median order");
      Check_Within (Sent.Usual_Worst (12), 0.1, "the slowest of 12 orders");
   end Movement_Latency;

   procedure Stop_Overtakes (R : in out Rig) is
      --  Rule 3. A ping holds the line; movements wait behind it; the stop is
      --  sent first, and the movements are cancelled.
      First : constant Message := R.Monitor.Next_Answer;
   begin
      Check_Label (First, "AACK ACRJ", "first order");
      Play (R, "answer ACRJ ACRJ ACRJ AACK ACER, wire "
            & (if First.Label = "AACK" then "T=90 M=0" else "M=0")
            & ", tell delay 0, status moving 0, RGFW AACK");
   end Stop_Overtakes;

   procedure Battery_Period (R : in out Rig) is
      --  F13: 500 ms +- 1 %, jitter 20 ms
      Item    : Message;
      Last    : Instant := R.Monitor.Next_Of ("RBLV").Time;
      Periods : Samples.Set;
      Off     : Samples.Set;
   begin
      for Number in 1 .. 12 loop
         Item := R.Monitor.Next_Of ("RBLV");
         Check (Item.Data = "2", "battery " & To_String (Item.Data));
         Periods.Add (Item.Time - Last);
         Off.Add (abs (Periods.Last - 0.5));
         Last := Item.Time;
      end loop;
      Note ("median period " & Milliseconds (Periods.Quantile (0.5))
            & ", the worst by " & Milliseconds (Off.Quantile (1.0)) & " off");
      Check_Within (Off.Usual_Worst (4), 0.1, "the battery's jitter");
      Check_Within (abs (Periods.Quantile (0.5) - 0.5), 0.015,
                    "the battery's period off");
      R.Emulator.Tell ("battery 1");
      R.Monitor.Await ("RBLV");
      Play (R, "comes RBLV:1, RCLS AACK, silence 1.1 RBLV");
   end Battery_Period;

   Lost_Empty : constant String := "robot lost: its battery was empty";

   procedure Idle_Line (R : in out Rig) is
      --  Pings while started, nothing while not
      Start : constant Instant := Now;
      Count : Natural;
   begin
      R.Emulator.Clear_Journal;
      delay 1.0;
      Count := R.Emulator.Count_Of ("p");
      Check (Count in 3 .. Natural (20.0 * Duration'(Now - Start)),
             Count'Image & " pings in " & Milliseconds (Now - Start));
      Play (R, "status state run");
   end Idle_Line;

begin
   Script ("F07_Open_And_Close",
           "ROPN AACK, ROPN AACK, RPIN AACK, RCLS AACK, RCLS AACK, RPIN ANAK",
           Times => 5, Terminal => True);
   Add ("F07_Open_Fails", Open_Fails'Access);
   Script ("F07_Line_In_Use", Forward, Line_In_Use'Access, Terminal => True);
   Script ("F07_Not_Open_Is_ANAK",
           "RSOW ANAK, RSWW ANAK, RRST ANAK, RPIN ANAK, RLDW ANAK, RGFW ANAK,"
           & " RGBW ANAK, RGLF ANAK, RGRI ANAK, RSTP ANAK, RMOV:1 ANAK,"
           & " RTRN:1 ANAK, RPOF ANAK, RGBT ANAK, RGST ANAK, unused");
   Script ("F07_Rule_4_Closing_Stops_The_Robot",
           Forward & ", RCLS AACK, seen M=0, status moving 0, RGFW ANAK");
   Script
     ("F12_No_Stop_To_An_Idle_Robot",
      "ROPN AACK, clear, RSTP ACRJ, MABT ACRJ, sent M=0 0, RSOW AACK,"
      & " RSTP AACK, sent M=0 1, RRST AACK, clear, RSTP ACRJ, sent M=0 0");
   Script ("F07_Closed_Though_Nothing_Leaves", Forward & ", freeze",
           Closed_Though_Nothing_Leaves'Access, In_Time => True);
   Script ("F08_Three_Failures_Are_Not_Lost",
           "ROPN AACK, tell silent on, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
           & " tell silent off, RPIN AACK, unsaid robot lost", Times => 5);
   Script ("F08_Three_Failures_While_Started",
           Started & Three ("3") & Three ("6") & Three ("9") & Three ("12"));
   --  The pings of the supervisor count as well
   Script ("F08_F09_Four_Failures_Are_Lost",
           "ROPN AACK, tell silent on, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
           & " RPIN ATIM, comes ATIM, log robot lost, silence 0.4 ATIM,"
           & " tell silent off, " & Works_Again & ", RRST AACK", Times => 3);
   Script ("F08_Silence_Found_In_Time", Started & ", wait 0.3",
           Silence_Found'Access, Timed => True);
   Script ("F09_Rule_6_Lost_Robot_Keeps_Camera",
           "ROPN AACK, RSWW AACK, " & With_Positions & ", tell silent on,"
           & " comes ATIM, silence 0.5 ATIM, log robot lost, comes CPOS,"
           & " comes CIMG, tell silent off, " & Works_Again & ", CCLS AACK",
           Camera => True);
   Script
     ("F09_Reopened_At_Once",
      "ROPN AACK, tell drop 4, RPIN ATIM, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
      & " comes ATIM, ROPN AACK, RGST RCST:0, RSOW AACK, RCLS AACK",
      Times => 10);
   --  While the answer to the last stop on the lost line is in transit: it
   --  must not be taken for that of the next command
   Script ("F09_Late_When_Reopened",
           Started & ", tell drop 1000, comes ATIM, tell drop 0,"
           & " tell delay 700, ROPN AACK, tell delay 0, wait 1, RSOW AACK",
           Terminal => True);
   --  A robot that was lost while started, and whose answers are late when its
   --  line is opened again, is reset nevertheless
   Script ("F08_Garbled_Answers",
           "ROPN AACK, tell $ 1, RPIN ATIM, RGBT RBLV:2, tell $ 1, RGST ATIM,"
           & " RGST RCST:0, unsaid robot lost",
           Each => 3 * "drop corrupt garbage truncate ");
   Script ("F08_Garbled_For_Long",
           "ROPN AACK, tell garbage 1000000, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
           & " RPIN ATIM, comes ATIM, silence 0.5 ATIM, log robot lost,"
           & " tell garbage 0, " & Works_Again);
   Script
     ("F08_Late_Answers",
      "ROPN AACK, tell delay 40, RPIN AACK, tell delay 450, RGBT ATIM,"
      & " tell delay 0, RGST RCST:0, tell delay 450, RPIN ATIM,"
      & " tell delay 0, RGBT RBLV:1, tell delay 900, RGST ATIM,"
      & " tell delay 0, wait 0.9, RGBT RBLV:1, RPIN AACK,"
      & " unsaid robot lost", Emulator_Options => "--battery 1", Times => 5);
   --  A late answer never passes for the answer to the next command. The robot
   --  answers in order: after the last one, its next is late, too.
   Script ("F08_Answers_Within_80_Ms",
           "ROPN AACK, tell delay 40, RPIN AACK, tell delay 120, RPIN ATIM",
           Timed => True);
   Script ("F08_Unasked_Bytes",
           "ROPN AACK, tell unasked EE\r, wait 0.2, RPIN AACK,"
           & " log sends without being asked,"
           & " tell unasked 00\r1, wait 0.2, RGBT RBLV:2,"
           & " tell unasked \x00\xFF\x01\r\r\rOO, wait 0.2, RGST RCST:0,"
           & " unsaid robot lost, RCLS AACK", Times => 5);
   --  The first is a whole good frame, "E" with its checksum
   Script ("F08_Talking_Line",
           "ROPN AACK, tell silent on, tell unasked "
           & 60 * "OO\r" & ", wait 0.05, RSWW ATIM,"
           & " log sends without being asked, wait 0.4, tell silent off,"
           & " RCLS AACK", Times => 10,
           Timed => True);
   --  A device that sends the answer "O" without end is no started robot
   Script ("F08_Talking_From_The_Start", "tell silent on",
           Talking_From_The_Start'Access);
   Script ("F08_Talking_Now_And_Then", "tell silent on",
           Talking_Now_And_Then'Access,
           Supervisor_Options => "--answer-timeout 80");
   Script ("F08_Noisy_Line",
           "ROPN AACK, " & 5 * ("tell unasked " & 200 * 'U' & ", ")
           & 3 * "soon 0.5 RPIN, " & "wait 1.2, RCLS AACK, " & Started
           & ", RPIN AACK", Terminal => True, In_Time => True);
   --  A second of noise at 9600 baud: every command is answered in bounded
   --  time, and all works after it
   Script ("F07_Robot_Silent_When_Opened",
           "ROPN AACK, RPIN ATIM, tell silent off, RSOW AACK",
           Emulator_Options => "--silent", Terminal => True);
   Script
     ("F08_Hung_Up_In_Mid_Transaction",
      Started & ", clear, tell silent on, send RPIN, seen p,"
      & " tell hangup, answer ATIM|ANAK, comes ATIM, silence 0.3 ATIM,"
      & " log the device of its line has gone,"
      & " RPIN ANAK, ROPN ANAK, tell silent off, tell return, " & Works_Again
      & ", RCLS AACK", Times => 3, Terminal => True);
   Script ("F08_Hung_Up_While_Idle",
           With_Images & ", ROPN AACK, RSWW AACK, RGFW AACK, tell hangup,"
           & " comes ATIM, silence 0.5 ATIM, log robot lost, tell return, "
           & Works_Again, Camera => True, Terminal => True);
   Script ("F10_F11_Start_Refused",
           "ROPN AACK, RSOW ACRJ, RSWW ACRJ, RGFW ACRJ, RPIN AACK,"
           & " status state idle, RGFW ACRJ, silence 0.7 RBLV, RSWW AACK,"
           & " RSOW ACRJ, RGFW AACK, status watchdog on",
           Emulator_Options => "--boot-ms 5000");
   Script ("F11_Start_Unanswered",
           "ROPN AACK, tell silent on, RSWW ATIM, tell silent off,"
           & " silence 0.7 RBLV, RGFW ACRJ, RRST AACK, RSOW AACK");
   Script ("F10_Start_Without_Watchdog",
           "ROPN AACK, sent u 0, RSOW AACK, sent u 1, sent W 0,"
           & " status state run, status watchdog off, wait 1.2, sent w 0");
   Script ("F11_Start_With_Watchdog",
           Guarded & ", status watchdog on, wait 5.6", With_Watchdog'Access,
           Timed => True);
   Script
     ("F11_Reloads_End_With_The_Reset",
      "ROPN AACK, RSWW AACK, status watchdog on, seen w, RRST AACK, clear,"
      & " wait 1.3, sent w 0");
   Script ("F11_Rule_5_Robot_No_Longer_Runs",
           "ROPN AACK, RSWW AACK, tell reset-robot,"
           & Says_Not_Running
           & " silence 1.5 MSSG RBLV ATIM, RGFW ACRJ, RSWW AACK, RGFW AACK");
   Script
     ("F10_Restarted_Without_Watchdog",
      Started & ", tell reset-robot, RGFW ACRJ," & Says_Not_Running
      & " clear, RGFW ACRJ, wire, status state idle, RSOW AACK, RGFW AACK,"
      & " tell reset-robot, RSTP ACRJ," & Says_Not_Running
      & " status state idle, RSOW AACK, RGFW AACK, tell charge on,"
      & " RGFW ACRJ," & Says_Not_Running & " tell charge off,"
      & " status state idle, RSOW AACK, RRST AACK, status state idle",
      Times => 3);
   --  No reload tells of it, but the first order
   Script ("F11_Lost_Reloads", Guarded, Lost_Reloads'Access, Timed => True);
   Script
     ("F11_Reload_By_Hand",
      "ROPN AACK, RSWW AACK, RLDW AACK, RLDW AACK, RLDW AACK, RLDW AACK,"
      & " RLDW AACK, sent w 0, wait 2.2, status missed_total 0, RRST AACK,"
      & " RSOW AACK, clear, RLDW AACK, sent w 1",
      Timed => True);
   --  It does not disturb the supervisor's own; without one of its own the
   --  supervisor sends it to the robot.
   Script
     ("F12_Movements",
      Started & ", clear, RGFW AACK, wait 0.3, wire M=32767,"
      & " RGBW AACK, RGLF AACK, RGRI AACK, RSTP AACK,"
      & " wire M=32767 M=-32768 T=32767 T=-32768 M=0, clear, RMOV:100 AACK,"
      & " RMOV:-1 AACK, RMOV:0 AACK, RTRN:-90 AACK, RTRN:360 AACK,"
      & " wire M=100 M=-1 M=0 T=-90 T=360, clear, RMOV:32767 AACK,"
      & " RMOV:32768 AACK, RMOV:-40000 AACK,"
      & " RTRN:99999999999999999999 AACK, RSTP AACK,"
      & " wire M=32767 M=32767 M=-32768 T=32767 M=0");
   Script ("F08_Every_Tenth_Answer_Lost",
           Started & ", clear, tell drop-every 10", Tenth_Lost'Access);
   Script ("F08_Every_Tenth_Command_Lost",
           Started & ", clear, tell lose-every 10", Tenth_Lost'Access);
   Script ("F08_Lost_Command", "ROPN AACK", Lost_Command'Access);
   Script ("F12_Movement_Latency",
           Guarded & ", " & With_Positions & ", clear",
           Movement_Latency'Access, Camera => True, Timed => True);
   Script ("F12_Rule_3_Stop_Overtakes",
           Started & ", RGFW AACK, tell delay 150, clear,"
           & " send RTRN:90|RMOV:1|RMOV:2|RTRN:3|RSTP|what",
           Stop_Overtakes'Access);
   Script ("F13_Battery_Period", "ROPN AACK, silence 0.8 RBLV, RSOW AACK",
           Battery_Period'Access, In_Time => True);
   Script ("Battery_On_Request",
           "ROPN AACK, RGBT RBLV:0, tell battery 1, RGBT RBLV:1,"
           & " tell battery 2, RGBT RBLV:2, tell silent on, RGBT ATIM",
           Emulator_Options => "--battery 0");
   Script
     ("Version_On_Request",
      "RVER ANAK, ROPN AACK, RVER RVER:3.5, seen V, RSWW AACK, RGFW AACK,"
      & " RVER RVER:3.5, RGST RCST:1, tell drop 1, RVER ATIM, RVER RVER:3.5,"
      & " unsaid robot lost");
   Script ("State_On_Request",
           Started & ", RGST RCST:0, RTRN:30000 AACK, RGST RCST:1,"
           & " RSTP AACK, RGST RCST:0");
   Script ("Reset_On_Request",
           Started & ", RGFW AACK, RRST AACK, status state idle,"
           & " RGFW ACRJ, silence 0.7 RBLV, RSWW AACK, RGFW AACK, RRST AACK,"
           & " status state idle, RGFW ACRJ, silence 0.7 RBLV", Times => 2);
   Script ("Power_Off_On_Request",
           Started & ", RGFW AACK, clear, RPOF AACK,"
           & " status state off, seen z, silence 0.7 RBLV, RPIN ATIM,"
           & " tell reset-robot, status state idle, RCLS AACK, ROPN AACK,"
           & " RSOW AACK");
   Script
     ("Battery_Critical",
      Started & ", RGFW AACK, comes RBLV:0, tell battery critical,"
      & " status moving 0, comes RBLV:-1, comes MSSG:" & Lost_Empty
      & ", log " & Lost_Empty & ", tell battery 2, status state off,"
      & " tell reset-robot, status state idle, ROPN AACK, RSOW AACK,"
      & " comes RBLV:2, tell silent on, comes ATIM, silence 0.5 MSSG",
      Emulator_Options => "--battery 0");
   --  The reason for the loss, and only of that one
   Script
     ("Power_Off_Unanswered",
      "ROPN AACK, tell lose 1, RPOF AACK, status state off, sent z 2,"
      & " tell reset-robot, status state idle, tell drop 1, RPOF AACK,"
      & " status state off, sent z 3, tell reset-robot, status state idle,"
      & " RPIN AACK, tell truncate 1 1, RPOF AACK, status state off, sent z 4,"
      & " RPIN ATIM, unsaid robot lost, tell reset-robot,"
      & " status state idle, RCLS AACK, clear",
      Times => 3);
   --  Whether it or its answer was lost, or the answer was cut
   Script ("F07_Idle_Robot_Stays_On",
           "ROPN AACK, clear, wait 25, unused, seen p, sent p 1");
   Script ("F07_Open_Asks_The_Robot",
           "ROPN AACK, ROPN AACK, tell silent on, ROPN ATIM, tell silent off,"
           & " ROPN AACK, RSOW AACK, ROPN AACK, status state run");
   Script ("F08_Answers_Later",
           "ROPN AACK, tell delay 140, RPIN AACK, RGBT RBLV:2, RSWW AACK,"
           & " wait 3.3, status missed_total 0, tell delay 400, RPIN ATIM",
           Supervisor_Options => "--answer-timeout 200",
           Timed => True);
   Script ("Power_Off_And_On_Again",
           Started & ", RPOF AACK, status state idle, RSOW AACK,"
           & " RGFW AACK",
           Emulator_Options => "--stay-on");
   Script ("F08_Idle_Line_Is_Watched",
           "ROPN AACK, clear, wait 0.6, unused, RSOW AACK", Idle_Line'Access);
   Script ("F11_Watchdog_Kept_For_60_s",
           Guarded & ", " & With_Positions & ", clear", Watchdog_Kept'Access,
           Camera => True, Timed => True);
end Robot_Tests;
