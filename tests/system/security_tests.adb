--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission: addresses, tokens, and that no token gets into the log.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Floods;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Process_Facts;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;
with System.Multiprocessors;

procedure Security_Tests is

   use type GNAT.OS_Lib.String_Access;
   use type System.Multiprocessors.CPU;

   LF : constant Character := ASCII.LF;
   CR : constant Character := ASCII.CR;

   Good_Line : constant String := "AUTH:" & Token & LF;

   Token_Time : constant Duration := 2.0;
   --  for the first line

   At_Once : constant Duration := 1.0;
   --  on a shared machine: half of Token_Time

   Not_Authenticated : constant String := "not authenticated";
   Not_Allowed       : constant String := "this address is not allowed";
   Not_Alone         : constant String := "another monitor is connected";

   procedure Enter (M : in out Client; S : Supervisor; Text : String) is
      --  M connects and sends Text
   begin
      M.Connect (S.Port);
      M.Send (Text);
   end Enter;

   procedure Drive_With_Token (R : in out Rig) is
      --  By a monitor in command at a supervisor that has a token
   begin
      Assemble (R, Supervisor_Options => "--token " & Token_File,
                Connected => False);
      Enter (R.Monitor, R.Supervisor, Good_Line);
      Play (R, Forward);
   end Drive_With_Token;

   function Median_Answer (R : in out Rig) return Duration is
      --  From an order to its answer
      Rounds : constant := 100;
      Taken  : Samples.Set;
      Start  : Instant;
      Late   : Natural := 0;
   begin
      for Round in 1 .. Rounds loop
         Start := Now;
         Late := Late + Boolean'Pos (R.Monitor.Ask ("RGFW").Label = "ATIM");
         Taken.Add (Now - Start);
         delay 0.02;
      end loop;
      --  on a loaded machine the emulated robot is sometimes late
      Check_In_Time
        (Late < Rounds / 4, Late'Image & " orders without an answer");
      return Taken.Quantile (0.5);
   end Median_Answer;

   procedure Expect_Admission (S : Supervisor; M : in out Client) is
      --  Of M with the right token. Its line may come after it was displaced,
      --  as the kernel may drop packets: then it connects again
      Start : constant Instant := Now;
      Item  : Message;
   begin
      loop
         Enter (M, S, Good_Line & "RPIN" & LF);
         Item := M.Next;
         exit when Item.Label /= "MSSG" or else Now - Start > Patience;
      end loop;
      Check_Label (Item, "ANAK", "the right token");
      Note ("admitted after " & Milliseconds (Now - Start));
   end Expect_Admission;

   type Client_Array is array (Positive range <>) of Client;

   procedure Expect_Refused (M : in out Client; Reason : String) is
      --  It gets the message and is closed
      Item : constant Message := M.Next_Of ("MSSG");
   begin
      Check (Item.Data = "refused: " & Reason, To_String (Item.Data));
      Check (M.Closed_By_Peer /= Monitor_Clients.Open,
             "refused, and still connected");
      Check (M.Count = 1, "more than a refusal");
   end Expect_Refused;

   procedure Expect_Refused_In_Time (M : in out Client; Since : Instant) is
      --  As its first line has not come; Since: before it connected
      Taken : Duration;
   begin
      Expect_Refused (M, Not_Authenticated);
      Taken := Now - Since;
      Check (Taken >= Token_Time,
             "refused after " & Milliseconds (Taken) & " already");
      Check_Within (Taken, Token_Time + At_Once, "to be refused");
   end Expect_Refused_In_Time;

   procedure Expect_Admitted (M : in out Client) is
   begin
      M.Expect ("RPIN", "ANAK");
   end Expect_Admitted;

   procedure Expect_Refusals (S : Supervisor; Reason : String; Count : Natural)
   is
      --  So many in the log, all of them warnings: with a line each, or among
      --  those that are counted
      Refused  : constant String := "newcomer refused, " & Reason & ": ";
      Omitted  : constant String := "too many for the log: ";
      Deadline : constant Instant := Now + Patience;
      Seen     : Natural;
   begin
      loop
         Seen := 0;
         for Line of Words (S.Text, LF) loop
            if Index (Line, Refused) > 0 then
               Seen := Seen + 1;
               Check (Index (Line, "warning:") > 0, "not a warning: " & Line);
            elsif Index (Line, Omitted) > 0 then
               Seen := Seen + Natural'Value
                 (Line (Index (Line, Omitted) + Omitted'Length .. Line'Last));
            end if;
         end loop;
         exit when Seen >= Count or else Now > Deadline;
         delay 0.01;
      end loop;
      Check (Seen = Count, Seen'Image & " refusals: " & S.Text);
   end Expect_Refusals;

   procedure Leave (S : Supervisor; M : in out Client) is
      --  The next one would be a second monitor before the end
      Mark : constant Natural := S.Count;
   begin
      M.Close;
      S.Expect_Log ("session closed", After => Mark);
   end Leave;

   procedure Allowed_Addresses is
      S       : Supervisor;
      M, N    : Client;
      Refused : Natural := 0;
   begin
      S.Start ("--allow 127.0.0.2/31 --allow=127.0.0.8 --allow 127.1.0.0/16");
      for Source of Words
        ("127.0.0.2 127.0.0.3 127.0.0.8 127.1.0.0 127.1.255.254")
      loop
         M.Connect (S.Port, Source => Source);
         Expect_Admitted (M);
         Leave (S, M);
      end loop;
      for Source of Words
        ("127.0.0.1 127.0.0.4 127.0.0.7 127.0.0.9 127.0.255.255 127.2.0.0")
      loop
         if Refused = 3 then
            --  while one is in command: that message and no other
            M.Connect (S.Port, Source => "127.0.0.2");
            Expect_Admitted (M);
         end if;
         N.Connect (S.Port, Source => Source);
         Expect_Refused (N, Not_Allowed);
         Refused := Refused + 1;
      end loop;
      S.Expect_Log ("newcomer refused, " & Not_Allowed & ": 127.0.0.1:");
      Expect_Refusals (S, Not_Allowed, Refused);
      N.Connect (S.Port, Source => "127.0.0.3");
      Expect_Refused (N, Not_Alone);
      Expect_Admitted (M);
   end Allowed_Addresses;

   procedure Expect_Listening (Options, Listens, For_Whom : String) is
      S : Supervisor;
   begin
      S.Run ("--port 0 --serial /nonexistent " & Options);
      S.Expect_Log ("listening on " & Listens);
      S.Expect_Log (For_Whom);
   end Expect_Listening;

   procedure Allowed_And_IPv6 is
      Open, Closed : Supervisor;
      M            : Client;
   begin
      if Process_Facts.File_Line ("/proc/net/if_inet6", " lo") = "" then
         Skip ("this machine has no IPv6");
      end if;
      Expect_Listening ("--bind ::1", "::1", ", for this machine alone");
      Open.Start (Bind => "::");
      Expect_Monitor (Open.Port, "RCLS", "--host ::1", 0);
      M.Connect (Open.Port, Address => "::1");
      Expect_Admitted (M);

      --  all of IPv4, also through an IPv6 socket
      Closed.Start ("--allow 0.0.0.0/0", Bind => "::");
      M.Connect (Closed.Port, Address => "::1");
      Expect_Refused (M, Not_Allowed);
      M.Connect (Closed.Port);
      Expect_Admitted (M);
   end Allowed_And_IPv6;

   procedure Bad_Token_Files is
      No_Token  : constant String := "its first line is no token";
      Not_Alone : constant String := "others than its owner";

      type Modes is array (Positive range <>) of unsigned;

      procedure Refuse
        (Path : String; Reason : String; Checked : Boolean := False) is
         --  Checked: also by --check, which tries the camera, so it is slow
      begin
         Expect_Console ("--port 0 --token " & Path, 1, Path & ": " & Reason);
         if Checked then
            Expect_Console ("--check --port 0 --token " & Path, 1,
                            "not ok  token file " & Path & ": " & Reason);
         end if;
      end Refuse;

   begin
      Refuse (Programs.Temporary_Folder & "/no_such_file", "No such file",
              Checked => True);
      Refuse (Programs.Temporary_Folder, "Is a directory");
      Refuse ("/run/credentials/none/token",
              "No such file or directory. It is systemd's copy of the file to "
              & "mend, /etc/destijl/token");
      for Mode of Modes'(8#660#, 8#620#, 8#604#, 8#602#) loop
         Refuse (Token_File (Mode => Mode), Not_Alone, Mode = 8#604#);
      end loop;
      Refuse (Token_File (""), No_Token, Checked => True);
      Refuse (Token_File ("123456789012345" & LF), No_Token);
      Refuse (Token_File ((1 .. 5_000 => 'x')), No_Token);
      Refuse (Token_File (Token & CR & LF), No_Token);
      declare
         Path : constant String := Token_File (Mode => 8#400#);
         Text : constant String := Console
           ("--check --port 0 --camera /no/such --token " & Path, 1);
      begin
         Check (Index (Text, "ok      token file " & Path) > 0,
                "a good token file is not reported: " & Text);
         Check (Index (Text, Token) = 0, "the token is on the console");
      end;
   end Bad_Token_Files;

   procedure Console_Monitor is
      S    : Supervisor;
      Tool : Child;
   begin
      S.Start ("--token " & Token_File);
      Start_Monitor (Tool, S.Port, "RPIN",
                     "--token " & Token_File (Name => "copy"));
      Tool.Close_Input;
      Tool.Expect_Exit (0);
      Check (Index (Tool.Text (Output) & Tool.Text, Token) = 0,
             "the console monitor shows the token");
      Expect_Monitor
        (S.Port, "RPIN",
         "--token " & Token_File ("another-token-here" & LF, Name => "other"),
         1);
      Expect_Monitor (S.Port, "RPIN", "", 1);
      Expect_Monitor (S.Port, "RPIN", "--token /no/such/file", 2);
   end Console_Monitor;

   procedure Console_Tells_No_Other_User is
      --  Who listens while the supervisor does not. 65000: of a service
      Path : constant String := Token_File;
      S    : Supervisor;
      Tool : Child;

      procedure Try (User : String; Trusted : Boolean) is
      begin
         S.Start ("--log-level debug",
                  Launcher => "setpriv --clear-groups --reuid=" & User,
                  Program  => Programs.Copied_Supervisor);
         Start_Monitor (Tool, S.Port, "", "--token " & Path);
         Tool.Close_Input;
         Check ((Tool.Exit_Status = 0) = Trusted, "exit status, " & User);
         Check (Trusted or else Tool.Says
                  ("a program of user " & User & " listens there"),
                "it says nothing of user " & User);
         S.Stop;
         Check (S.Says ("AUTH") = Trusted, User & ": " & S.Text);
      end Try;

   begin
      if Libc.Geteuid /= 0 then
         Skip ("only root can be other users");
      end if;
      Try ("0", Trusted => True);
      Try ("65000", Trusted => True);
      Try ("1000", Trusted => False);
      Try ("33", Trusted => False);
   end Console_Tells_No_Other_User;

   procedure Crowd_Keeps_Nobody_Out is
      --  With as many connections in front as the kernel's queue holds
      S     : Supervisor;
      Slow  : Floods.Flood;
      Crowd : Floods.Crowd (1_100);
      M     : Client;
   begin
      S.Start ("--token " & Token_File);
      Slow.Start (S.Port, Floods.Slow);
      delay 0.1;
      Crowd.Come (S.Port, Floods.Address (1));
      Expect_Admission (S, M);
   end Crowd_Keeps_Nobody_Out;

   procedure Disturbs_Nobody is
      R       : Rig;
      Silent  : Client_Array (1 .. 8);
      Wrong   : Client;
      Right   : Client;
      Slowest : Duration := 0.0;
      Start   : Instant;
   begin
      Drive_With_Token (R);
      for M of Silent loop
         M.Connect (R.Supervisor.Port, Real_Time => False);
         M.Send ("AUTH:");
      end loop;
      for Turn in 1 .. 40 loop
         Start := Now;
         R.Monitor.Expect ("what", "ACER");
         Slowest := Duration'Max (Slowest, Now - Start);
         if Turn mod 8 = 0 then
            Wrong.Connect (R.Supervisor.Port, Real_Time => False);
            Wrong.Send ("AUTH:nonsense" & LF);
         end if;
         delay 0.05;
      end loop;
      Note ("slowest answer " & Milliseconds (Slowest));
      for M of Silent loop
         Expect_Refused (M, Not_Authenticated);
      end loop;
      Enter (Right, R.Supervisor, Good_Line);
      Expect_Refused (Right, Not_Alone);
      Play (R, "sent M=0 0, RSTP AACK");
      --  not stopped meanwhile
      Check (R.Monitor.Closed_By_Peer (0.0) = Monitor_Clients.Open,
             "the one in command has lost its connection");
   end Disturbs_Nobody;

   procedure Eight_Silent is
      --  Eight are pending: the one that has waited longest is removed
      S      : Supervisor;
      Silent : Client_Array (1 .. 9);
      Good   : Client;
      Start  : Instant;
   begin
      S.Start ("--token " & Token_File);
      for Number in Silent'Range loop
         Start := Now;
         Silent (Number).Connect (S.Port, Real_Time => Number = 9);
      end loop;
      Expect_Refused (Silent (1), Not_Authenticated);
      Enter (Good, S, Good_Line);
      Expect_Admitted (Good);
      Check_Within (Now - Start, Token_Time / 2, "to make room");
      for M of Silent (2 .. 9) loop
         Expect_Refused (M, Not_Authenticated);
      end loop;
      Expect_Refusals (S, Not_Authenticated, 9);
   end Eight_Silent;

   procedure Expect_Answers_Amid
     (R     : in out Rig;
      Flood : in out Floods.Flood;
      How   : Floods.Manner;
      Quiet : Duration)
   is
      --  The monitor in command is delayed by a bounded share (Quiet: what an
      --  answer takes without), and its end is seen to nevertheless
      Grant : constant Duration := 0.005;
      --  margin on a shared machine
      Amid  : Duration;
      Start : Instant;
   begin
      Flood.Start (R.Supervisor.Port, How);
      delay 0.1;
      Amid := Median_Answer (R);
      Note ("order to answer " & Milliseconds (Quiet) & ", amid the flood "
            & Milliseconds (Amid));
      Check_Within (Amid, 2 * Quiet + Grant, "an order amid the flood");
      Start := Now;
      Play (R, "close, log session closed");
      Check_Within (Now - Start, At_Once, "the end of the session");
   end Expect_Answers_Amid;

   procedure Flood_Of_Newcomers (R : in out Rig) is
      --  New connections have priority over the orders of the monitor in
      --  command (th_server is above th_move)
      Interval : constant Duration := 0.01;
      --  minimum time between two turns that handle them
      Per_Turn : constant := 10;
      --  number per turn

      Flood  : Floods.Flood;
      Quiet  : constant Duration := Median_Answer (R);
      Start  : constant Instant := Now;
      Served : Natural;
      Turns  : Natural;
   begin
      Expect_Answers_Amid (R, Flood, Floods.Patient, Quiet);
      Served := Flood.Served;
      Turns := Natural ((Now - Start) / Interval);
      Note (Served'Image & " served in" & Turns'Image & " turns");
      Check (Served <= Per_Turn * (Turns + 1),
             "more newcomers are seen to than" & Per_Turn'Image & " in "
             & Milliseconds (Interval));
      Check_In_Time (Served >= Per_Turn * Turns / 20,
                     "hardly any newcomer is seen to");
      Flood.Stop;
   end Flood_Of_Newcomers;

   procedure Flood_Without_End is
      --  Clients that reconnect as fast as possible fill the kernel's queue;
      --  when they have left there is room for the next
      R     : Rig;
      Flood : Floods.Flood;
      Next  : Client;
   begin
      Drive_With_Token (R);
      Expect_Answers_Amid (R, Flood, Floods.Restless, Median_Answer (R));
      Flood.Stop;
      Expect_Admission (R.Supervisor, Next);
   end Flood_Without_End;

   procedure Lines_Bit_By_Bit is
      --  Clients that send their lines in many pieces do not block one that
      --  sends its line at once
      Between : constant Duration := 0.05;
      --  seven pieces, each of which takes 10 ms
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
      Check (M.Next.Label = "ANAK", "not admitted");
      Check_Within (Now - Start, 0.3, "its admission");
   end Lines_Bit_By_Bit;

   procedure Expect_Secret (S : in out Supervisor) is
      --  Ends it, and looks for the token in all that it has said
   begin
      S.Expect_End;
      Check (Index (S.Text & S.Text (Output), Token) = 0,
             "the token is in the log: " & S.Text);
   end Expect_Secret;

   procedure Secret_Not_Logged is
      --  Of one who knows it; of others see Token_Wrong
      S : Supervisor;
      M : Client;

      procedure Try (Text : String) is
         Unused : Message;
      begin
         Enter (M, S, Text & "RPIN" & LF);
         Unused := M.Next_Of ("ANAK");
         Leave (S, M);
      end Try;

   begin
      S.Start ("--log-level debug --token " & Token_File);
      Try (Good_Line);
      Try (Good_Line & Good_Line);
      Try (Good_Line & "what" & LF & Good_Line & Good_Line);
      Try (Good_Line & "x" & Good_Line);
      Try (Good_Line & "MSSG:" & Good_Line);
      Try (Good_Line & "auth:" & Token & LF);
      Try (Good_Line & "RMOV:AUTH:" & Token & "AUTH:" & Token & LF);
      Expect_Secret (S);
      Check (S.Says ("not understood: AUTH:..."),
             "the log does not say that the line came: " & S.Text);

      --  a monitor with a token at a supervisor without
      S.Start ("--log-level debug");
      M.Connect (S.Port);
      M.Expect ("AUTH:" & Token, "ACER");
      Expect_Admitted (M);
      S.Expect_Log ("not understood: AUTH:...");
      S.Expect_Log ("received AUTH:...");
      Expect_Secret (S);
   end Secret_Not_Logged;

   procedure Token_Late is
      S      : Supervisor;
      Silent : Client;
      Slow   : Client;
      Good   : Client;
      Start  : Instant;
   begin
      S.Start ("--token " & Token_File);
      Start := Now;
      Silent.Connect (S.Port);
      Expect_Refused_In_Time (Silent, Since => Start);

      --  each has its own time limit, not prolonged by any piece of a line or
      --  other event
      Start := Now;
      Slow.Connect (S.Port);
      for Place in 1 .. 12 loop
         exit when not Slow.Try_Send ((1 => Good_Line (Place)));
         if Place = 6 then
            Enter (Good, S, Good_Line);
            Expect_Admitted (Good);
         end if;
         delay 0.15;
      end loop;
      Expect_Refused_In_Time (Slow, Since => Start);
      Expect_Admitted (Good);
      Expect_Refusals (S, Not_Authenticated, 2);
   end Token_Late;

   procedure Token_Right is

      procedure Try
        (Of_Token, Ending : String;
         Size             : Positive := 100_000;
         Count            : Positive := 1)
      is
         --  The first line and Count commands of two kinds, in pieces of Size
         Line        : constant String := "AUTH:" & Of_Token & Ending;
         Text        : constant String :=
           Line & Count * ("RPIN" & Ending & "what" & Ending);
         Case_Name   : constant String :=
           Of_Token & " in pieces of" & Size'Image & ":";
         S           : Supervisor;
         First, Next : Client;
         Place       : Positive := 1;
      begin
         S.Start ("--token " & Token_File (Of_Token));
         First.Connect (S.Port);
         while Place <= Text'Last loop
            First.Send
              (Text (Place .. Natural'Min (Place + Size - 1, Text'Last)));
            Place := Place + Size;
            delay 0.002;
         end loop;
         for Turn in 1 .. Count loop
            Check_Label (First.Next, "ANAK", Case_Name & Turn'Image);
            Check_Label (First.Next, "ACER", Case_Name & Turn'Image);
         end loop;
         Enter (Next, S, Line);
         Expect_Refused (Next, Not_Alone);
         Expect_Admitted (First);
         Check (First.Count = 2 * Count + 1, Case_Name & " answers too many");
      end Try;

      End_Of_Line : constant String := (1 => LF);
   begin
      Try (Token, End_Of_Line);
      Try (Token, CR & LF);
      Try ("!~3456789012345~", End_Of_Line);
      Try ((1 .. 128 => 'x'), End_Of_Line);
      Try ((1 .. 128 => 'x'), CR & LF);
      --  few pieces: a busy processor has Token_Time for all of them
      Try (Token, End_Of_Line, Size => 7);
      Try (Token, End_Of_Line, Size => Good_Line'Length - 1);
      Try (Token, End_Of_Line, Size => Good_Line'Length + 2);
      Try (Token, CR & LF, Size => Good_Line'Length);
      --  nothing behind it in the same segment is lost
      Try (Token, End_Of_Line, Count => 500);
   end Token_Right;

   procedure Token_Wrong is
      S     : Supervisor;
      Count : Natural := 0;

      procedure Refuse (Text : String) is
         M : Client;
      begin
         Enter (M, S, Text);
         Expect_Refused (M, Not_Authenticated);
         Count := Count + 1;
      end Refuse;

      Gone : Client;
   begin
      S.Start ("--log-level debug --token " & Token_File);
      for Line of Words
        ("RPIN||AUTH|AUTH:|AUTH:correct-horse-batterz"
         & "|AUTH:Correct-horse-battery|AUTH:" & Token & "x|AUTH:x" & Token
         & "|" & Token & "|AUTH:" & Token & " |AUTH:correct-horse-batter"
         & "|AUTH: " & Token & "| AUTH:" & Token & "|auth:" & Token & "|AUTH:"
         & Token & CR & CR & "|AUTH:" & Token & ASCII.NUL & "|AUTH:"
         & (1 .. 200 => 'x') & "|RPIN" & LF & "AUTH:" & Token & "|AUTH:"
         & Character'Val (16#E9#) & Token, Separator => '|')
      loop
         Refuse (Line & LF);
      end loop;
      Refuse ((1 => LF));
      Refuse ((1 .. 135 => ASCII.NUL));
      Refuse ("AUTH:" & String'(1 .. 130 => 'x'));
      Gone.Connect (S.Port);
      Gone.Half_Close;
      Expect_Refused (Gone, Not_Authenticated);
      Expect_Refusals (S, Not_Authenticated, Count + 1);
      Enter (Gone, S, Good_Line);
      Expect_Admitted (Gone);
      Expect_Secret (S);
   end Token_Wrong;

   procedure Unreadable_Files is
      --  The token's, and what would be the robot's line
      Path   : constant String  := Token_File (Mode => 0);
      Reason : constant String  := Path & ": Permission denied";
      Root   : constant Boolean := Libc.Geteuid = 0;

      procedure Expect (Options, Text : String) is
      begin
         Expect_Console
           ("--port 0 " & Options & Path, 1, Text,
            Launcher => (if Root then Programs.As_User else ""),
            Program  => (if Root then Programs.Copied_Supervisor else ""));
      end Expect;

   begin
      if Root and then GNAT.OS_Lib.Locate_Exec_On_Path ("setpriv") = null then
         Skip ("root reads everything, and there is no setpriv");
      end if;
      Expect ("--token ", Reason);
      Expect ("--check --serial ",
              Reason & ": your user must be in the group dialout");
   end Unreadable_Files;

   procedure Waits_For_The_End is
      --  While a session is being closed no client is rejected for it, and
      --  none gets more time for its first line
      R      : Rig;
      Silent : Client;
      Next   : Client;
      Last   : Client;
      Start  : Instant;
   begin
      Drive_With_Token (R);
      Start := Now;
      Silent.Connect (R.Supervisor.Port);
      Play (R, "tell silent on, close");
      --  the stop is repeated while the robot is silent
      Enter (Next, R.Supervisor, Good_Line & "RPIN" & LF);
      delay 0.02;
      Enter (Last, R.Supervisor, Good_Line);
      Check (Next.Next.Label = "ANAK", "not admitted");
      Expect_Refused (Last, Not_Alone);
      R.Supervisor.Expect_Log ("refused, " & Not_Alone);
      Check (R.Supervisor.Time_Of ("session closed")
             <= R.Supervisor.Time_Of ("refused, " & Not_Alone),
             "refused before the end");
      Expect_Refused_In_Time (Silent, Since => Start);
      Expect_Admitted (Next);
   end Waits_For_The_End;

   procedure Entitled_Stays is
      --  Who waits for the end of a session is not displaced by others
      R      : Rig;
      Next   : Client;
      Crowd  : Client_Array (1 .. 20);
   begin
      Drive_With_Token (R);
      Play (R, "tell silent on, close");
      Enter (Next, R.Supervisor, Good_Line & "RPIN" & LF);
      for M of Crowd loop
         M.Connect (R.Supervisor.Port, Real_Time => False);
      end loop;
      Check_Label (Next.Next, "ANAK", "the one that waits");
   end Entitled_Stays;

   procedure Expect_Stranger_Closed (R : in out Rig; Bytes : String) is
      --  A connection that begins with Bytes, followed by orders: closed at
      --  once and unanswered, the orders not carried out, a line in the log
      Orders : constant String := LF & LF & "ROPN" & LF & "RSOW" & LF
        & "RGFW" & LF;
      Mark   : constant Natural := R.Supervisor.Count;
      Unused : Boolean;
   begin
      Enter (R.Monitor, R.Supervisor, Bytes);
      Unused := R.Monitor.Try_Send (Orders);
      --  it may have been closed before
      Check (R.Monitor.Closed_By_Peer /= Monitor_Clients.Open,
             "still connected: " & Bytes);
      Check (R.Monitor.Count = 0, "an answer to " & Bytes);
      R.Supervisor.Expect_Log ("is no monitor", Mark);
      Check (R.Supervisor.Count_Of ("is no monitor", Mark) = 1,
             "more than one line: " & R.Supervisor.Text);
   end Expect_Stranger_Closed;

   procedure Strangers (R : in out Rig) is
      --  A web page can send any bytes to a port of its browser's machine
      Line : constant String := CR & LF;
      Nul  : constant Character := ASCII.NUL;
   begin
      for Bytes of Words
        ("POST / HTTP/1.1" & Line & "Host: robot" & Line & "|GET / HTTP/1.1"
         & LF & "|get /ROPN http/1.0" & CR & "a: b" & CR
         & "|ROPN / HTTP/1.1" & Line & "|PRI * HTTP/2.0" & Line & Line & "|"
         & ASCII.SYN & ASCII.ETX & ASCII.SOH & Nul & "E" & ASCII.SOH
         & "|SSH-2.0-OpenSSH_9.2" & Line & "|OPTIONS rtsp://a/ RTSP/1.0"
         & Line & "|*1" & Line & "$4" & Line & "PING" & Line
         & "|" & Nul & Nul & Nul & Nul & "|ropn" & LF & "|" & LF & "|"
         & (1 .. 2_000 => 'A'), Separator => '|')
      loop
         Expect_Stranger_Closed (R, Bytes);
      end loop;
      Check (R.Emulator.Wire_Text ("?rpvMTuWDs") = "", "the robot got orders");
      for Line of Words (R.Supervisor.Text, LF) loop
         Check (Index (Line, "is no monitor") = 0
                or else Index (Line, "warning:") > 0, "no warning: " & Line);
      end loop;
      --  a monitor's mistakes are answered
      Connect (R);
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Monitor.Expect ("POST / HTTP/1.1", "ACER");
      R.Monitor.Expect ("ROPN", "AACK");
      --  also when it has begun in pieces
      Connect (R);
      for Part of String'("RPIN" & CR & LF) loop
         R.Monitor.Send ((1 => Part));
         delay 0.01;
      end loop;
      Check_Label (R.Monitor.Next_Answer, "ANAK", "RPIN in pieces");
   end Strangers;

   procedure Who_May_Connect is
      --  This machine, unless an address, networks or a token are given
   begin
      Expect_Listening ("", "127.0.0.1:", ", for this machine alone");
      Expect_Listening
        ("--token " & Token_File, "0.0.0.0:",
         ", for every machine that reaches it, with the token");
      Expect_Listening
        ("--allow 127.0.0.0/8", "0.0.0.0:", ", for the networks of --allow");
      Expect_Listening
        ("--bind 0.0.0.0", "0.0.0.0:", ", for every machine that reaches it");
   end Who_May_Connect;

begin
   Add ("Security_Allowed_Addresses", Allowed_Addresses'Access);
   Add ("Security_Allowed_And_IPv6", Allowed_And_IPv6'Access);
   Add ("Security_Token_Right", Token_Right'Access);
   Add ("Security_Token_Wrong", Token_Wrong'Access);
   Add ("Security_Token_Late", Token_Late'Access, In_Time => True);
   Add ("Security_Eight_Silent", Eight_Silent'Access, In_Time => True);
   Add ("Security_Disturbs_Nobody", Disturbs_Nobody'Access);
   Script ("Security_Flood_Of_Newcomers", Forward, Flood_Of_Newcomers'Access,
           Supervisor_Options =>
             (if System.Multiprocessors.Number_Of_CPUs > 1 then "--cpu 0"
              else ""), Timed => True);
   Add ("Security_Crowd_Keeps_Nobody_Out", Crowd_Keeps_Nobody_Out'Access);
   Add ("Security_Flood_Without_End", Flood_Without_End'Access, Timed => True);
   Add ("Security_Lines_Bit_By_Bit", Lines_Bit_By_Bit'Access, Timed => True);
   Add ("Security_Waits_For_The_End",
        Waits_For_The_End'Access, In_Time => True);
   Add ("Security_Entitled_Stays", Entitled_Stays'Access);
   Add ("Security_Bad_Token_Files", Bad_Token_Files'Access);
   Add ("Security_Unreadable_Files", Unreadable_Files'Access);
   Add ("Security_Secret_Not_Logged", Secret_Not_Logged'Access);
   Add ("Security_Console_Monitor", Console_Monitor'Access);
   Add ("Security_Console_Tells_No_Other_User",
        Console_Tells_No_Other_User'Access);
   Script ("Security_Strangers", "", Strangers'Access, Connected => False);
   Add ("Security_Who_May_Connect", Who_May_Connect'Access);
end Security_Tests;
