--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission: addresses, tokens, and that no token gets into the log.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;
with GNAT.Sockets;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Floods;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;
with System.Multiprocessors;

procedure Security_Tests is

   use type GNAT.OS_Lib.String_Access;

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
      Move_Forward (R);
   end Drive_With_Token;

   function Median_Answer (R : in out Rig) return Duration is
      --  From an order to its answer
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

   procedure Expect_Warnings
     (S : Supervisor; Pattern : String; Count : Natural)
   is
      --  So many lines of the log, all of them warnings
      Deadline : constant Instant := Now + Patience;
   begin
      while S.Count_Of (Pattern) < Count and then Now < Deadline loop
         delay 0.01;
      end loop;
      delay 0.05;
      Check (S.Count_Of (Pattern) = Count,
             "not" & Count'Image & " lines of " & Pattern & ": "
             & S.Log_Text);
      for Line of Words (S.Log_Text, ASCII.LF) loop
         --  "[0.123] warning: ..."
         Check (Index (Line, Pattern) = 0 or else Index (Line, "warning:") > 0,
                "not a warning: " & Line);
      end loop;
   end Expect_Warnings;

   procedure Expect_Refusals (S : Supervisor; Reason : String; Count : Natural)
   is
      --  So many in the log: with a line each, or among those that are counted
      Omitted  : constant String := "too many for the log: ";
      Deadline : constant Instant := Now + Patience;
      Seen     : Natural;
   begin
      loop
         Seen := S.Count_Of ("newcomer refused, " & Reason & ": ");
         for Line of Words (S.Log_Text, ASCII.LF) loop
            if Index (Line, Omitted) > 0 then
               Seen := Seen + Natural'Value
                 (Line (Index (Line, Omitted) + Omitted'Length .. Line'Last));
            end if;
         end loop;
         exit when Seen >= Count or else Now > Deadline;
         delay 0.01;
      end loop;
      Check (Seen = Count, Seen'Image & " refusals: " & S.Log_Text);
   end Expect_Refusals;

   procedure Allowed_Addresses is
      S       : Supervisor;
      Refused : Natural := 0;

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
         S.Expect_Log ("session closed", After => Mark);
      end Admit;

      procedure Refuse (Source : String) is
         M : Client;
      begin
         M.Connect (S.Port, Source => Source);
         Expect_Refused (M, Not_Allowed);
         Refused := Refused + 1;
         if Refused = 1 then
            S.Expect_Log
              ("newcomer refused, " & Not_Allowed & ": " & Source & ":");
         end if;
      end Refuse;

   begin
      S.Start ("--allow 127.0.0.2/31 --allow=127.0.0.8 --allow 127.1.0.0/16");
      for Source of Words
        ("127.0.0.2 127.0.0.3 127.0.0.8 127.1.0.0 127.1.255.254")
      loop
         Admit (Source);
      end loop;
      for Source of Words
        ("127.0.0.1 127.0.0.4 127.0.0.7 127.0.0.9 127.0.255.255 127.2.0.0")
      loop
         Refuse (Source);
      end loop;
      Expect_Refusals (S, Not_Allowed, Refused);
   end Allowed_Addresses;

   procedure Allowed_And_IPv6 is

      function Has_IPv6 return Boolean is
         use GNAT.Sockets;
         Socket : Socket_Type;
      begin
         Create_Socket (Socket, Family_Inet6);
         begin
            Bind_Socket
              (Socket, Network_Socket_Address (Inet_Addr ("::1"), Any_Port));
         exception
            when Socket_Error =>
               Close_Socket (Socket);
               return False;
         end;
         Close_Socket (Socket);
         return True;
      exception
         when Socket_Error =>
            return False;
      end Has_IPv6;

      Open, Closed : Supervisor;
      M            : Client;
      Tool         : Child;
   begin
      if not Has_IPv6 then
         Skip ("this machine has no IPv6");
      end if;
      Open.Start (Bind => "::");
      Tool.Start
        (Programs.Monitor,
         Words ("--host ::1 --script - --port" & Positive'Image (Open.Port)),
         "console monitor");
      Tool.Put_Line ("RCLS");
      Tool.Close_Input;
      Check (Tool.Exit_Status = 0, "not by the console monitor");
      M.Connect (Open.Port, Address => "::1");
      Expect_Admitted (M);

      --  all of IPv4, also through an IPv6 socket
      Closed.Start ("--allow 0.0.0.0/0", Bind => "::");
      M.Connect (Closed.Port, Address => "::1");
      Expect_Refused (M, Not_Allowed);
      M.Connect (Closed.Port);
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
      R    : Rig;
      Tool : Child;

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
         return Tool.Exit_Status;
      end Status;

   begin
      Assemble (R, Supervisor_Options => "--token " & Token_File,
                Connected => False);
      Check (Status (Token_File (Name => "copy")) = 0, "with its token");
      Check (Tool.Awaited (Output, Token) = 0
             and then Tool.Awaited (Errors, Token) = 0,
             "the console monitor shows the token");
      Check
        (Status (Token_File ("another-token-here" & LF, Name => "other")) = 1,
         "with another token");
      Check (Status ("") = 1, "without one");
      Check (Status ("/no/such/file") = 2, "without its file");
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
         Tool.Start (Programs.Monitor,
                     Words ("--port" & Positive'Image (S.Port)
                       & " --script - --token " & Path),
                     "console monitor");
         Tool.Close_Input;
         Check ((Tool.Exit_Status = 0) = Trusted, "exit status, " & User);
         if not Trusted then
            Check
              (Tool.Awaited
                 (Errors, "a program of user " & User & " listens there") > 0,
               "it says nothing of user " & User);
         end if;
         S.Stop;
         Check (S.Says ("AUTH") = Trusted, User & ": " & S.Log_Text);
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
   begin
      Drive_With_Token (R);
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
         Expect_Refused (M, Not_Authenticated);
      end loop;
      Enter (Right, R.Supervisor, Good_Line);
      Expect_Refused (Right, Not_Alone);
      Check
        (R.Emulator.Count_Of ("M=0") = 0, "the robot was stopped meanwhile");
      R.Monitor.Expect ("RSTP", "AACK");
      Check (R.Monitor.Closed_By_Peer (0.0) = Monitor_Clients.Open,
             "the one in command has lost its connection");
   end Disturbs_Nobody;

   procedure Eight_Silent is
      --  Eight are pending: the one that has waited longest is removed
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
      Start := Now;
      Last.Connect (S.Port);
      Expect_Refused (Silent (1), Not_Authenticated);
      Enter (Good, S, Good_Line);
      Good.Expect ("RPIN", "ANAK");
      Check_Within (Now - Start, Token_Time / 2, "to make room");
      for M of Silent (2 .. 8) loop
         Expect_Refused (M, Not_Authenticated);
      end loop;
      Expect_Refused (Last, Not_Authenticated);
      Expect_Refusals (S, Not_Authenticated, 9);
   end Eight_Silent;

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
      Assemble (R,
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
      Note ("order to answer " & Milliseconds (Quiet) & ", amid the flood "
            & Milliseconds (Amid) & "," & Served'Image & " served in "
            & Milliseconds (Now - Start));
      Check (Served <= Per_Turn * (Natural ((Now - Start) / Interval) + 1),
             "more newcomers are seen to than" & Per_Turn'Image & " in "
             & Milliseconds (Interval));
      Check_In_Time
        (Served >= Per_Turn * Natural ((Now - Start) / Interval) / 20,
         "hardly any newcomer is seen to");
      Check_Within (Amid, 2 * Quiet + Grant, "an order amid the flood");
      --  the end of a session is handled nevertheless
      Start := Now;
      R.Monitor.Close;
      R.Supervisor.Expect_Log ("session closed");
      Check_Within (Now - Start, At_Once, "the end of the session");
      Crowd.Stop;
   end Flood_Of_Newcomers;

   procedure Flood_Without_End is
      --  Clients that reconnect as fast as possible fill the kernel's queue,
      --  but do not delay the monitor in command; its end is seen to, and when
      --  they have left there is room for the next
      R     : Rig;
      Flood : Floods.Flood;
      Next  : Client;
      Start : Instant;
      Quiet : Duration;
      Amid  : Duration;
   begin
      Drive_With_Token (R);
      Quiet := Median_Answer (R);
      Flood.Start (R.Supervisor.Port, Floods.Restless);
      delay 0.1;
      Amid := Median_Answer (R);
      Note ("order to answer " & Milliseconds (Quiet) & ", amid the flood "
            & Milliseconds (Amid));
      Check_Within (Amid, 2 * Quiet + 0.005, "an order amid the flood");
      Start := Now;
      R.Monitor.Close;
      R.Supervisor.Expect_Log ("session closed");
      Check_Within (Now - Start, At_Once, "the end of the session");
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
      S.Send_Signal (Libc.Sigterm);
      Check (S.Exit_Status = 0, "no orderly stop");
      Check (Index (S.Log_Text & S.Output_Text, Token) = 0,
             "the token is in the log: " & S.Log_Text);
   end Expect_Secret;

   procedure Line_Without_Token_Option is
      --  A monitor with a token at a supervisor without
      S : Supervisor;
      M : Client;
   begin
      S.Start ("--log-level debug");
      M.Connect (S.Port);
      M.Expect ("AUTH:" & Token, "ACER");
      Expect_Admitted (M);
      S.Expect_Log ("not understood: AUTH:...");
      S.Expect_Log ("received AUTH:...");
      Expect_Secret (S);
   end Line_Without_Token_Option;

   procedure Secret_Not_Logged is
      --  Of one who knows it; of others see Token_Wrong
      S : Supervisor;
      M : Client;

      procedure Try (Text : String) is
         Mark   : constant Natural := S.Log_Length;
         Unused : Message;
      begin
         Enter (M, S, Text & "RPIN" & LF);
         Unused := M.Next_Of ("ANAK");
         M.Close;
         S.Expect_Log ("session closed", After => Mark);
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
             "the log does not say that the line came: " & S.Log_Text);
   end Secret_Not_Logged;

   procedure Token_In_Pieces is
      S : Supervisor;

      procedure Try (Text : String; Size : Positive) is
         --  In pieces of Size
         M    : Client;
         Mark : constant Natural := S.Log_Length;
         Next : Positive := Text'First;
      begin
         M.Connect (S.Port);
         while Next <= Text'Last loop
            M.Send (Text (Next .. Natural'Min (Next + Size - 1, Text'Last)));
            Next := Next + Size;
            delay 0.002;
         end loop;
         Check (M.Next.Label = "ANAK", "the command behind it");
         Expect_Admitted (M);
         Check (M.Count = 2, "an answer too many");
         M.Close;
         S.Expect_Log ("session closed", After => Mark);
      end Try;

   begin
      S.Start ("--token " & Token_File);
      --  few pieces: a busy processor has Token_Time for all of them
      Try (Good_Line & "RPIN" & LF, 5);
      Try (Good_Line & "RPIN" & LF, 7);
      Try (Good_Line & "RPIN" & LF, Good_Line'Length - 1);
      Try (Good_Line & "RPIN" & LF, Good_Line'Length + 2);
      Try ("AUTH:" & Token & CR & LF & "RPIN" & CR & LF, Good_Line'Length);
   end Token_In_Pieces;

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
      Expect_Warnings (S, Not_Authenticated, 2);
   end Token_Late;

   procedure Token_Right is

      procedure Try (Of_Token : String; Ending : String) is
         S           : Supervisor;
         First, Next : Client;
      begin
         S.Start ("--token " & Token_File (Of_Token));
         Enter (First, S, "AUTH:" & Of_Token & Ending);
         Expect_Admitted (First);
         Check (First.Count = 1, "the first line was answered");
         Enter (Next, S, "AUTH:" & Of_Token & Ending);
         Expect_Refused (Next, Not_Alone);
         Expect_Admitted (First);
      end Try;

   begin
      Try (Token, (1 => LF));
      Try (Token, CR & LF);
      Try ("!~3456789012345~", (1 => LF));
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
      Enter (M, S, To_String (Text));
      for Turn in 1 .. Count loop
         Check (M.Next.Label = "ANAK", "RPIN" & Turn'Image);
         Check (M.Next.Label = "ACER", "what" & Turn'Image);
      end loop;
      Expect_Admitted (M);
      Check (M.Count = 2 * Count + 1, "answers too many");
   end Token_With_Commands;

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
      R.Emulator.Tell ("silent on");
      R.Monitor.Close;
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
      R.Emulator.Tell ("silent on");
      R.Monitor.Close;
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
      Lines  : constant Natural := R.Supervisor.Count_Of ("is no monitor");
   begin
      Enter (R.Monitor, R.Supervisor, Bytes);
      if R.Monitor.Try_Send (Orders) then
         null;  --  it may have been closed before
      end if;
      Check (R.Monitor.Closed_By_Peer /= Monitor_Clients.Open,
             "still connected: " & Bytes);
      Check (R.Monitor.Count = 0, "an answer to " & Bytes);
      Expect_Warnings (R.Supervisor, "is no monitor", Lines + 1);
   end Expect_Stranger_Closed;

   procedure Strangers is
      --  A web page can send any bytes to a port of its browser's machine
      R    : Rig;
      Line : constant String := CR & LF;
      Nul  : constant Character := ASCII.NUL;
   begin
      Assemble (R, Connected => False);
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
      --  a monitor's mistakes are answered
      Connect (R);
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Monitor.Expect ("POST / HTTP/1.1", "ACER");
      R.Monitor.Expect ("ROPN", "AACK");
      --  also when it has begun in pieces
      Connect (R);
      for Part of String'("RPIN") loop
         R.Monitor.Send ((1 => Part));
         delay 0.01;
      end loop;
      R.Monitor.Send ("" & CR);
      delay 0.01;
      R.Monitor.Send ("" & LF);
      Check_Label (R.Monitor.Next_Answer, "ANAK", "RPIN in pieces");
   end Strangers;

   procedure Who_May_Connect is
      --  This machine, unless an address, networks or a token are given
      procedure Expect (Options, Says : String) is
         S : Supervisor;
      begin
         S.Run ("--port 0 --serial /nonexistent " & Options);
         S.Expect_Log (Says);
      end Expect;
   begin
      Expect ("", "listening on 127.0.0.1:");
      Expect ("", ", for this machine alone");
      Expect ("--token " & Token_File, "listening on 0.0.0.0:");
      Expect ("--token " & Token_File,
              ", for every machine that reaches it, with the token");
      Expect ("--allow 127.0.0.0/8", "listening on 0.0.0.0:");
      Expect ("--allow 127.0.0.0/8", ", for the networks of --allow");
      Expect ("--bind 0.0.0.0", ", for every machine that reaches it");
      Expect ("--bind ::1", ", for this machine alone");
   end Who_May_Connect;

begin
   Add ("Security_Allowed_Addresses", Allowed_Addresses'Access);
   Add ("Security_Allowed_While_In_Command", Allowed_While_In_Command'Access);
   Add ("Security_Allowed_And_IPv6", Allowed_And_IPv6'Access);
   Add ("Security_Token_Right", Token_Right'Access);
   Add ("Security_Token_With_Commands", Token_With_Commands'Access);
   Add ("Security_Token_In_Pieces", Token_In_Pieces'Access);
   Add ("Security_Token_Wrong", Token_Wrong'Access);
   Add ("Security_Token_Late", Token_Late'Access, In_Time => True);
   Add ("Security_Eight_Silent", Eight_Silent'Access, In_Time => True);
   Add ("Security_Disturbs_Nobody", Disturbs_Nobody'Access);
   Add ("Security_Flood_Of_Newcomers",
        Flood_Of_Newcomers'Access, Timed => True);
   Add ("Security_Crowd_Keeps_Nobody_Out", Crowd_Keeps_Nobody_Out'Access);
   Add ("Security_Flood_Without_End", Flood_Without_End'Access, Timed => True);
   Add ("Security_Lines_Bit_By_Bit", Lines_Bit_By_Bit'Access, Timed => True);
   Add ("Security_Waits_For_The_End",
        Waits_For_The_End'Access, In_Time => True);
   Add ("Security_Entitled_Stays", Entitled_Stays'Access);
   Add ("Security_Bad_Token_Files", Bad_Token_Files'Access);
   Add ("Security_Unreadable_Files", Unreadable_Files'Access);
   Add ("Security_Secret_Not_Logged", Secret_Not_Logged'Access);
   Add ("Security_Line_Without_Token_Option",
        Line_Without_Token_Option'Access);
   Add ("Security_Console_Monitor", Console_Monitor'Access);
   Add ("Security_Console_Tells_No_Other_User",
        Console_Tells_No_Other_User'Access);
   Add ("Security_Strangers", Strangers'Access);
   Add ("Security_Who_May_Connect", Who_May_Connect'Access);
end Security_Tests;
