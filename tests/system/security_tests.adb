--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission: addresses, tokens, and that no token gets into the log.

with Ada.Directories;
with Ada.Streams.Stream_IO; use Ada.Streams;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Floods;
with Host_Time;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;
with System.Multiprocessors;

package body Security_Tests is

   use type GNAT.OS_Lib.String_Access;

   LF : constant Character := ASCII.LF;
   CR : constant Character := ASCII.CR;

   Token : constant String := "correct-horse-battery";

   Good_Line : constant String := "AUTH:" & Token & LF;

   Token_Time : constant Duration := 2.0;
   --  for the first line

   At_Once : constant Duration := 1.0;
   --  on a shared machine: half of Token_Time

   Admission_Time  : constant Duration := 2.0;
   Same_Address_Time : constant Duration := 5.0;
   --  for a monitor with the right token, during a flood from other addresses,
   --  and from the flood's own address after its end

   Another_Address : constant String := "127.0.0.2";

   Not_Authenticated : constant String := "not authenticated";
   Not_Allowed       : constant String := "this address is not allowed";
   Not_Alone         : constant String := "another monitor is connected";

   function Median_Answer (R : in out Rig) return Duration;
   --  From an order to its answer

   function Time_To_Admission
     (S : Supervisor; M : in out Client; Own : String) return Duration;
   --  Of M with the right token from its address Own. Time stolen by the host
   --  of the machine is subtracted

   type Client_Array is array (Positive range <>) of Client;

   procedure Allowed_Addresses;
   procedure Allowed_While_In_Command;
   procedure Allowed_And_IPv6;
   procedure Allowed_Wrongly;
   procedure Token_Right;
   procedure Token_With_Commands;
   procedure Token_In_Pieces;
   procedure Token_Wrong;
   procedure Token_Late;
   procedure Eight_Silent;
   procedure Disturbs_Nobody;
   procedure Flood_Of_Newcomers;
   procedure Crowd_Keeps_Nobody_Out;
   procedure Flood_Without_End;
   procedure Lines_Bit_By_Bit;
   procedure Waits_For_The_End;
   procedure Bad_Token_Files;
   procedure Unreadable_Token_File;
   procedure Secret_Not_Logged;
   procedure Line_Without_Token_Option;
   procedure Console_Monitor;

   function Token_File
     (Text : String := Token & LF;
      Mode : unsigned := 8#600#;
      Name : String := "token") return String;
   --  Its path

   procedure Expect_Refused
     (M      : in out Client;
      Reason : String;
      After  : Duration := 0.0;
      Within : Duration := At_Once);
   --  It gets the message and is closed, between After and Within

   procedure Expect_Admitted (M : in out Client);

   procedure Expect_Warnings
     (S : Supervisor; Pattern : String; Count : Natural);
   --  So many lines of the log, all of them warnings

   procedure Expect_Start_Refused
     (Options  : String;
      Status   : Integer;
      Reason   : String;
      Launcher : String := "";
      Program  : String := "");

   procedure Allowed_Addresses is
      S       : Supervisor;
      Refused : Natural := 0;

      procedure Admit (Source : String);
      procedure Refuse (Source : String);

      procedure Admit (Source : String) is
         Mark : constant Natural := S.Log_Length;
      begin
         declare
            M : Client;
         begin
            M.Connect (S.Port, Source => Source);
            Expect_Admitted (M);
         end;
         --  the next one would be a second monitor before
         S.Expect_Log ("session closed", Within => 4.0, After => Mark);
      end Admit;

      procedure Refuse (Source : String) is
         M    : Client;
         Seen : constant Natural := S.Log_Length;
      begin
         M.Connect (S.Port, Source => Source);
         Expect_Refused (M, Not_Allowed);
         S.Expect_Log
           ("refused, its address is not allowed: " & Source & ":",
            Within => 2.0, After => Seen);
         Refused := Refused + 1;
         Expect_Warnings (S, "not allowed", Refused);
      end Refuse;

   begin
      S.Start ("--allow 127.0.0.2/31 --allow=127.0.0.8 --allow 127.1.0.0/16");
      Refuse ("127.0.0.1");
      Admit ("127.0.0.2");
      Admit ("127.0.0.3");
      Refuse ("127.0.0.4");
      Refuse ("127.0.0.7");
      Admit ("127.0.0.8");
      Refuse ("127.0.0.9");
      Refuse ("127.0.255.255");
      Admit ("127.1.0.0");
      Admit ("127.1.255.254");
      Refuse ("127.2.0.0");
   end Allowed_Addresses;

   procedure Allowed_And_IPv6 is

      procedure Connect
        (S : Supervisor; M : in out Client; Address : String);
      --  Or skips the test where this machine has no IPv6

      procedure Connect
        (S : Supervisor; M : in out Client; Address : String) is
      begin
         M.Connect (S.Port, Address => Address);
      exception
         when Failed =>
            Skip ("no " & Address & " here");
      end Connect;

      Open, Closed : Supervisor;
      M            : Client;
   begin
      begin
         Open.Start (Bind => "::");
      exception
         when Failed =>
            Skip ("no IPv6 here");
      end;
      Connect (Open, M, "::1");
      Expect_Admitted (M);

      --  all of IPv4, also through an IPv6 socket
      Closed.Start ("--allow 0.0.0.0/0", Bind => "::");
      Connect (Closed, M, "::1");
      Expect_Refused (M, Not_Allowed);
      Connect (Closed, M, "127.0.0.1");
      Expect_Admitted (M);
   end Allowed_And_IPv6;

   procedure Allowed_While_In_Command is
      --  A disallowed client gets that message and no other
      S           : Supervisor;
      First, M, N : Client;
   begin
      S.Start ("--allow 127.0.0.2");
      First.Connect (S.Port, Source => "127.0.0.2");
      Expect_Admitted (First);
      M.Connect (S.Port);
      Expect_Refused (M, Not_Allowed);
      N.Connect (S.Port, Source => "127.0.0.2");
      Expect_Refused (N, Not_Alone);
      Expect_Admitted (First);
   end Allowed_While_In_Command;

   procedure Allowed_Wrongly is
      Eight : constant String :=
        "--allow 10.0.0.1 --allow 10.0.0.2 --allow 10.0.0.3"
        & " --allow 10.0.0.4 --allow 10.0.0.5 --allow 10.0.0.6"
        & " --allow 10.0.0.7";
      S     : Supervisor;
      M     : Client;
   begin
      Expect_Start_Refused ("--allow 127.0.0.1/8", 2, "bits set beyond");
      Expect_Start_Refused ("--allow 127.0.0.1/33", 2, "0 .. 32");
      Expect_Start_Refused ("--allow localhost", 2, "no IPv4 network");
      Expect_Start_Refused ("--allow ::1", 2, "no IPv4 network");
      Expect_Start_Refused
        (Eight & " --allow 127.0.0.1 --allow 127.0.0.2", 2,
         "more than 8 networks");
      S.Start (Eight & " --allow 127.0.0.1");
      M.Connect (S.Port);
      Expect_Admitted (M);
   end Allowed_Wrongly;

   procedure Bad_Token_Files is
      No_Token  : constant String := "its first line is no token";
      Not_Alone : constant String := "others than its owner";

      procedure Refuse (Path : String; Reason : String);
      procedure Report (Path : String; Reason : String);
      --  The same for --check, which also tries the camera, so it is slow

      procedure Refuse (Path : String; Reason : String) is
      begin
         Expect_Start_Refused
           ("--port 0 --token " & Path, 1, Path & ": " & Reason);
      end Refuse;

      procedure Report (Path : String; Reason : String) is
      begin
         Expect_Start_Refused
           ("--check --port 0 --token " & Path, 1,
            "not ok  token file " & Path & ": " & Reason);
      end Report;

      S : Supervisor;
   begin
      Refuse (Programs.Temporary_Folder & "/no_such_file", "No such file");
      Refuse (Programs.Temporary_Folder, "Is a directory");
      Refuse (Token_File (Mode => 8#660#), Not_Alone);
      Refuse (Token_File (Mode => 8#620#), Not_Alone);
      Refuse (Token_File (Mode => 8#604#), Not_Alone);
      Refuse (Token_File (Mode => 8#602#), Not_Alone);
      Refuse (Token_File (""), No_Token);
      Refuse (Token_File ("1234567" & LF), No_Token);
      Refuse (Token_File ((1 .. 5_000 => 'x')), No_Token);
      Refuse (Token_File (Token & CR & LF), No_Token);
      Report (Programs.Temporary_Folder & "/no_such_file", "No such file");
      Report (Token_File (Mode => 8#604#), Not_Alone);
      Report (Token_File (""), No_Token);
      S.Run ("--port 0 --check --token " & Token_File (Mode => 8#400#));
      Check (S.Exit_Status (Within => 15.0) in 0 | 1, "--check");
      delay 0.05;
      Check
        (Index (S.Output_Text, "ok      token file " & Token_File) > 0,
         "a good token file is not reported: " & S.Output_Text);
      Check
        (Index (S.Output_Text & S.Log_Text, Token) = 0,
         "the token is on the console");
   end Bad_Token_Files;

   procedure Console_Monitor is
      R    : Rig;
      Tool : Child;

      function Status (Path : String) return Integer;

      function Status (Path : String) return Integer is
      begin
         Tool.Start
           (Programs.Monitor,
            Words ("--port" & Positive'Image (R.Supervisor.Port)
              & " --script -" & (if Path = "" then "" else " --token ")
              & Path),
            "console monitor");
         Tool.Put_Line ("RPIN");
         Tool.Close_Input;
         return Tool.Exit_Status (Within => 10.0);
      end Status;

   begin
      Assemble
        (R, Supervisor_Options => "--token " & Token_File,
         Connected => False);
      Check (Status (Token_File (Name => "copy")) = 0, "with its token");
      Check
        (Tool.Awaited (Output, Token, 0.0) = 0
         and then Tool.Awaited (Errors, Token, 0.0) = 0,
         "the console monitor shows the token");
      Check
        (Status (Token_File ("another-token" & LF, Name => "other")) = 1,
         "with another token");
      Check (Status ("") = 1, "without one");
      Check (Status ("/no/such/file") = 2, "without its file");
   end Console_Monitor;

   procedure Crowd_Keeps_Nobody_Out is
      --  With as many connections in front as the kernel's queue holds

      procedure Measure;

      procedure Measure is
         S     : Supervisor;
         Slow  : Floods.Flood;
         Crowd : Floods.Crowd (1_100);
         M     : Client;
         Taken : Duration;
      begin
         S.Start ("--token " & Token_File);
         Slow.Start (S.Port, Floods.Slow);
         delay 0.1;
         Crowd.Come (S.Port, Floods.Address (1));
         Taken := Time_To_Admission (S, M, Another_Address);
         Note ("admitted after " & Milliseconds (Taken));
         Check_Within (Taken, Admission_Time, "its admission");
         M.Close;
         Crowd.Go;
         Crowd.Come (S.Port, Floods.Address (1));
         Slow.Stop;
         Taken := Time_To_Admission (S, M, Floods.Address (1));
         Note ("from the crowd's own address after " & Milliseconds (Taken));
         Check_Within (Taken, Same_Address_Time, "its admission");
      end Measure;

   begin
      Measure_Calmly (Measure'Access);
   end Crowd_Keeps_Nobody_Out;

   procedure Disturbs_Nobody is
      R       : Rig;
      Silent  : Client_Array (1 .. 8);
      Wrong   : Client;
      Right   : Client;
      Slowest : Duration := 0.0;
   begin
      Assemble
        (R, Supervisor_Options => "--token " & Token_File,
         Connected => False);
      Connect (R);
      R.Monitor.Send (Good_Line);
      Move_Forward (R);
      for M of Silent loop
         M.Connect (R.Supervisor.Port, Real_Time => False);
         M.Send ("AUTH:");
      end loop;
      for Turn in 1 .. 40 loop
         declare
            Start : constant Instant := Now;
         begin
            R.Monitor.Expect ("what", "ACER");
            Slowest := Duration'Max (Slowest, Now - Start);
         end;
         if Turn mod 8 = 0 then
            Wrong.Connect (R.Supervisor.Port, Real_Time => False);
            Wrong.Send ("AUTH:nonsense" & LF);
         end if;
         delay 0.05;
      end loop;
      Note ("slowest answer " & Milliseconds (Slowest));
      for M of Silent loop
         Expect_Refused (M, Not_Authenticated, Within => Token_Time + 1.0);
      end loop;
      Right.Connect (R.Supervisor.Port);
      Right.Send (Good_Line);
      Expect_Refused (Right, Not_Alone, Within => Token_Time + 1.0);
      Check
        (R.Emulator.Count_Of ("M=0") = 0, "the robot was stopped meanwhile");
      R.Monitor.Expect ("RSTP", "AACK");
      Check
        (R.Monitor.Closed_By_Peer (0.0) = Monitor_Clients.Open,
         "the one in command has lost its connection");
   end Disturbs_Nobody;

   procedure Eight_Silent is
      --  The limit per address is reached: the connection that has waited
      --  longest is removed
      S      : Supervisor;
      Silent : Client_Array (1 .. 8);
      Last   : Client;
      Good   : Client;
      Start  : Instant;
   begin
      S.Start ("--token " & Token_File);
      for M of Silent loop
         M.Connect (S.Port, Real_Time => False);
      end loop;
      delay 0.1;
      Start := Now;
      Last.Connect (S.Port);
      Expect_Refused (Silent (1), Not_Authenticated);
      Good.Connect (S.Port);
      Good.Send (Good_Line);
      Good.Expect ("RPIN", "ANAK", Within => At_Once);
      Note ("admitted after " & Milliseconds (Now - Start));
      Check (Now - Start < Token_Time / 2, "no room was made");
      for M of Silent (2 .. 8) loop
         Expect_Refused (M, Not_Authenticated, Within => Token_Time);
      end loop;
      Expect_Refused (Last, Not_Authenticated, Within => Token_Time);
      Expect_Warnings (S, Not_Authenticated, 9);
   end Eight_Silent;

   procedure Expect_Admitted (M : in out Client) is
   begin
      M.Expect ("RPIN", "ANAK");
   end Expect_Admitted;

   procedure Expect_Refused
     (M      : in out Client;
      Reason : String;
      After  : Duration := 0.0;
      Within : Duration := At_Once)
   is
      Start : constant Instant := Now;
      Item  : constant Message := M.Next (Within);
      Taken : constant Duration := Now - Start;
   begin
      Check
        (Item.Number > 0, "not refused within " & Milliseconds (Within));
      Check
        (Item.Label = "MSSG" and then Item.Data = "refused: " & Reason,
         "instead of a refusal: " & Item.Label & ":"
         & To_String (Item.Data));
      Check
        (Taken >= After, "refused after " & Milliseconds (Taken) & " already");
      Check
        (M.Closed_By_Peer (At_Once) /= Monitor_Clients.Open,
         "refused, and still connected");
      Check (M.Count = 1, "more than a refusal");
   end Expect_Refused;

   procedure Expect_Start_Refused
     (Options  : String;
      Status   : Integer;
      Reason   : String;
      Launcher : String := "";
      Program  : String := "")
   is
      S    : Supervisor;
      Seen : Integer;
   begin
      S.Run (Options, Launcher, Program);
      Seen := S.Exit_Status (Within => 15.0);
      delay 0.05;
      declare
         Text : constant String := S.Log_Text & S.Output_Text;
      begin
         Check
           (Seen = Status,
            Options & ": exit status" & Seen'Image & ": " & Text);
         Check
           (Index (Text, Reason) > 0,
            Options & ": not said why (" & Reason & "): " & Text);
         Check
           (Index (Text, "listening on") = 0, "it says that it listens");
      end;
   end Expect_Start_Refused;

   procedure Expect_Warnings
     (S : Supervisor; Pattern : String; Count : Natural)
   is
      Deadline : constant Instant := Now + 2.0;
   begin
      while S.Count_Of (Pattern) < Count and then Now < Deadline loop
         delay 0.01;
      end loop;
      delay 0.05;
      Check
        (S.Count_Of (Pattern) = Count,
         "not" & Count'Image & " lines with """ & Pattern & """: "
         & S.Log_Text);
      --  its lines are "[0.123] warning: ..."
      declare
         Log   : constant String := S.Log_Text;
         Place : Natural := Index (Log, Pattern);
      begin
         while Place > 0 loop
            Check
              (Index
                 (Log
                    (Index (Log (1 .. Place), "[", Going => Backward)
                     .. Place),
                  "warning: ") > 0,
               "not a warning in: " & Log);
            Place := Index
              (Log (Place + 1 .. Log'Last), Pattern);
         end loop;
      end;
   end Expect_Warnings;

   procedure Flood_Of_Newcomers is
      --  New connections have priority over the orders of the monitor in
      --  command (th_server is above th_move), but a bounded share
      use type System.Multiprocessors.CPU;

      Interval : constant Duration := 0.01;
      --  minimum time between two turns that handle them
      Per_Turn : constant := 10;
      --  number per turn
      Grant    : constant Duration := 0.005;
      --  margin on a shared machine

      R     : Rig;
      Crowd : Floods.Flood;

      Quiet, Amid : Duration;
      Start       : Instant;
      Served      : Natural;
   begin
      Measures_Time;
      Assemble
        (R,
         Supervisor_Options =>
           (if System.Multiprocessors.Number_Of_CPUs > 1 then "--cpu 0"
            else ""));
      Move_Forward (R);
      Quiet := Median_Answer (R);
      Start := Now;
      Crowd.Start (R.Supervisor.Port);
      delay 0.1;
      Amid := Median_Answer (R);
      Served := Crowd.Served;
      Note
        ("order to answer " & Milliseconds (Quiet) & ", amid the flood "
         & Milliseconds (Amid) & "," & Served'Image & " served in "
         & Milliseconds (Now - Start));
      Check
        (Served <= Per_Turn * (Natural ((Now - Start) / Interval) + 1),
         "more newcomers are seen to than" & Per_Turn'Image & " in "
         & Milliseconds (Interval));
      Check
        (Served >= Per_Turn * Natural ((Now - Start) / Interval) / 20,
         "hardly any newcomer is seen to");
      Check
        (Amid <= 2 * Quiet + Grant, "orders wait for newcomers");
      --  the end of a session is handled nevertheless
      R.Monitor.Close;
      R.Supervisor.Expect_Log ("session closed", Within => At_Once);
      Crowd.Stop;
   end Flood_Of_Newcomers;

   procedure Flood_Without_End is
      --  Clients that reconnect as fast as possible fill the kernel's queue,
      --  but block neither the monitor in command nor the next one

      procedure Measure;

      procedure Measure is
         R     : Rig;
         Flood : Floods.Flood;
         Next  : Client;
         Quiet : Duration;
         Amid  : Duration;
         Taken : Duration;
      begin
         Assemble
           (R, Supervisor_Options => "--token " & Token_File,
            Connected => False);
         Connect (R);
         R.Monitor.Send (Good_Line);
         Move_Forward (R);
         Quiet := Median_Answer (R);
         Flood.Start (R.Supervisor.Port, Floods.Restless);
         delay 0.1;
         Amid := Median_Answer (R);
         Note
           ("order to answer " & Milliseconds (Quiet) & ", amid the flood "
            & Milliseconds (Amid));
         R.Monitor.Close;
         for Attempt in 1 .. 3 loop
            Taken := Time_To_Admission
              (R.Supervisor, Next, Another_Address);
            Note ("admitted after " & Milliseconds (Taken));
            Check_Within (Taken, Admission_Time, "its admission");
            Next.Close;
         end loop;
         Flood.Stop;
         Taken := Time_To_Admission
           (R.Supervisor, Next, Floods.Address (1));
         Note
           ("from the flood's own address after " & Milliseconds (Taken));
         Check_Within (Taken, Same_Address_Time, "its admission");
         Check (Amid <= 2 * Quiet + 0.005, "orders wait for newcomers");
      end Measure;

   begin
      Measure_Calmly (Measure'Access);
   end Flood_Without_End;

   procedure Lines_Bit_By_Bit is
      --  Clients that send their lines in many pieces do not block one that
      --  sends its line at once
      Between : constant Duration := 0.05;
      --  seven pieces, each of which takes 10 ms

      procedure Measure;

      procedure Measure is
         S      : Supervisor;
         M      : Client;
         Slow   : Client_Array (1 .. 7);
         Start  : Instant := Never;
         Unused : Boolean;
      begin
         S.Start ("--token " & Token_File);
         M.Connect (S.Port);
         delay 0.1;
         for Other of Slow loop
            Other.Connect (S.Port, Real_Time => False);
         end loop;
         delay 0.2;
         for Piece in 1 .. 25 loop
            for Other of Slow loop
               Unused := Other.Try_Send ("A");
            end loop;
            if Piece = 3 then
               Start := Now;
               M.Send (Good_Line & "RPIN" & LF);
            end if;
            delay Between;
            exit when M.Count > 0;
         end loop;
         Check (M.Next (At_Once).Label = "ANAK", "not admitted");
         Note ("admitted after " & Milliseconds (Now - Start));
         Check_Within (Now - Start, 0.3, "its admission");
      end Measure;

   begin
      Measure_Calmly (Measure'Access);
   end Lines_Bit_By_Bit;

   function Median_Answer (R : in out Rig) return Duration is
      Rounds  : constant := 100;
      Between : constant Duration := 0.02;
      Taken   : Samples.Set;
      Start   : Instant;
      Late    : Natural := 0;
   begin
      for Round in 1 .. Rounds loop
         Start := Now;
         if R.Monitor.Ask ("RGFW").Label = "ATIM" then
            Late := Late + 1;
         end if;
         Taken.Add (Now - Start);
         delay Between;
      end loop;
      --  on a loaded machine the emulated robot is sometimes late
      Check (Late < Rounds / 4, Late'Image & " orders without an answer");
      return Taken.Quantile (0.5);
   end Median_Answer;

   procedure Line_Without_Token_Option is
      --  A monitor with a token at a supervisor without
      S : Supervisor;
      M : Client;
   begin
      S.Start ("--log-level debug");
      M.Connect (S.Port);
      M.Expect ("AUTH:" & Token, "ACER");
      Expect_Admitted (M);
      S.Expect_Log ("not understood: AUTH:...", Within => 2.0);
      S.Expect_Log ("received AUTH:...", Within => 2.0);
      Check
        (Index (S.Log_Text, Token) = 0, "the token is in: " & S.Log_Text);
   end Line_Without_Token_Option;

   procedure Secret_Not_Logged is
      S : Supervisor;
      M : Client;

      procedure Try (Text : String; Admitted : Boolean);

      procedure Try (Text : String; Admitted : Boolean) is
         Seen : constant Natural := S.Count_Of ("session closed");
         Last : Message;
         pragma Unreferenced (Last);
      begin
         M.Connect (S.Port);
         M.Send (Text & "RPIN" & LF);
         if Admitted then
            Last := M.Next_Of ("ANAK", Within => 3.0);
            M.Close;
            while S.Count_Of ("session closed") = Seen loop
               delay 0.01;
            end loop;
         else
            Expect_Refused (M, Not_Authenticated);
         end if;
      end Try;

   begin
      S.Start ("--log-level debug --token " & Token_File);
      Try (Good_Line, True);
      Try (Good_Line & Good_Line, True);
      Try (Good_Line & "what" & LF & Good_Line & Good_Line, True);
      Try (Good_Line & "x" & Good_Line, True);
      Try (Good_Line & "MSSG:" & Good_Line, True);
      Try (Good_Line & "RMOV:AUTH:" & Token & "AUTH:" & Token & LF, True);
      Try ("AUTH:" & Token & "x" & LF, False);
      Try ("AUTH:x" & Token & LF, False);
      Try ("AUTH: " & Token & LF, False);
      Try ("auth:" & Token & LF, False);
      Try (Token & LF, False);
      Try ("RPIN" & LF & Good_Line, False);
      S.Send_Signal (Libc.Sigterm);
      Check (S.Exit_Status (Within => 3.0) = 0, "no orderly stop");
      delay 0.05;
      Check
        (S.Says ("not understood: AUTH:..."),
         "the log does not say that the line came: " & S.Log_Text);
      Check
        (Index (S.Log_Text & S.Output_Text, Token) = 0,
         "the token is in the log: " & S.Log_Text);
      Expect_Warnings (S, Not_Authenticated, 6);
   end Secret_Not_Logged;

   function Time_To_Admission
     (S : Supervisor; M : in out Client; Own : String) return Duration
   is
      Patience : constant Duration := 20.0;
      Start    : constant Instant  := Now;
      Host     : constant Duration := Host_Time.Taken;
   begin
      M.Connect (S.Port, Source => Own);
      M.Send (Good_Line & "RPIN" & LF);
      Check (M.Next (Patience).Label = "ANAK", "not admitted");
      return Now - Start - (Host_Time.Taken - Host);
   end Time_To_Admission;

   function Token_File
     (Text : String := Token & LF;
      Mode : unsigned := 8#600#;
      Name : String := "token") return String
   is
      Path : constant String := Programs.Temporary_Folder & "/" & Name;
      File : Stream_IO.File_Type;
   begin
      Stream_IO.Create (File, Stream_IO.Out_File, Path);
      String'Write (Stream_IO.Stream (File), Text);
      Stream_IO.Close (File);
      Check (Libc.Chmod (To_C (Path), Mode) = 0, "chmod of " & Path);
      return Path;
   end Token_File;

   procedure Token_In_Pieces is
      S : Supervisor;

      procedure Try (Text : String; Size : Positive);
      --  In pieces of Size

      procedure Try (Text : String; Size : Positive) is
         M    : Client;
         Seen : constant Natural := S.Count_Of ("session closed");
         Next : Positive := Text'First;
      begin
         M.Connect (S.Port);
         while Next <= Text'Last loop
            M.Send (Text (Next .. Natural'Min (Next + Size - 1, Text'Last)));
            Next := Next + Size;
            delay 0.01;
         end loop;
         Check (M.Next (At_Once).Label = "ANAK", "the command behind it");
         Expect_Admitted (M);
         Check (M.Count = 2, "an answer too many");
         M.Close;
         while S.Count_Of ("session closed") = Seen loop
            delay 0.01;
         end loop;
      end Try;

   begin
      S.Start ("--token " & Token_File);
      Try (Good_Line & "RPIN" & LF, 1);
      Try (Good_Line & "RPIN" & LF, 7);
      Try (Good_Line & "RPIN" & LF, Good_Line'Length - 1);
      Try (Good_Line & "RPIN" & LF, Good_Line'Length + 2);
      Try ("AUTH:" & Token & CR & LF & "RPIN" & CR & LF,
           Good_Line'Length);
   end Token_In_Pieces;

   procedure Token_Late is
      S      : Supervisor;
      Silent : Client;
      Slow   : Client;
      Good   : Client;
      Start  : Instant;
   begin
      S.Start ("--token " & Token_File);
      Silent.Connect (S.Port);
      Expect_Refused
        (Silent, Not_Authenticated, After => Token_Time - 0.2,
         Within => Token_Time + At_Once);

      --  each has its own time limit, not prolonged by any piece of a line or
      --  other event
      Slow.Connect (S.Port);
      Start := Now;
      for Place in 1 .. 12 loop
         Slow.Send ((1 => Good_Line (Place)));
         if Place = 6 then
            Good.Connect (S.Port);
            Good.Send (Good_Line);
            Expect_Admitted (Good);
         end if;
         delay 0.15;
      end loop;
      Expect_Refused
        (Slow, Not_Authenticated, Within => 2.0 * Token_Time);
      Check
        (Now - Start in Token_Time - 0.2 .. Token_Time + At_Once,
         "refused after " & Milliseconds (Now - Start));
      Expect_Admitted (Good);
      Expect_Warnings (S, Not_Authenticated, 2);
   end Token_Late;

   procedure Token_Right is

      procedure Try (Of_Token : String; Ending : String);

      procedure Try (Of_Token : String; Ending : String) is
         S           : Supervisor;
         First, Next : Client;
      begin
         S.Start ("--token " & Token_File (Of_Token));
         First.Connect (S.Port);
         First.Send ("AUTH:" & Of_Token & Ending);
         Expect_Admitted (First);
         Check (First.Count = 1, "the first line was answered");
         Next.Connect (S.Port);
         Next.Send ("AUTH:" & Of_Token & Ending);
         Expect_Refused (Next, Not_Alone);
         Expect_Admitted (First);
      end Try;

   begin
      Try (Token, (1 => LF));
      Try (Token, CR & LF);
      Try ("!~34567~", (1 => LF));
      Try ((1 .. 128 => 'x'), (1 => LF));
      Try ((1 .. 128 => 'x'), CR & LF);
   end Token_Right;

   procedure Token_With_Commands is
      --  Data after it in the same segment is not lost
      Count : constant := 500;
      S     : Supervisor;
      M     : Client;
      Text  : Unbounded_String := To_Unbounded_String (Good_Line);
   begin
      S.Start ("--token " & Token_File);
      for Turn in 1 .. Count loop
         Append (Text, "RPIN" & LF & "what" & LF);
      end loop;
      M.Connect (S.Port);
      M.Send (To_String (Text));
      for Turn in 1 .. Count loop
         Check (M.Next (5.0).Label = "ANAK", "RPIN" & Turn'Image);
         Check (M.Next (5.0).Label = "ACER", "what" & Turn'Image);
      end loop;
      Expect_Admitted (M);
      Check (M.Count = 2 * Count + 1, "answers too many");
   end Token_With_Commands;

   procedure Token_Wrong is
      S     : Supervisor;
      Count : Natural := 0;

      procedure Refuse (Text : String);

      procedure Refuse (Text : String) is
         M : Client;
      begin
         M.Connect (S.Port);
         M.Send (Text);
         Expect_Refused (M, Not_Authenticated);
         Count := Count + 1;
      end Refuse;

      Gone : Client;
   begin
      S.Start ("--token " & Token_File);
      Refuse ("RPIN" & LF);
      Refuse ((1 => LF));
      Refuse ("AUTH" & LF);
      Refuse ("AUTH:" & LF);
      Refuse ("AUTH:correct-horse-batterz" & LF);
      Refuse ("AUTH:Correct-horse-battery" & LF);
      Refuse ("AUTH:" & Token & "x" & LF);
      Refuse ("AUTH:" & Token & " " & LF);
      Refuse ("AUTH:correct-horse-batter" & LF);
      Refuse ("AUTH: " & Token & LF);
      Refuse (" AUTH:" & Token & LF);
      Refuse ("auth:" & Token & LF);
      Refuse ("AUTH:" & Token & CR & CR & LF);
      Refuse ("AUTH:" & Token & ASCII.NUL & LF);
      Refuse ((1 .. 135 => ASCII.NUL));
      Refuse ("AUTH:" & String'(1 .. 130 => 'x'));
      Refuse ("AUTH:" & String'(1 .. 200 => 'x') & LF);
      Refuse ("RPIN" & LF & Good_Line);
      Refuse ("AUTH:" & Character'Val (16#E9#) & Token & LF);
      Gone.Connect (S.Port);
      Gone.Half_Close;
      Expect_Refused (Gone, Not_Authenticated);
      Expect_Warnings (S, Not_Authenticated, Count + 1);
      Gone.Connect (S.Port);
      Gone.Send (Good_Line);
      Expect_Admitted (Gone);
   end Token_Wrong;

   procedure Unreadable_Token_File is
      Path    : constant String := Token_File (Mode => 0);
      Options : constant String := "--port 0 --token " & Path;
      Reason  : constant String := Path & ": Permission denied";
      Copy    : constant String := Programs.Temporary_Folder & "/unable";
   begin
      if Libc.Geteuid /= 0 then
         Expect_Start_Refused (Options, 1, Reason);
      elsif GNAT.OS_Lib.Locate_Exec_On_Path ("setpriv") = null then
         Skip ("root reads everything, and there is no setpriv");
      else
         Ada.Directories.Copy_File (Programs.Supervisor, Copy);
         Check (Libc.Chmod (To_C (Copy), 8#755#) = 0, "chmod of " & Copy);
         Expect_Start_Refused
           (Options, 1, Reason,
            Launcher => "setpriv --reuid=65534 --regid=65534 --clear-groups"
              & " --inh-caps=-all",
            Program  => Copy);
      end if;
   end Unreadable_Token_File;

   procedure Waits_For_The_End is
      --  While a session is being closed no client is rejected for it, and
      --  none gets more time for its first line
      R      : Rig;
      Silent : Client;
      Next   : Client;
      Last   : Client;
      Start  : Instant;
   begin
      Assemble
        (R, Supervisor_Options => "--token " & Token_File,
         Connected => False);
      Connect (R);
      R.Monitor.Send (Good_Line);
      Move_Forward (R);
      Silent.Connect (R.Supervisor.Port);
      Start := Now;
      R.Emulator.Tell ("silent on");
      R.Monitor.Close;
      --  the stop is repeated while the robot is silent
      Next.Connect (R.Supervisor.Port);
      Next.Send (Good_Line & "RPIN" & LF);
      delay 0.02;
      Last.Connect (R.Supervisor.Port);
      Last.Send (Good_Line);
      Check (Next.Next (Within => 3.0).Label = "ANAK", "not admitted");
      Note ("admitted after " & Milliseconds (Now - Start));
      Expect_Refused (Last, Not_Alone);
      R.Supervisor.Expect_Log ("second monitor refused", Within => 2.0);
      Check
        (R.Supervisor.Time_Of ("session closed")
         <= R.Supervisor.Time_Of ("second monitor refused"),
         "refused before the end");
      Expect_Refused
        (Silent, Not_Authenticated, Within => Token_Time + At_Once);
      Check
        (Now - Start in Token_Time - 0.2 .. Token_Time + At_Once,
         "the silent one refused after " & Milliseconds (Now - Start));
      Expect_Admitted (Next);
   end Waits_For_The_End;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "Security_Allowed_Addresses", Allowed_Addresses'Access);
      Add (Suite, "Security_Allowed_While_In_Command",
           Allowed_While_In_Command'Access);
      Add (Suite, "Security_Allowed_And_IPv6", Allowed_And_IPv6'Access);
      Add (Suite, "Security_Allowed_Wrongly", Allowed_Wrongly'Access);
      Add (Suite, "Security_Token_Right", Token_Right'Access);
      Add (Suite, "Security_Token_With_Commands",
           Token_With_Commands'Access);
      Add (Suite, "Security_Token_In_Pieces", Token_In_Pieces'Access);
      Add (Suite, "Security_Token_Wrong", Token_Wrong'Access);
      Add (Suite, "Security_Token_Late", Token_Late'Access);
      Add (Suite, "Security_Eight_Silent", Eight_Silent'Access);
      Add (Suite, "Security_Disturbs_Nobody", Disturbs_Nobody'Access);
      Add (Suite, "Security_Flood_Of_Newcomers", Flood_Of_Newcomers'Access);
      Add (Suite, "Security_Crowd_Keeps_Nobody_Out",
           Crowd_Keeps_Nobody_Out'Access);
      Add (Suite, "Security_Flood_Without_End", Flood_Without_End'Access);
      Add (Suite, "Security_Lines_Bit_By_Bit", Lines_Bit_By_Bit'Access);
      Add (Suite, "Security_Waits_For_The_End", Waits_For_The_End'Access);
      Add (Suite, "Security_Bad_Token_Files", Bad_Token_Files'Access);
      Add (Suite, "Security_Unreadable_Token_File",
           Unreadable_Token_File'Access);
      Add (Suite, "Security_Secret_Not_Logged", Secret_Not_Logged'Access);
      Add (Suite, "Security_Line_Without_Token_Option",
           Line_Without_Token_Option'Access);
      Add (Suite, "Security_Console_Monitor", Console_Monitor'Access);
   end Add_To;

end Security_Tests;
