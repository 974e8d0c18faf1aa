--  SPDX-License-Identifier: GPL-3.0-or-later
--  The test environment of a fault.

with Ada.Strings;         use Ada.Strings;
with Ada.Strings.Fixed;   use Ada.Strings.Fixed;
with GNAT.Sockets;

with Child_Processes;
with Expectations;        use Expectations;
with Process_Facts;
with Random_Numbers;      use Random_Numbers;
with Standstills;
with Tolerances;          use Tolerances;

package body Worlds is

   Images : constant String := "320x240";
   --  Small ones: a dozen worlds share two processors

   Images_A_Second : constant String := "12";
   --  of the emulated camera; the supervisor takes ten of them

   Loopback : constant String := "127.0.0.1";

   Calm_Words : constant Child_Processes.Arguments := Child_Processes.Words
     ("RPIN RGST RGBT RLDW RPIN RGST nope MSSG:text");

   All_Words : constant Child_Processes.Arguments := Child_Processes.Words
     ("RPIN RGST RGBT RLDW RPIN RGST nope MSSG:text"
      & " RGFW RGBW RGLF RGRI RSTP RMOV:40 RTRN:-40 RMOV:0 RSTP RGFW"
      & " ROPN RCLS RSOW RSWW RRST COPN CCLS CASA CACO CAIN CPCO CPST"
      & " MGTO:320;240 MPCM:20;20;60;40 MABT");

   procedure Forget_Session (W : in out World);
   --  It has ended: evaluates its ledger

   procedure Note_Facts (W : in out World);
   --  Once they no longer change

   function Log_Says (W : World; Text : String) return Natural is
     (W.Supervisor.Count_Of (Text, After => W.Session_Log));
   --  How often, in this session

   Robot_Silent : exception;
   --  An answer ATIM where another was expected

   function Free_Port return Positive is
      use GNAT.Sockets;
      Socket : Socket_Type;
      Place  : Sock_Addr_Type;
   begin
      Create_Socket (Socket);
      Bind_Socket (Socket, (Family_Inet, Inet_Addr (Loopback), 0));
      Place := Get_Socket_Name (Socket);
      Close_Socket (Socket);
      return Positive (Place.Port);
   end Free_Port;

   function Worst (Left, Right : Figure_Set) return Figure_Set is
     ((Repeated     => Left.Repeated + Right.Repeated,
       Interrupted  => Left.Interrupted + Right.Interrupted,
       Stops        => Left.Stops + Right.Stops,
       Late_Stops   => Left.Late_Stops + Right.Late_Stops,
       Slowest_Stop =>
         Duration'Max (Left.Slowest_Stop, Right.Slowest_Stop),
       Growth       => Natural'Max (Left.Growth, Right.Growth)));

   function Address (W : World) return String is
     (if W.The_Plan.Through_Link then Network_Links.Supervisor_Side
      else Loopback);

   function Pid (W : World) return Interfaces.C.int is (W.Supervisor.Pid);

   function Is_Built (W : World) return Boolean is (W.Port > 0);

   procedure Build (W : in out World; P : Plan) is
   begin
      W.Destroy;
      W.The_Plan := P;
      if P.Through_Link and then The_Link.Namespace = "" then
         The_Link.Make;
      end if;
      W.Emulator.Start
        (Camera   => True,
         Options  => "--camera-fps " & Images_A_Second
           & " --frame-size " & Images
           & " " & To_String (P.Emulator_Options),
         Terminal => P.Terminal);
      W.Start_Supervisor;
   end Build;

   procedure Start_Supervisor (W : in out World) is
      Camera  : constant String :=
        (if W.The_Plan.Camera = "" then W.Emulator.Camera_Url
         else To_String (W.The_Plan.Camera));
      Options : constant String :=
        "--serial " & W.Emulator.Device & " --camera " & Camera
        & " --frame-size " & Images & " --log-level debug "
        & To_String (W.The_Plan.Options);
      Port    : Natural;
      Ready   : Boolean := False;
   begin
      W.Port := 0;
      W.Expected_End := False;
      W.Present := False;
      if W.The_Plan.Log_Is_Read then
         W.Supervisor.Start
           (Options,
            To_String (W.The_Plan.Launcher), To_String (W.The_Plan.Program),
            W.Address);
         Port := W.Supervisor.Port;
      else
         Port := Free_Port;
         W.Supervisor.Run
           ("--bind " & W.Address & " --port"
            & Port'Image & " " & Options,
            To_String (W.The_Plan.Launcher), To_String (W.The_Plan.Program));
         for Attempt in 1 .. 500 loop
            Ready := Monitor_Clients.Connects (Port, W.Address);
            exit when Ready;
            delay 0.02;
         end loop;
         Check (Ready, "the supervisor does not listen");
      end if;
      W.Port := Port;

      --  with all features, so that all resources are allocated
      W.Begin_Session (Moving, Camera_Closed);
      if W.The_Plan.Camera = "" then
         W.Order ("COPN", "AACK");
         W.Order ("CPCO", "AACK");
         W.Talk (0.4, Calm => True);
         W.Expect_Answers;
         W.Order ("CASA", "CIMG ANAK");
         W.Say ("CAIN");
         W.Order ("CPST", "AACK");
         W.Order ("CCLS", "AACK");
      else
         --  OpenCV is loaded, at least
         W.Order ("COPN", "AACK ANAK");
         W.Order ("CCLS", "AACK");
      end if;
      W.Lose (Orderly);
      W.Await_Standing;
      W.Join (Return_Limit + Noise);
      W.Lose (Orderly);
      Note_Facts (W);
   end Start_Supervisor;

   procedure Note_Facts (W : in out World) is
      use Process_Facts;
      Deadline : constant Instant := Now + Settle_Limit;
      Same     : Natural := 0;
   begin
      --  a second without a change: connections still closing are not counted
      while Same < 50 and then Now < Deadline loop
         if Threads (W.Pid) = W.Base_Threads
           and then Descriptors (W.Pid) = W.Base_Descriptors
         then
            Same := Same + 1;
         else
            Same := 0;
            W.Base_Threads := Threads (W.Pid);
            W.Base_Descriptors := Descriptors (W.Pid);
         end if;
         delay 0.02;
      end loop;
      W.Base_Memory := Resident_Kilobytes (W.Pid);
   end Note_Facts;

   procedure Expect_No_Leaks (W : in out World) is
      use Process_Facts;
      Deadline : constant Instant := Now + Settle_Limit;
      Late     : Boolean;
   begin
      loop
         Late := Now > Deadline;
         exit when Threads (W.Pid) = W.Base_Threads
           and then Descriptors (W.Pid) = W.Base_Descriptors;
         if Late then
            W.Violate
              (Nothing_Leaks,
               Threads (W.Pid)'Image & " threads instead of"
               & W.Base_Threads'Image & ","
               & Descriptors (W.Pid)'Image & " descriptors instead of"
               & W.Base_Descriptors'Image);
            exit;
         end if;
         delay 0.02;
      end loop;
      W.Figures.Growth := Integer'Max
        (W.Figures.Growth, Resident_Kilobytes (W.Pid) - W.Base_Memory);
      if W.Figures.Growth > Memory_Growth then
         W.Violate
           (Nothing_Leaks,
            Resident_Kilobytes (W.Pid)'Image & " kB of memory, after"
            & W.Base_Memory'Image & " kB in the beginning");
      end if;
   end Expect_No_Leaks;

   procedure Destroy (W : in out World) is
   begin
      W.Monitor.Close;
      W.Present := False;
      W.Nobody_Since := Never;
      W.Supervisor.Stop;
      W.Emulator.Stop;
      W.Port := 0;
   end Destroy;

   function Closed (W : World) return Boolean is
      --  By the supervisor
      use type Monitor_Clients.Closing;
   begin
      return W.Monitor.Closed_By_Peer (0.0) /= Monitor_Clients.Open;
   end Closed;

   procedure Join (W : in out World; Within : Duration) is
      Deadline : constant Instant := Now + Within;
      Late     : Boolean;
   begin
      W.Await_Standing;
      loop
         Late := Now > Deadline;
         Answer_Ledgers.Clear (W.Ledger);
         W.Read := 0;
         W.Session_Log := W.Supervisor.Log_Length;
         begin
            W.Monitor.Connect
              (W.Port, W.Address,
               Receive_Buffer => W.The_Plan.Receive_Buffer,
               Namespace      =>
                 (if W.The_Plan.Through_Link then The_Link.Namespace else ""),
               Real_Time      => False);
            W.Present := True;
            W.Nobody_Since := Never;
            --  a rejected client gets a message, an admitted one an answer
            W.Say ("MSSG:hello", Silent);
            W.Say ("nope", Refused);
            while W.Present and then not Is_Complete (W.Ledger)
              and then not Is_Broken (W.Ledger)
              and then Now < Deadline + Return_Limit
            loop
               delay 0.001;
               W.Listen;
            end loop;
            exit when W.Present
              and then (Is_Complete (W.Ledger) or else Is_Broken (W.Ledger));
         exception
            when Failed =>
               if Late then
                  W.Present := False;
                  raise;
               end if;
         end;
         W.Present := False;
         Check
           (not Late,
            "no monitor is admitted within " & Milliseconds (Within));
         delay 0.02;
      end loop;
   end Join;

   procedure Try_To_Join (W : in out World) is
   begin
      if not W.Present and then W.Reachable and then not W.Expected_End then
         W.Join (Return_Limit);
      end if;
   exception
      when Failed =>
         W.Monitor.Close;
   end Try_To_Join;

   procedure Take
     (W     : in out World;
      Item  : out Monitor_Clients.Message;
      Found : out Boolean)
   is
      --  The next message, for the ledger and for Item. If there is none and
      --  the connection is closed, the session has ended.
      Was_Closed : Boolean;
   begin
      Item := (others => <>);
      Found := False;
      if W.Present then
         Was_Closed := Closed (W);
         if W.Read < W.Monitor.Count then
            W.Read := W.Read + 1;
            Item := W.Monitor.Element (W.Read);
            Put_Message (W.Ledger, Item);
            Found := True;
         elsif Was_Closed then
            Forget_Session (W);
            if W.Nobody_Since = Never then
               W.Nobody_In_Command;
            end if;
         end if;
      end if;
   end Take;

   procedure Listen (W : in out World) is
      Unused : Monitor_Clients.Message;
      Found  : Boolean;
   begin
      loop
         Take (W, Unused, Found);
         exit when not Found;
      end loop;
   end Listen;

   procedure Say (W : in out World; Command : String) is
   begin
      W.Say (Command, Kind_Of (Command));
   end Say;

   procedure Say (W : in out World; Line : String; Answer : Answer_Kind) is
   begin
      W.Listen;
      if W.Present then
         Put_Command (W.Ledger, Line, Answer);
         if not W.Monitor.Try_Send (Line & ASCII.LF) then
            W.Listen;
            if W.Present then
               Forget_Session (W);
            end if;
         end if;
      end if;
   end Say;

   procedure Say_Bytes (W : in out World; Bytes : String) is
   begin
      if W.Present and then not W.Monitor.Try_Send (Bytes) then
         W.Listen;
         if W.Present then
            Forget_Session (W);
         end if;
      end if;
   end Say_Bytes;

   procedure Expect_Answers
     (W : in out World; Within : Duration := Answer_Limit)
   is
      Deadline : constant Instant := Now + Within;
      Late     : Boolean;
   begin
      loop
         Late := Now > Deadline;
         W.Listen;
         exit when not W.Present or else Is_Complete (W.Ledger)
           or else Is_Broken (W.Ledger);
         Check
           (not Late,
            "after " & Milliseconds (Within) & " without an answer: "
            & First_Waiting (W.Ledger) & ", and all of the"
            & Waiting (W.Ledger)'Image & " since");
         delay 0.001;
      end loop;
   end Expect_Answers;

   procedure Try_Order (W : in out World; Command, Answer : String) is
      --  As Order, but with Robot_Silent
      Second_Look : constant Duration := 0.3;
      --  The first ATIM may have been the unsolicited one
      Deadline    : Instant := Now + Answer_Limit;
      Late        : Boolean;
      Item        : Monitor_Clients.Message;
      Found       : Boolean;
      Timed_Out   : Boolean := False;
   begin
      W.Expect_Answers;
      W.Say (Command);
      loop
         Late := Now > Deadline;
         Take (W, Item, Found);
         Check
           (not Is_Broken (W.Ledger),
            "not answered exactly once: " & Complaint (W.Ledger));
         Check (W.Present, "no session any more for " & Command);
         if Found and then Is_Complete (W.Ledger) then
            if Index (Answer, Item.Label) > 0 then
               return;
            elsif Item.Label = "ATIM" then
               if not Timed_Out then
                  Timed_Out := True;
                  Deadline := Now + Second_Look;
               end if;
            elsif Is_Answer (Kind_Of (Command), Item.Label) then
               if Item.Label = "ANAK" and then Log_Says (W, "robot lost") > 0
               then
                  raise Robot_Silent;
               end if;
               raise Failed with Command & " was answered " & Item.Label
                 & " instead of " & Answer;
            end if;
         elsif not Found then
            if Late and then Timed_Out then
               raise Robot_Silent;
            end if;
            Check (not Late, "no answer to " & Command);
            delay 0.001;
         end if;
      end loop;
   end Try_Order;

   procedure Order (W : in out World; Command, Answer : String) is
   begin
      Try_Order (W, Command, Answer);
   exception
      when Robot_Silent =>
         raise Failed with Command & " had no answer from the robot instead"
           & " of " & Answer;
   end Order;

   procedure Begin_Session
     (W : in out World; Robot : Robot_Situation; Camera : Camera_Situation)
   is
   begin
      W.Robot := Robot;
      W.Camera := Camera;
      if not W.Present then
         W.Join (Return_Limit + Noise);
      end if;
      W.Bring_To (Robot);
      if Camera > Camera_Closed then
         W.Order ("COPN", "AACK");
      end if;
      case Camera is
         when Camera_Closed | Streaming =>
            null;
         when With_Position =>
            W.Order ("CPCO", "AACK");
         when Arena_Asked =>
            W.Order ("CASA", "CIMG ANAK");
         when Arena_Kept =>
            W.Order ("CASA", "CIMG ANAK");
            W.Say ("CACO");
      end case;
   end Begin_Session;

   procedure Bring_To (W : in out World; Robot : Robot_Situation) is
   begin
      for Attempt in 1 .. Line_Attempts loop
         begin
            if Robot >= Line_Open then
               Try_Order (W, "ROPN", "AACK");
            end if;
            case Robot is
               when Line_Closed | Line_Open =>
                  null;
               when Started | Moving =>
                  Try_Order (W, "RSOW", "AACK");
               when Started_With_Watchdog | Moving_With_Watchdog =>
                  Try_Order (W, "RSWW", "AACK");
            end case;
            if Robot >= Moving then
               Try_Order
                 (W,
                  (case Whole (W.Source, 1, 4) is
                      when 1 => "RGFW",
                      when 2 => "RGBW",
                      when 3 => "RGLF",
                      when others => "RGRI"), "AACK");
               W.Expect_Status
                 ("moving", "1", Within => Return_Limit);
            end if;
            exit;
         exception
            when Robot_Silent =>
               W.Figures.Repeated := W.Figures.Repeated + 1;
               Check
                 (Attempt < Line_Attempts,
                  "the robot's answers are late, again and again");
               W.Say ("RCLS");
               W.Expect_Answers;
               delay Line_Pause;
         end;
      end loop;
   end Bring_To;

   procedure Talk
     (W : in out World; For_Time : Duration; Calm : Boolean := False)
   is
      Deadline : constant Instant := Now + For_Time;
   begin
      loop
         if Calm then
            W.Say
              (Calm_Words.Element
                 (Whole (W.Source, 1, Natural (Calm_Words.Length))));
         else
            W.Say
              (All_Words.Element
                 (Whole (W.Source, 1, Natural (All_Words.Length))));
         end if;
         exit when Now >= Deadline;
         delay Duration'Min
           (Span (W.Source, 0.005, 0.1),
            Duration'Max (0.0, Deadline - Now));
      end loop;
   end Talk;

   procedure Forget_Session (W : in out World) is
      Deadline : constant Instant := Now + Settle_Limit;
   begin
      W.Present := False;
      if Is_Broken (W.Ledger) then
         W.Violate (Answered_Once, Complaint (W.Ledger));
      elsif W.The_Plan.Log_Is_Read
        and then Unasked_Losses (W.Ledger) > Log_Says (W, "robot lost")
      then
         --  the log may be behind: it is written by a task of the lowest
         --  priority
         while Unasked_Losses (W.Ledger) > Log_Says (W, "robot lost")
           and then Now < Deadline
         loop
            delay 0.02;
         end loop;
         if Unasked_Losses (W.Ledger) > Log_Says (W, "robot lost") then
            W.Violate
              (Answered_Once,
               Unasked_Losses (W.Ledger)'Image & " ATIM came unasked, but"
               & " the robot was lost" & Log_Says (W, "robot lost")'Image
               & " times");
         end if;
      end if;
   end Forget_Session;

   procedure Lose
     (W         : in out World;
      How       : Manner;
      Detection : Duration := Loss_Limit) is
   begin
      W.Listen;
      if not W.Present then
         return;
      end if;
      Forget_Session (W);
      case How is
         when Orderly  => W.Monitor.Close;
         when Abortive => W.Monitor.Reset;
         when Silently => null;
      end case;
      W.Nobody_In_Command (Within => Detection + Stop_Limit);
      W.Found_By := Now + Detection;
   end Lose;

   procedure Nobody_In_Command
     (W      : in out World;
      Since  : Instant := Now;
      Within : Duration := Stop_Limit) is
   begin
      W.Nobody_Since := Since;
      W.Nobody_Limit := Within;
      W.Stop_Counted := False;
   end Nobody_In_Command;

   procedure Supervisor_Ends (W : in out World; Status : Integer) is
   begin
      W.Expected_End := True;
      W.Expected_Status := Status;
   end Supervisor_Ends;

   procedure End_Session (W : in out World) is
   begin
      W.Lose (Orderly);
   end End_Session;

   procedure Await_Standing (W : in out World) is
      Patience : constant Duration := 3.0;
      --  only to report the delay
      Limit    : constant Instant :=
        W.Nobody_Since + W.Nobody_Limit + Noise;
      Since    : constant Instant := W.Nobody_Since;
      Stop     : Instant := Never;
      Moved    : Boolean := False;
      Late     : Boolean;
      Usual    : Boolean;

      function Is_Movement (Text : String) return Boolean is
        (Text'Length > 2
         and then Text (Text'First) in 'M' | 'T'
         and then Text (Text'First + 2 .. Text'Last) not in "0" | "-0");

      function Stops (Text : String) return Boolean is
        (Text in "r" | "z"
         or else (Text'Length > 2
                  and then Text (Text'First) in 'M' | 'T'
                  and then not Is_Movement (Text)));
   begin
      if Since = Never or else not W.Line_Works then
         W.Nobody_Since := Never;
         return;
      end if;
      loop
         Late := Now > Limit + Patience;
         exit when W.Emulator.Status ("moving") = "0";
         if Late then
            W.Violate
              (Robot_Stands,
               "it still moves, " & Milliseconds (Now - Since)
               & " after nobody is in command; the machine stood still for "
               & Milliseconds (Standstills.Within (Since, Now)));
            W.Nobody_Since := Never;
            return;
         end if;
         delay 0.01;
      end loop;
      Late := Now > Limit;
      Usual := W.Nobody_Limit <= Stop_Limit + Loss_Limit;
      for Item of W.Emulator.Journal loop
         if Is_Movement (To_String (Item.Command)) then
            Stop := Never;
            Moved := True;
            if Item.First
              > Limit + Standstills.Within (Since, Item.First)
            then
               W.Violate
                 (Robot_Stands,
                  To_String (Item.Command) & " on the wire "
                  & Milliseconds (Item.First - Since)
                  & " after nobody is in command");
            end if;
         elsif Stop = Never and then Stops (To_String (Item.Command)) then
            Stop := Item.Last;
         end if;
      end loop;
      if Usual and then Moved and then Stop > Since
        and then not W.Stop_Counted
      then
         W.Stop_Counted := True;
         W.Figures.Stops := W.Figures.Stops + 1;
         if Stop - Since > W.Nobody_Limit then
            W.Figures.Late_Stops := W.Figures.Late_Stops + 1;
            Append
              (W.Remarks,
               "   it stood " & Milliseconds (Stop - Since)
               & " after nobody is in command; the machine stood still for "
               & Milliseconds (Standstills.Within (Since, Stop))
               & "; at the robot:"
               & ASCII.LF & W.Wire_Tail);
         end if;
         W.Figures.Slowest_Stop :=
           Duration'Max (W.Figures.Slowest_Stop, Stop - Since);
      end if;
      if Late and then Stop > Limit + Standstills.Within (Since, Stop) then
         W.Violate
           (Robot_Stands,
            "it stood only " & Milliseconds (Stop - Since)
            & " after nobody is in command");
         W.Nobody_Since := Never;
      end if;
   end Await_Standing;

   function Wire_Tail (W : in out World) return String is
      Shown  : constant := 12;
      Notes  : constant Emulators.Notes := W.Emulator.Journal;
      Result : Unbounded_String;
   begin
      for Number in Integer'Max (1, Notes.Last_Index - Shown + 1)
        .. Notes.Last_Index
      loop
         Append
           (Result,
            "   " & Milliseconds (Notes (Number).Last - Now) & " "
            & To_String (Notes (Number).Command) & " -> "
            & To_String (Notes (Number).Answer) & ASCII.LF);
      end loop;
      return To_String (Result);
   exception
      when Failed =>
         return "";
   end Wire_Tail;

   procedure Expect_Status
     (W : in out World; Key, Value : String; Within : Duration)
   is
      Start : constant Instant := Now;
   begin
      W.Emulator.Await_Status (Key, Value);
      Check_Within (Now - Start, Within, Key & " to become " & Value);
   end Expect_Status;

   procedure Expect_Log
     (W      : in out World;
      Text   : String;
      Within : Duration;
      After  : Natural := 0) is
   begin
      Check
        (W.Supervisor.Says (Text, Within, After),
         "in " & Milliseconds (Within) & " the log does not say " & Text);
   end Expect_Log;

   function Line_Was_Late (W : World) return Boolean is
     (Duration'Max
        (Standstills.Longest,
         (if W.The_Plan.Terminal then Standstills.Longest_Line else 0.0))
      >= Standstills.Too_Long);

   procedure Violate (W : in out World; Which : Invariant; Text : String) is
   begin
      W.Violate
        ((case Which is
             when Supervisor_Lives => "the supervisor lives: ",
             when Answered_Once    => "answered exactly once: ",
             when Robot_Stands     => "the robot stands: ",
             when Session_Works    => "a new session works: ",
             when Nothing_Leaks    => "nothing leaks: ") & Text,
         By =>
           (case Which is
               when Session_Works => A_Late_Line,
               when Robot_Stands  => A_Stopped_Machine,
               when Supervisor_Lives | Answered_Once | Nothing_Leaks =>
                  Nothing_Else));
   end Violate;

   procedure Violate
     (W : in out World; Text : String; By : Explanation := A_Late_Line) is
   begin
      W.Violations := W.Violations + 1;
      W.Explained_By := Explanation'Max (W.Explained_By, By);
      Append (W.Account, "   " & Trim (Text, Both) & ASCII.LF);
   end Violate;

end Worlds;
