--  SPDX-License-Identifier: GPL-3.0-or-later
--  F7 to F13: the robot, its line and its orders.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;

with Busy_Loops;
with Child_Processes;       use Child_Processes;
with Dialogues;             use Dialogues;
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
with Supervisors;

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
            R.Supervisor.Start ("--serial " & Path);
            Connect (R);
            Play (R, "ROPN ANAK, ROPN ANAK, RPIN ANAK, RCLS AACK");
         end;
      end loop;
   end Open_Fails;

   procedure Line_In_Use is
      --  Another supervisor is refused, of root too, and other programs of an
      --  ordinary user; the line is free when the first has closed it or was
      --  killed
      R      : Rig;
      Second : Supervisors.Supervisor;
      Next   : Client;
      Cat    : Child;
      User   : constant String :=
        (if Libc.Geteuid = 0 then Programs.As_User else "env");

      function Owner return String is
         --  its name is not destijl where it is emulated
         Pid  : constant String := Image (Integer (R.Supervisor.Pid));
         File : Ada.Text_IO.File_Type;
      begin
         Ada.Text_IO.Open
           (File, Ada.Text_IO.In_File, "/proc/" & Pid & "/comm");
         return Name : constant String :=
           Ada.Text_IO.Get_Line (File) & " (process " & Pid & ")"
         do
            Ada.Text_IO.Close (File);
         end return;
      end Owner;

      procedure Await_Line is
         Deadline : constant Instant := Now + Patience;
      begin
         while Next.Ask ("ROPN").Label /= "AACK" loop
            Check (Now < Deadline, "the line stays in use");
            delay 0.2;
         end loop;
      end Await_Line;

   begin
      Assemble (R, Terminal => True);
      Move_Forward (R);
      Second.Start ("--serial " & R.Emulator.Device);
      Second.Expect_Log
        ("no stop was sent on " & R.Emulator.Device & ": in use by " & Owner);
      Supervisors.Expect_Console ("--stop --serial " & R.Emulator.Device, 1,
                                  R.Emulator.Device & ": in use by " & Owner);
      Check (R.Emulator.Status ("moving") = "1", "another has stopped it");
      Next.Connect (Second.Port);
      Next.Expect ("ROPN", "ANAK");
      Second.Expect_Log ("in use by " & Owner);
      Supervisors.Expect_Console
        ("--check --port 0 --serial " & R.Emulator.Device, 1,
         R.Emulator.Device & ": in use by " & Owner);
      Cat.Start ("env", Words (User & " cat " & R.Emulator.Device));
      Check (Cat.Exit_Status = 1, "another program reads it");
      R.Monitor.Expect ("RPIN", "AACK");
      R.Monitor.Expect ("RCLS", "AACK");
      Next.Expect ("ROPN", "AACK");
      R.Monitor.Expect ("ROPN", "ANAK");
      Second.Send_Signal (Libc.Sigkill);
      Second.Start ("--serial " & R.Emulator.Device);
      Next.Connect (Second.Port);
      Await_Line;
   end Line_In_Use;

   procedure Closed_Though_Nothing_Leaves is
      --  The kernel's close waits up to 30 s for a device that hangs
      R     : Rig;
      Begun : Instant;
   begin
      Assemble (R);
      Move_Forward (R);
      R.Emulator.Send_Signal (Libc.Sigstop);
      Begun := Now;
      --  ATIM: if battery requests find the robot lost before
      Check_Label (R.Monitor.Ask ("RCLS"), "AACK ATIM", "RCLS");
      Check_Within (Now - Begun, 0.5, "RCLS");
      if Programs.With_Sockets then
         R.Supervisor.Expect_Log ("its device did not take all");
         Supervisors.Expect_Console
           ("--stop --serial " & R.Emulator.Device, 1, "it takes nothing");
      end if;
      R.Monitor.Expect ("ROPN", "AACK");
      Connect (R);
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Emulator.Send_Signal (Libc.Sigcont);
      Play (R, "status moving 0, ROPN AACK");
      R.Emulator.Send_Signal (Libc.Sigstop);
      Begun := Now;
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "its end was not orderly");
      Check_Within (Now - Begun, 1.0, "the end");
   end Closed_Though_Nothing_Leaves;

   procedure Three_Failures is
      R      : Rig;
      Spoilt : Integer;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      Play (R, "tell silent on, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
            & " tell silent off, RPIN AACK, unsaid robot lost", Times => 5);

      --  Started, too: the pings of the supervisor count as well
      R.Monitor.Expect ("RSOW", "AACK");
      for Attempt in 1 .. 5 loop
         Spoilt := R.Emulator.Status_Number ("spoilt");
         R.Emulator.Tell ("drop 3");
         R.Emulator.Await_Status ("spoilt", Image (Spoilt + 3));
         Play (R, "silence 0.1 ATIM, RPIN AACK, unsaid robot lost");
      end loop;
   end Three_Failures;

   procedure Silence_Found is
      --  Issue: a lost line is found within 1 s while the robot is started
      R    : Rig;
      Time : Instant;
      Item : Message;
   begin
      Assemble (R);
      Start_Robot (R);
      delay 0.3;
      R.Monitor.Skip_To_Now;
      R.Emulator.Tell ("silent on");
      Time := Now;
      Item := R.Monitor.Next_Of ("ATIM");
      Check_Within (Item.Time - Time, 1.5, "finding the loss");
      R.Monitor.Expect_Silence ("ATIM RBLV", For_Time => 1.0);
      Check (R.Supervisor.Count_Of ("robot lost") = 1,
             "the loss is said more than once");
      R.Emulator.Tell ("silent off");
      Play (R, Works_Again);
   end Silence_Found;

   procedure Garbled is
      R : Rig;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      for Fault of Words ("drop corrupt garbage truncate") loop
         Play (R, "tell " & Fault & " 1, RPIN ATIM, RGBT RBLV:2, tell " & Fault
               & " 1, RGST ATIM, RGST RCST:0, unsaid robot lost", Times => 3);
      end loop;
      Play (R, "tell garbage 1000000, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
            & " RPIN ATIM, comes ATIM, silence 0.5 ATIM, log robot lost,"
            & " tell garbage 0, " & Works_Again);
   end Garbled;

   procedure Talking_From_The_Start is
      --  Nor one that has never been in step
      R      : Rig;
      Before : Natural;
   begin
      Assemble (R);
      R.Emulator.Tell ("silent on");
      --  for longer than the orders take
      for Number in 1 .. 60 loop
         R.Emulator.Tell ("unasked " & To_String (60 * "OO\r"));
      end loop;
      for Attempt in 1 .. 3 loop
         Before := R.Supervisor.Log_Length;
         for Command of Words ("ROPN RSWW RPIN RSOW RSWW RPIN") loop
            R.Monitor.Send_Line (Command);
         end loop;
         R.Supervisor.Expect_Log ("robot lost: four", After => Before);
      end loop;
      Check
        (not R.Supervisor.Says ("robot started"), "it has started a robot");
   end Talking_From_The_Start;

   procedure Talking_Now_And_Then is
      --  Nor one that does so less often than a command takes

      procedure Talk (Period : Duration) is
         R : Rig;
      begin
         Assemble (R, Supervisor_Options => "--answer-timeout 80");
         R.Emulator.Tell ("silent on");
         for Command of Words ("ROPN RSWW RSWW RPIN RSOW RPIN RPIN RPIN") loop
            for Number in 1 .. 4 loop
               R.Emulator.Tell ("unasked OO\r");
               delay Period;
            end loop;
            R.Emulator.Tell ("unasked OO\r");
            delay Period / 2;
            R.Monitor.Send_Line (Command);
            delay Period / 2;
         end loop;
         R.Supervisor.Expect_Log ("robot lost: four");
         Check
           (not R.Supervisor.Says ("robot started"), "it has started a robot");
      end Talk;

   begin
      Talk (0.06);
      Talk (0.1);
   end Talking_Now_And_Then;

   procedure Noisy_Line is
      --  A line that never falls silent: every command is answered in bounded
      --  time, and all works after the noise
      R    : Rig;
      Item : Message;
      Time : Instant;
   begin
      Assemble (R, Terminal => True);
      R.Monitor.Expect ("ROPN", "AACK");
      R.Monitor.Skip_To_Now;
      --  about a second of noise at 9600 baud
      for Number in 1 .. 5 loop
         R.Emulator.Tell ("unasked " & (1 .. 200 => 'U'));
      end loop;
      for Number in 1 .. 3 loop
         Time := Now;
         R.Monitor.Send_Line ("RPIN");
         Item := R.Monitor.Next_Answer;
         Check_Within (Item.Time - Time, 0.5, "an answer in noise");
      end loop;
      delay 1.2;
      R.Monitor.Expect ("RCLS", "AACK");
      Start_Robot (R);
      R.Monitor.Expect ("RPIN", "AACK");
   end Noisy_Line;

   procedure With_Watchdog is
      --  F11: the robot takes a reload 950 to 1050 ms after the last
      R   : Rig;
      Off : Samples.Set;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      R.Monitor.Expect ("RSWW", "AACK");
      Check (R.Emulator.Status ("watchdog") = "on", "watchdog off");
      delay 5.6;
      for Item of R.Emulator.Journal loop
         if Item.Command = "w" then
            Note ("reload after " & Milliseconds (Item.Interval));
            Off.Add (abs (Item.Interval - 1.0));
         end if;
      end loop;
      Check_In_Time (Off.Count = 5, Off.Count'Image & " reloads in 5.6 s");
      Check_Within (Off.Quantile (0.5), 0.05, "what a reload is off");
   end With_Watchdog;

   procedure Watchdog_Kept is
      --  60 s with images, positions, orders and two busy loops; memory
      --  stays flat meanwhile
      R    : Rig;
      Load : Busy_Loops.Load;
      Time : Instant;
      Early, Late    : Natural := 0;
      Round, Reloads : Natural := 0;
      Worst : Duration := 0.0;
   begin
      Assemble (R, Camera => True);
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Load.Start;
      R.Emulator.Clear_Journal;
      Time := Now;
      while Now - Time < 60.0 loop
         R.Monitor.Expect
           ((case Round mod 6 is
                when 0 => "RGFW", when 1 => "RGLF", when 2 => "RGBT",
                when 3 => "RMOV:-20", when 4 => "RGST",
                when others => "RSTP"),
            (case Round mod 6 is
                when 2 => "RBLV", when 4 => "RCST", when others => "AACK"));
         Round := Round + 1;
         if Early = 0 and then Now - Time > 15.0 then
            Early := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
         end if;
         delay 0.047;
      end loop;
      Late := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
      for Item of R.Emulator.Journal loop
         if Item.Command = "w" then
            Reloads := Reloads + 1;
            Worst := Duration'Max (Worst, abs (Item.Interval - 1.0));
         end if;
      end loop;
      Note (Reloads'Image & " reloads, the worst by "
            & Milliseconds (Worst) & " off;" & Round'Image & " orders;"
            & Natural'Image (Late) & " kB, after"
            & Natural'Image (Early) & " kB");
      Check (Late <= Early + 1024,
             "memory grows:" & Early'Image & " kB," & Late'Image & " kB");
      Check_In_Time (Reloads >= 58, "only" & Reloads'Image & " reloads");
      --  without real-time priorities deadlines are not guaranteed, but the
      --  robot keeps running
      if R.Supervisor.Says ("real-time priorities: FIFO") then
         Check_In_Time
           (R.Emulator.Status ("missed_total") = "0", "windows missed");
      end if;
      Check (R.Emulator.Status ("disabled_count") = "0", "robot disabled");
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Watchdog_Kept;

   procedure Lost_Reloads is
      --  F11: a lost reload, or its answer, costs one miss at most; two
      --  reloads in a row do not disable the robot
      R : Rig;

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
         Check_In_Time (Repeated = Times,
                        Fault & Times'Image & ", repeated" & Repeated'Image);
         Missed := R.Emulator.Status_Number ("missed_total") - Before;
         Note (Fault & Times'Image & ", missed" & Missed'Image);
         Check_In_Time
           (Missed <= Misses, Fault & Times'Image & ", missed" & Missed'Image);
         Check (R.Emulator.Status ("disabled_count") = "0", "robot disabled");
      end Lose;

   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      R.Monitor.Expect ("RSWW", "AACK");
      Lose ("lose", Times => 1, Misses => 1);
      Lose ("drop", Times => 1, Misses => 1);
      Lose ("lose", Times => 2, Misses => 2);
   end Lost_Reloads;

   Says_Not_Running : constant String :=
     " comes MSSG:robot no longer runs (watchdog or reset): reset and start"
     & " again,";

   generic
      Fault : String;
   procedure Tenth_Lost;

   procedure Tenth_Lost is
      --  Of all, so the levels of the battery have theirs too, and one of ten
      --  of these orders may have none for long
      R      : Rig;
      Late   : Natural := 0;
      All_Of : Integer;
      Spoilt : Integer;
   begin
      Assemble (R);
      Start_Robot (R);
      R.Emulator.Clear_Journal;
      R.Emulator.Tell (Fault & " 10");
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
      R.Emulator.Tell ("mend");
      R.Monitor.Expect ("RGST", "RCST");
   end Tenth_Lost;

   procedure Tenth_Answer_Lost is new Tenth_Lost ("drop-every");
   procedure Tenth_Command_Lost is new Tenth_Lost ("lose-every");

   procedure Lost_Command is
      --  The robot does not receive it
      R      : Rig;
      Before : Integer;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      for Attempt in 1 .. 5 loop
         Before := R.Emulator.Status_Number ("commands");
         Play (R, "clear, tell lose 1, RPIN ATIM, RPIN AACK, sent p 2");
         Check (R.Emulator.Journal.First_Element.Answer = "-"
                and then R.Emulator.Status_Number ("commands") - Before
                         = Integer (R.Emulator.Journal.Length) - 1,
                "received");
      end loop;
      Play (R, "unsaid robot lost, tell lose 1000000, RPIN ATIM, RPIN ATIM,"
            & " RPIN ATIM, RPIN ATIM, comes ATIM, log robot lost, tell mend, "
            & Works_Again);
   end Lost_Command;

   procedure Movement_Latency is
      --  F12: event-driven, 5 ms. Here only the order of magnitude while
      --  images stream; the benchmark has the figures.
      Count : constant := 60;
      R     : Rig;
      Sent   : Samples.Set;
      Starts : array (1 .. Count) of Instant;
      Place  : Natural := 0;
   begin
      Assemble (R, Camera => True);
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      R.Emulator.Clear_Journal;
      for Number in Starts'Range loop
         R.Monitor.Skip_To_Now;
         Starts (Number) := Now;
         R.Monitor.Send_Line
           ((if Number mod 2 = 0 then "RTRN:-30" else "RTRN:30"));
         Check_Label (R.Monitor.Next_Answer, "AACK", "an order");
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

   procedure Stop_Overtakes is
      --  Rule 3. A ping holds the line; movements wait behind it; the stop is
      --  sent first, and the movements are cancelled.
      R : Rig;
   begin
      Assemble (R);
      Start_Robot (R);
      R.Monitor.Expect ("RGFW", "AACK");
      R.Emulator.Tell ("delay 150");
      R.Emulator.Clear_Journal;
      R.Monitor.Skip_To_Now;
      R.Monitor.Send
        ("RTRN:90" & ASCII.LF & "RMOV:1" & ASCII.LF & "RMOV:2" & ASCII.LF
         & "RTRN:3" & ASCII.LF & "RSTP" & ASCII.LF & "what" & ASCII.LF);
      declare
         First : constant Message := R.Monitor.Next_Answer;
      begin
         Check_Label (First, "AACK ACRJ", "first order");
         for Number in 1 .. 3 loop
            Check_Label (R.Monitor.Next_Answer, "ACRJ",
                         "order" & Number'Image & " that waited");
         end loop;
         Check_Label (R.Monitor.Next_Answer, "AACK", "the stop");
         Check_Label (R.Monitor.Next_Answer, "ACER", "out of order");
         declare
            Wire : constant String := R.Emulator.Wire_Text;
         begin
            Check (Wire = (if First.Label = "AACK" then "T=90 M=0 "
                           else "M=0 "),
                   "on the wire: " & Wire);
         end;
      end;
      R.Emulator.Tell ("delay 0");
      R.Emulator.Await_Status ("moving", "0");
      R.Monitor.Expect ("RGFW", "AACK");
   end Stop_Overtakes;

   procedure Battery_Period is
      --  F13: 500 ms +- 1 %, jitter 20 ms
      Count   : constant Positive := 13;
      R       : Rig;
      Item    : Message;
      Last    : Instant;
      Periods : Samples.Set;
      Off     : Samples.Set;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      R.Monitor.Expect_Silence ("RBLV", For_Time => 0.8);
      R.Monitor.Expect ("RSOW", "AACK");
      Last := R.Monitor.Next_Of ("RBLV").Time;
      for Number in 2 .. Count loop
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
      Item := R.Monitor.Next_Of ("RBLV");
      Item := R.Monitor.Next_Of ("RBLV");
      Check (Item.Data = "1", "battery " & To_String (Item.Data));
      R.Monitor.Expect ("RCLS", "AACK");
      R.Monitor.Expect_Silence ("RBLV", For_Time => 1.1);
   end Battery_Period;

   Lost_Empty : constant String := "robot lost: its battery was empty";

   procedure Idle_Line is
      --  Pings while started, nothing while not
      R     : Rig;
      Start : Instant;
      Count : Natural;
   begin
      Assemble (R);
      Play (R, "ROPN AACK, clear, wait 0.6, unused, RSOW AACK");
      Start := Now;
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
   Add ("F07_Line_In_Use", Line_In_Use'Access);
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
   Add ("F07_Closed_Though_Nothing_Leaves",
        Closed_Though_Nothing_Leaves'Access, In_Time => True);
   Add ("F08_Three_Failures_Are_Not_Lost", Three_Failures'Access);
   Script ("F08_F09_Four_Failures_Are_Lost",
           "ROPN AACK, tell silent on, RPIN ATIM, RPIN ATIM, RPIN ATIM,"
           & " RPIN ATIM, comes ATIM, log robot lost, silence 0.4 ATIM,"
           & " tell silent off, " & Works_Again & ", RRST AACK", Times => 3);
   Add ("F08_Silence_Found_In_Time", Silence_Found'Access, Timed => True);
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
           "ROPN AACK, RSOW AACK, tell drop 1000, comes ATIM, tell drop 0,"
           & " tell delay 700, ROPN AACK, tell delay 0, wait 1, RSOW AACK",
           Terminal => True);
   --  A robot that was lost while started, and whose answers are late when its
   --  line is opened again, is reset nevertheless
   Add ("F08_Garbled_Answers", Garbled'Access);
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
           & To_String (60 * "OO\r") & ", wait 0.05, RSWW ATIM,"
           & " log sends without being asked, wait 0.4, tell silent off,"
           & " RCLS AACK", Times => 10,
           Timed => True);
   --  A device that sends the answer "O" without end is no started robot
   Add ("F08_Talking_From_The_Start", Talking_From_The_Start'Access);
   Add ("F08_Talking_Now_And_Then", Talking_Now_And_Then'Access);
   Add ("F08_Noisy_Line", Noisy_Line'Access, In_Time => True);
   Script ("F07_Robot_Silent_When_Opened",
           "ROPN AACK, RPIN ATIM, tell silent off, RSOW AACK",
           Emulator_Options => "--silent", Terminal => True);
   Script
     ("F08_Hung_Up_In_Mid_Transaction",
      "ROPN AACK, RSOW AACK, clear, tell silent on, send RPIN, seen p,"
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
   Add ("F11_Start_With_Watchdog", With_Watchdog'Access, Timed => True);
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
      "ROPN AACK, RSOW AACK, tell reset-robot, RGFW ACRJ," & Says_Not_Running
      & " clear, RGFW ACRJ, wire, status state idle, RSOW AACK, RGFW AACK,"
      & " tell reset-robot, RSTP ACRJ," & Says_Not_Running
      & " status state idle, RSOW AACK, RGFW AACK, tell charge on,"
      & " RGFW ACRJ," & Says_Not_Running & " tell charge off,"
      & " status state idle, RSOW AACK, RRST AACK, status state idle",
      Times => 3);
   --  No reload tells of it, but the first order
   Add ("F11_Lost_Reloads", Lost_Reloads'Access, Timed => True);
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
      "ROPN AACK, RSOW AACK, clear, RGFW AACK, wait 0.3, wire M=32767,"
      & " RGBW AACK, RGLF AACK, RGRI AACK, RSTP AACK,"
      & " wire M=32767 M=-32768 T=32767 T=-32768 M=0, clear, RMOV:100 AACK,"
      & " RMOV:-1 AACK, RMOV:0 AACK, RTRN:-90 AACK, RTRN:360 AACK,"
      & " wire M=100 M=-1 M=0 T=-90 T=360, clear, RMOV:32767 AACK,"
      & " RMOV:32768 AACK, RMOV:-40000 AACK,"
      & " RTRN:99999999999999999999 AACK, RSTP AACK,"
      & " wire M=32767 M=32767 M=-32768 T=32767 M=0");
   Script
     ("F12_Wheels_Not_Ideal",
      "ROPN AACK, RSOW AACK, RMOV:200 AACK, status moving 0,"
      & " status x 33.998, status y 30.171, status heading 1.400,"
      & " RTRN:90 AACK, status moving 0, status x 33.998, status y 30.171,"
      & " status heading 109.400, tell turn-speed 70, tell overshoot 0,"
      & " RTRN:-90 AACK, status moving 0, status x 33.998,"
      & " status y 30.171, status heading 46.400, wire M=200 T=90 T=-90",
      Emulator_Options =>
        "--pose 20,30,0 --speed 70 --overshoot"
       & " 20 --pull 10");
   --  The orders are as ever; what the emulated robot makes of them is not. 14
   --  cm on an arc of 10 degrees a metre: 13.999 and 0.171 cm
   Add ("F08_Every_Tenth_Answer_Lost", Tenth_Answer_Lost'Access);
   Add ("F08_Every_Tenth_Command_Lost", Tenth_Command_Lost'Access);
   Add ("F08_Lost_Command", Lost_Command'Access);
   Add ("F12_Movement_Latency", Movement_Latency'Access, Timed => True);
   Add ("F12_Rule_3_Stop_Overtakes", Stop_Overtakes'Access);
   Add ("F13_Battery_Unasked", Battery_Period'Access);
   Add ("F13_Battery_Period", Battery_Period'Access, Timed => True);
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
           "ROPN AACK, RSOW AACK, RGST RCST:0, RTRN:30000 AACK, RGST RCST:1,"
           & " RSTP AACK, RGST RCST:0");
   Script ("Reset_On_Request",
           "ROPN AACK, RSOW AACK, RGFW AACK, RRST AACK, status state idle,"
           & " RGFW ACRJ, silence 0.7 RBLV, RSWW AACK, RGFW AACK, RRST AACK,"
           & " status state idle, RGFW ACRJ, silence 0.7 RBLV", Times => 2);
   Script ("Power_Off_On_Request",
           "ROPN AACK, RSOW AACK, RGFW AACK, clear, RPOF AACK,"
           & " status state off, seen z, silence 0.7 RBLV, RPIN ATIM,"
           & " tell reset-robot, status state idle, RCLS AACK, ROPN AACK,"
           & " RSOW AACK");
   Script
     ("Battery_Critical",
      "ROPN AACK, RSOW AACK, RGFW AACK, comes RBLV:0, tell battery critical,"
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
           "ROPN AACK, RSOW AACK, RPOF AACK, status state idle, RSOW AACK,"
           & " RGFW AACK",
           Emulator_Options => "--stay-on");
   Add ("F08_Idle_Line_Is_Watched", Idle_Line'Access);
   Add ("F11_Watchdog_Kept_For_60_s", Watchdog_Kept'Access, Timed => True);
end Robot_Tests;
