--  SPDX-License-Identifier: GPL-3.0-or-later
--  F1 to F3: the server, and the command line.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;

with GNAT.Sockets;          use GNAT.Sockets;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Process_Facts;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;

package body Server_Tests is

   --  F1 asks for an end within 1 s; a shared machine gets three times that
   End_Limit : constant Duration := 3.0;

   procedure Listens;
   procedure Port_Taken;
   procedure Address_Not_Ours;
   procedure Address_Malformed;
   procedure Admitted_Quickly;
   procedure Crowd_Finds_Room;
   procedure Streams_Closed;
   procedure Burst_Of_10_000;
   procedure Burst_While_Started;
   procedure Flood_Keeps_Memory;
   procedure Options_Bad;
   procedure Options_Help;
   procedure Options_Version;
   procedure Not_Heard;
   procedure Check_All_Well;
   procedure Check_Nothing_Well;
   procedure Log_Levels;

   procedure Expect_End
     (S : in out Supervisor; Status : Integer; Within : Duration);

   procedure Expect_End
     (S : in out Supervisor; Status : Integer; Within : Duration)
   is
      Seen : constant Integer := S.Exit_Status (Within);
   begin
      delay 0.05;
      --  its last lines are on their way
      Check
        (Seen = Status,
         "exit status" & Integer'Image (Seen) & " instead of"
         & Integer'Image (Status) & ": " & S.Log_Text);
   end Expect_End;

   procedure Listens is
      S : Supervisor;
      M : Client;
   begin
      S.Start;
      declare
         Log   : constant String := S.Log_Text;
         First : constant String :=
           Log (1 .. Index (Log, (1 => ASCII.LF)) - 1);
      begin
         Check
           (Index (First, "listening on 127.0.0.1:" & Image (S.Port)) > 0,
            "the first line of the log is: " & First);
         Check
           (First (1) = '[' and then Index (First, "]") > 0,
            "no time stamp in: " & First);
      end;
      Check (S.Output_Text = "", "the log is for standard error");
      M.Connect (S.Port);
      M.Expect ("RPIN", "ANAK");
      S.Send_Signal (Libc.Sigterm);
      Expect_End (S, 0, End_Limit);
   end Listens;

   procedure Port_Taken is
      First, Second : Supervisor;
      Start         : Instant;
   begin
      First.Start;
      Start := Now;
      Second.Run
        ("--bind 127.0.0.1 --port " & Image (First.Port));
      Expect_End (Second, 1, End_Limit);
      Note ("ended after " & Milliseconds (Now - Start));
      declare
         Log : constant String := Second.Log_Text;
      begin
         Check
           (Index (Log, "127.0.0.1:" & Image (First.Port)) > 0,
            "the address is not named: " & Log);
         Check
           (Index (To_Lower (Log), "in use") > 0,
            "the reason is not named: " & Log);
         Check
           (Index (Log, "listening on") = 0, "it says that it listens");
      end;
      Check (First.Is_Running, "the one that listened is gone");
   end Port_Taken;

   procedure Address_Not_Ours is
      S : Supervisor;
   begin
      S.Run ("--port 0 --bind 203.0.113.7");
      --  an address of documentation networks: no machine's own
      Expect_End (S, 1, End_Limit);
      Check
        (Index (S.Log_Text, "203.0.113.7") > 0,
         "the address is not named: " & S.Log_Text);
   end Address_Not_Ours;

   procedure Address_Malformed is
      S : Supervisor;
   begin
      S.Run ("--port 0 --bind 300.1.2.3");
      Expect_End (S, 1, End_Limit);
      Check
        (Index (S.Log_Text, "300.1.2.3") > 0,
         "the address is not named: " & S.Log_Text);
   end Address_Malformed;

   procedure Admitted_Quickly is
      --  F2: 50 ms. The median must meet it; a single one may be delayed by
      --  other load of the machine.
      Limit  : constant Duration := 0.05;
      Times  : constant := 9;
      S      : Supervisor;
      Within : Natural := 0;
   begin
      Measures_Time;
      S.Start;
      for Attempt in 1 .. Times loop
         declare
            M     : Client;
            Start : constant Instant := Now;
         begin
            M.Connect (S.Port);
            M.Expect ("RPIN", "ANAK", Within => 2.0);
            if Now - Start < Limit then
               Within := Within + 1;
            end if;
            Note ("admitted and answered after "
                  & Milliseconds (Now - Start));
            M.Close;
         end;
         Check
           (S.Says ("session closed", Within => 2.0),
            "the session is not closed");
         while S.Count_Of ("session closed") < Attempt loop
            delay 0.001;
         end loop;
      end loop;
      Check (Within > Times / 2, "most connections took over 50 ms");
   end Admitted_Quickly;

   procedure Burst_Of_10_000 is
      Count : constant := 10_000;
      R     : Rig;
      Text  : Unbounded_String;
      Start : Instant;

      --  The robot is not started, so there are no unsolicited messages. Three
      --  kinds of answers without the robot's help and four with it, in an
      --  order without a short period.

      function Kind (Number : Positive) return Natural is
        ((Number * Number + Number / 7) mod 7);

      function Command (Number : Positive) return String is
        (case Kind (Number) is
            when 0 => "RPIN", when 1 => "RGBT", when 2 => "RGST",
            when 3 => "XYZT", when 4 => "CPCO", when 5 => "RGFW",
            when others => "RLDW");

      function Answer (Number : Positive) return String is
        (case Kind (Number) is
            when 0 => "AACK:", when 1 => "RBLV:2", when 2 => "RCST:0",
            when 3 => "ACER:", when 4 => "ANAK:", when 5 => "ACRJ:",
            when others => "ACRJ:");
   begin
      Assemble (R, Emulator_Options => "--baud 0");
      R.Monitor.Expect ("ROPN", "AACK");
      for Number in 1 .. Count loop
         Append (Text, Command (Number) & ASCII.LF);
      end loop;
      R.Monitor.Skip_To_Now;
      Start := Now;
      R.Monitor.Send (To_String (Text));
      for Number in 1 .. Count loop
         declare
            Item : constant Message := R.Monitor.Next (Within => 10.0);
            Seen : constant String :=
              Item.Label & ":" & To_String (Item.Data);
         begin
            Check
              (Item.Number > 0,
               "no answer to command" & Integer'Image (Number));
            Check
              (Seen = Answer (Number),
               "answer" & Integer'Image (Number) & ", to "
               & Command (Number) & ", is " & Seen & " instead of "
               & Answer (Number));
         end;
      end loop;
      Note ("all answered after " & Milliseconds (Now - Start));
      R.Monitor.Expect_Silence
        ("AACK ANAK ACRJ ATIM ACER RBLV RCST", For_Time => 0.3);
   end Burst_Of_10_000;

   procedure Burst_While_Started is
      --  Movements may be overtaken by stops, so only their number and the
      --  order of their answers are known.
      Count    : constant := 1_000;
      R        : Rig;
      Text     : Unbounded_String;
      Answered : Natural := 0;
   begin
      Assemble (R, Emulator_Options => "--baud 0");
      Start_Robot (R, Watchdog => True);
      for Number in 1 .. Count loop
         Append
           (Text,
            (case Number mod 4 is
                when 0 => "RMOV:10", when 1 => "RTRN:-10",
                when 2 => "RSTP", when others => "RPIN") & ASCII.LF
            & "what" & ASCII.LF);
      end loop;
      R.Monitor.Skip_To_Now;
      R.Monitor.Send (To_String (Text));
      for Number in 1 .. Count loop
         declare
            Item : constant Message := R.Monitor.Next_Answer (10.0);
         begin
            Check
              (Item.Label = "AACK"
               or else (Item.Label = "ACRJ" and then Number mod 4 < 2),
               "order" & Integer'Image (Number) & " answered "
               & Item.Label);
            if Item.Label = "AACK" then
               Answered := Answered + 1;
            end if;
         end;
         Check
           (R.Monitor.Next_Answer (10.0).Label = "ACER",
            "the answers are out of order at" & Integer'Image (Number));
      end loop;
      Check (Answered >= Count / 2, "stops or pings were refused");
      R.Monitor.Expect_Silence
        ("AACK ANAK ACRJ ATIM ACER RCST", For_Time => 0.3);
   end Burst_While_Started;

   procedure Flood_Keeps_Memory is
      --  Rule 2: the number of waiting commands is bounded
      Count    : constant := 40_000;
      R        : Rig;
      Text     : Unbounded_String;
      Before   : Natural;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      R.Emulator.Tell ("delay 60");
      R.Monitor.Expect ("RPIN", "AACK");
      Before := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
      Append (Text, "RPIN" & ASCII.LF);
      for Number in 1 .. Count loop
         Append (Text, "nope" & ASCII.LF);
      end loop;
      R.Monitor.Skip_To_Now;
      R.Monitor.Send (To_String (Text));
      Check
        (R.Monitor.Next (5.0).Label = "AACK",
         "the first command is not answered first");
      for Number in 1 .. Count loop
         Check
           (R.Monitor.Next (10.0).Label = "ACER",
            "no ACER to bad command" & Integer'Image (Number));
      end loop;
      Check
        (Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)
         <= Before + 1024,
         "the flood took more than 1 MB of memory");
   end Flood_Keeps_Memory;

   procedure Crowd_Finds_Room is
      --  Clients to be rejected, as another monitor is in command, wait in the
      --  kernel's queue. If it is full the kernel drops the connection, and
      --  the client retries after 1, 3 and 7 s. If more than a quarter of the
      --  queue of 512 waits, their source is blocked until the first retry.
      Count   : constant := 200;
      Quarter : constant := 128;
      Grant   : constant Duration := 0.5;
      Retry   : constant Duration := 1.0;
      R        : Rig;
      Visitors : array (1 .. Count) of Socket_Type;
      Start    : Instant;
      Took     : Duration;
      Longest  : Duration := 0.0;
      Blocked  : Duration := 0.0;
   begin
      Assemble (R);
      for Number in Visitors'Range loop
         Create_Socket (Visitors (Number));
         Start := Now;
         Connect_Socket
           (Visitors (Number),
            (Family_Inet, Inet_Addr ("127.0.0.1"),
             Port_Type (R.Supervisor.Port)));
         Took := Now - Start;
         if Number <= Quarter then
            Longest := Duration'Max (Longest, Took);
         else
            Blocked := Duration'Max (Blocked, Took);
         end if;
      end loop;
      R.Monitor.Expect ("RPIN", "ANAK");
      for Visitor of Visitors loop
         Close_Socket (Visitor);
      end loop;
      Check_Within (Longest, Grant, "to get into the queue");
      Check_Within (Blocked, Retry + Grant, "to get into it as one of many");
   end Crowd_Finds_Room;

   procedure Streams_Closed is
      --  Started without standard streams, a program is given their numbers
      --  for what it opens first: the log must not go to a monitor
      Count    : constant := 20;
      Launcher : constant String :=
        Programs.Temporary_Folder & "/streams_closed";
      Limit    : constant Instant := Now + 10.0;
      File     : Ada.Text_IO.File_Type;
      First    : Supervisor;
      S        : Supervisor;
      M        : Client;
      Port     : Positive;
   begin
      Ada.Text_IO.Create (File, Ada.Text_IO.Out_File, Launcher);
      Ada.Text_IO.Put_Line (File, "#!/bin/sh");
      Ada.Text_IO.Put_Line (File, "exec ""$@"" <&- >&- 2>&-");
      Ada.Text_IO.Close (File);
      Check (Libc.Chmod (To_C (Launcher), 8#755#) = 0, "chmod");

      --  a port that is free: it cannot say on which it listens
      First.Start;
      Port := First.Port;
      First.Stop;

      S.Run
        ("--bind 127.0.0.1 --log-level debug --port " & Image (Port),
         Launcher);
      loop
         begin
            M.Connect (Port);
            exit;
         exception
            when Failed =>
               if Now > Limit then
                  raise;
               end if;
               delay 0.05;
         end;
      end loop;
      for Number in 1 .. Count loop
         M.Expect ("what", "ACER");
      end loop;
      delay 0.1;
      Check
        (M.Count = Count, "more than the answers:" & M.Count'Image);
      S.Send_Signal (Libc.Sigterm);
      Expect_End (S, 0, Within => End_Limit);
   end Streams_Closed;

   procedure Options_Bad is

      procedure Refuse (Options : String);

      procedure Refuse (Options : String) is
         S : Supervisor;
      begin
         S.Run (Options);
         Expect_End (S, 2, End_Limit);
         Check
           (Index (S.Log_Text, "--port") > 0
            and then Index (S.Log_Text, "--serial") > 0,
            "no usage on standard error for " & Options & ": "
            & S.Log_Text);
      end Refuse;

   begin
      Refuse ("--nonsense");
      Refuse ("stray");
      Refuse ("--port");
      Refuse ("--port 65536");
      Refuse ("--port -1");
      Refuse ("--port five");
      Refuse ("--port 99999999999999999999");
      Refuse ("--allow 10.0.0");
      Refuse ("--token");
      Refuse ("--frame-size 640");
      Refuse ("--frame-size 0x0");
      Refuse ("--frame-size 640x480x2");
      Refuse ("--fps 0");
      Refuse ("--jpeg-quality 101");
      Refuse ("--marker square");
      Refuse ("--message-gap -1");
      Refuse ("--log-level loud");
      Refuse ("--cpu none");
   end Options_Bad;

   procedure Options_Help is
      S : Supervisor;
   begin
      S.Run ("--help");
      Expect_End (S, 0, End_Limit);
      declare
         Text : constant String := S.Output_Text;

         procedure Expect (Option : String);

         procedure Expect (Option : String) is
         begin
            Check
              (Index (Text, Option) > 0, "--help does not tell " & Option);
         end Expect;
      begin
         Expect ("--port");
         Expect ("--bind");
         Expect ("--allow");
         Expect ("--token");
         Expect ("--serial");
         Expect ("--camera");
         Expect ("--frame-size");
         Expect ("--fps");
         Expect ("--jpeg-quality");
         Expect ("--marker");
         Expect ("--draw");
         Expect ("--message-gap");
         Expect ("--cpu");
         Expect ("--log-level");
         Expect ("--check");
         Expect ("--version");
         Expect ("5544");
      end;
   end Options_Help;

   procedure Options_Version is
      S : Supervisor;
   begin
      S.Run ("--version");
      Expect_End (S, 0, End_Limit);
      Check
        (Index (S.Output_Text, "destijl") > 0
         and then Index (S.Output_Text, ".") > 0,
         "no version in: " & S.Output_Text);
   end Options_Version;

   procedure Not_Heard is

      procedure Expect
        (Program : String; Status : Integer; Option, Outputs : String);
      --  With a shell's redirections

      procedure Expect_Of (Program : String);

      procedure Expect
        (Program : String; Status : Integer; Option, Outputs : String)
      is
         E    : Child;
         Line : Arguments := Words ("-c");
         Got  : Integer;
      begin
         Line.Append ("exec ""$0"" " & Option & " " & Outputs);
         Line.Append (Program);
         E.Start ("/bin/sh", Line);
         Got := E.Exit_Status (Within => End_Limit);
         Check
           (Got = Status,
            Program & " " & Option & " " & Outputs
            & ": exit status" & Got'Image);
      end Expect;

      procedure Expect_Of (Program : String) is
      begin
         Expect (Program, 1, "--help", ">/dev/full");
         Expect (Program, 1, "--version", ">/dev/full");
         Expect (Program, 2, "--no-such-option", "2>/dev/full");
      end Expect_Of;

   begin
      Expect_Of (Programs.Supervisor);
      Expect_Of (Programs.Monitor);
      Expect_Of (Programs.Emulator);
      Expect (Programs.Emulator, 1, "--help", ">&-");
      Expect
        (Programs.Emulator, 1, "--link /dev/null/robot", "2>/dev/full");
   end Not_Heard;

   procedure Check_All_Well is
      R    : Rig;
      S    : Supervisor;
      Text : Unbounded_String;
   begin
      R.Emulator.Start (Camera => True);
      S.Run
        ("--check --port 0 --bind 127.0.0.1 --serial " & R.Emulator.Device
         & " --camera " & R.Emulator.Camera_Url);
      declare
         Status : constant Integer := S.Exit_Status (Within => 15.0);
      begin
         delay 0.05;
         Text := To_Unbounded_String
           (To_Lower (S.Output_Text & S.Log_Text));
         if Integer (Libc.Geteuid) = 0 then
            Check (Status = 0, "not all is well: " & To_String (Text));
         else
            Check
              (Status in 0 | 1,
               "exit status" & Integer'Image (Status));
         end if;
      end;
      for Word of Words ("priorit ceiling serial camera port") loop
         Check
           (Index (Text, Word) > 0,
            "--check says nothing on " & Word & ": " & To_String (Text));
      end loop;
   end Check_All_Well;

   procedure Check_Nothing_Well is
      Taken : Supervisor;
      S     : Supervisor;
   begin
      Taken.Start;
      S.Run
        ("--check --bind 127.0.0.1 --port " & Image (Taken.Port)
         & " --serial /dev/no_such_line --camera /no/such/camera");
      Expect_End (S, 1, Within => 15.0);
      declare
         Text : constant String := S.Output_Text & S.Log_Text;
      begin
         Check
           (Index (Text, "/dev/no_such_line") > 0,
            "the serial line is not named: " & Text);
         Check
           (Index (Text, "/no/such/camera") > 0,
            "the camera is not named: " & Text);
         Check
           (Index (Text, Image (Taken.Port)) > 0,
            "the port is not named: " & Text);
      end;
   end Check_Nothing_Well;

   procedure Log_Levels is

      function Log_Length (Level : String) return Natural;

      function Log_Length (Level : String) return Natural is
         R : Rig;
      begin
         Assemble (R, Supervisor_Options => "--log-level " & Level);
         Start_Robot (R);
         R.Monitor.Expect ("RGFW", "AACK");
         R.Monitor.Expect ("RCLS", "AACK");
         delay 0.1;
         return R.Supervisor.Log_Length;
      end Log_Length;

      Info  : constant Natural := Log_Length ("info");
      Debug : constant Natural := Log_Length ("debug");
   begin
      Check
        (Debug > Info,
         "debug logs" & Debug'Image & " lines, info" & Info'Image);
   end Log_Levels;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "F01_Listens_And_Says_So", Listens'Access);
      Add (Suite, "F01_Port_Taken", Port_Taken'Access);
      Add (Suite, "F01_Address_Not_Ours", Address_Not_Ours'Access);
      Add (Suite, "F01_Address_Malformed", Address_Malformed'Access);
      Add (Suite, "F02_Connection_Admitted_Quickly",
           Admitted_Quickly'Access);
      Add (Suite, "F02_Crowd_Finds_Room_To_Wait", Crowd_Finds_Room'Access);
      Add (Suite, "F03_Burst_Of_10_000_Commands", Burst_Of_10_000'Access);
      Add (Suite, "F03_Burst_While_Started", Burst_While_Started'Access);
      Add (Suite, "F03_Rule_2_Flood_Keeps_Memory",
           Flood_Keeps_Memory'Access);
      Add (Suite, "Never_Logs_To_A_Monitor", Streams_Closed'Access);
      Add (Suite, "Options_Bad", Options_Bad'Access);
      Add (Suite, "Options_Help", Options_Help'Access);
      Add (Suite, "Options_Version", Options_Version'Access);
      Add (Suite, "Options_Not_Heard", Not_Heard'Access);
      Add (Suite, "Options_Log_Levels", Log_Levels'Access);
      Add (Suite, "Check_All_Well", Check_All_Well'Access);
      Add (Suite, "Check_Nothing_Well", Check_Nothing_Well'Access);
   end Add_To;

end Server_Tests;
