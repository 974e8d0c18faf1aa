--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as the analysis sees it: which activity runs where, what
--  sets it off, what it calls; and the bounds that the features demand.

with Ada.Real_Time;
with System;
with Vision.Image_Grid;

package body Supervisor_Model with SPARK_Mode is

   use type Ada.Real_Time.Time_Span;
   use type Schedule.Task_Name;

   Max_Rounds : constant := 100;
   --  of jitters and bounds

   --  Times of the table, in microseconds

   One : constant Ada.Real_Time.Time_Span := Ada.Real_Time.Microseconds (1);

   Reload_Period  : constant Integer := Schedule.Reload_Period / One;
   Battery_Period : constant Integer := Schedule.Battery_Period / One;
   Ping_Period    : constant Integer := Schedule.Keep_Alive_Period / One;
   Link_Period    : constant Integer := Schedule.Link_Period / One;
   Byte_Time      : constant Integer := Schedule.Byte_Time / One;
   Reload_Quiet   : constant Integer := Schedule.Reload_Quiet / One;
   Newcomer_Interval : constant Integer := Schedule.Newcomer_Interval / One;
   Mission_Period : constant Integer := Schedule.Mission_Period / One;
   Mission_Limit  : constant Integer := Schedule.Mission_Order_Limit / One;

   Image_Period   : constant := 100_000;  --  F15
   Order_Limit    : constant := 100_000;  --  F12, to the last byte
   Longest_Own    : constant Span := 20_000;
   --  that a task needs in an exchange; one that needs more has no bound

   pragma Compile_Time_Error
     (2 * Camera_Interval > Image_Period,
      "not always the newest image is taken: see Vision.Image_Grid");

   subtype Mission_Name is Activity_Name range Mission_Begin .. Mission_Told;

   subtype Mission_Look is Mission_Name range Mission_Due .. Mission_Seen;

   subtype Mission_Under_Way is Activity_Name
   with Static_Predicate =>
     Mission_Under_Way in Send_Mission | Mission_Due .. Mission_Told;

   function To_Span (Value : Integer) return Span is
     (if Value in 0 .. Horizon then Span (Value) else Horizon);

   function To_Period (Value : Integer) return Positive_Span is
     (if Value in 1 .. Horizon then Positive_Span (Value) else Horizon);

   function Capped (Value : Microseconds) return Span is
     (if Value <= Horizon then Value else Horizon);

   function Frame_Time (Length : Natural) return Span is
     (Capped (Microseconds (Length) * To_Span (Byte_Time)))
   with Pre => Length <= 1_000;

   function Line_Interval return Positive_Span is
     (Positive_Span'Max (1, Frame_Time (2 * Short_Frame)));
   --  From one exchange to the next: no sooner than the line has carried a
   --  command and an answer

   function Commands_Apart (Under : Load) return Positive_Span is
     (if Under.Mission then Question_Interval else Under.Commands);

   function Ceiling_Of (Which : Operation_Name) return Urgency is
     (Urgency
        (case Which is
            when Outbox_Operation | Outbox_Take => Schedule.Outbox_Ceiling,
            when Line_Operation     => Schedule.Line_Ceiling,
            when Turn_Operation     => Schedule.Turn_Ceiling,
            when Vision_Operation   => Schedule.Vision_Ceiling,
            when Session_Operation  => Schedule.Session_Ceiling,
            when Journal_Operation  => Schedule.Journal_Ceiling));

   function Stays_Here (Name : Activity_Name) return Boolean is
     (Name in Line_Request | Reload_Due | Reload_Done | Battery_Due
        | Ping_Due | Ping_Done);

   function Is_Spaced (Name : Activity_Name) return Boolean is
     (Name in Line_Answer | Newcomer | Send_Look);
   --  However late one is, from its end to the next is a period: the line
   --  carries an exchange in between, or the next is reckoned from the clock
   --  as read at the end of this one, but for its Tail

   function Latest (Item : Bound) return Span is
     (if Item.Exists then Item.Finish else Horizon);
   --  What it sets off can come as late as this

   function Latest_Answered
     (Item : Bound; Period : Positive_Span) return Span
   is (Span'Min (Latest (Item), Period));
   --  The same where the next is asked only after the answer: then no more
   --  than one is late

   function Latest_Answer (Line : Line_Bounds) return Span is
     (Span'Max
        (Latest (Line (Stop_Order)),
         Span'Max (Latest (Line (Movement)), Latest (Line (Other_Order)))));
   --  From a command to its answer

   function Budget_Of (Name : Activity_Name; On : Machine) return Span is
     (Capped
        ((if On.Second then Measured (Name) (Second)
          else Processor_Time (Name))
         * On.Percent / 100));

   type Member_Set is array (Activity_Name) of Boolean;

   function Task_Of (Name : Task_Activity) return Schedule.Task_Name is
     (case Name is
         when Stop            => Schedule.Th_Stop,
         when Line_Request .. Line_Open  => Schedule.Th_Move,
         --  and every other task that uses the line
         when Reload_Due | Reload_Done   => Schedule.Th_Start_Robot_WD,
         when Newcomer        => Schedule.Th_Server,
         when Receive         => Schedule.Th_Receive_From_Mon,
         when Loss            => Schedule.Th_Com_Mon_Perdue,
         when Send_Look .. Send_Image    => Schedule.Th_Send_To_Mon,
         when Battery_Due | Battery_Done => Schedule.Th_Battery_Level,
         when Ping_Due | Ping_Done       => Schedule.Th_Open_Com_Robot,
         when Mission_Name    => Schedule.Th_Mission,
         when Camera_Order | Camera_Answer => Schedule.Th_Camera_Control,
         when Capture         => Schedule.Th_Capture_Img,
         when Arena           => Schedule.Th_Arene,
         when Camera          => Schedule.Th_Camera,
         when Console         => Schedule.Th_Console);

   function Priority_Of
     (Name : Activity_Name; Choice : Priority_Choice) return Urgency is
   begin
      if Name = Kernel then
         return Urgency (System.Any_Priority'Last);
      elsif Name = Environment then
         return Urgency (Schedule.Main_Priority);
      end if;
      declare
         Item : Schedule.Row renames Schedule.Table (Task_Of (Name));
      begin
         return Urgency
           (if Choice = Of_The_Report
              and then Item.Report /= Schedule.No_Thread
            then Item.Report
            else Item.Priority);
      end;
   end Priority_Of;

   function Task_Name (Name : Activity_Name) return String is
     (if Name = Kernel then "(kernel)"
      elsif Name = Environment then "(main)"
      else Schedule.Name_Of (Task_Of (Name)));

   function Ceilings_Hold (Choice : Priority_Choice) return Boolean is
     (for all A in Activity_Name =>
        (for all O in Operation_Name =>
           (if Calls (A, O) > 0
            then Priority_Of (A, Choice) <= Ceiling_Of (O))));

   function Period_Of (Name : Activity_Name; Under : Load)
     return Positive_Span
   is
     (case Name is
         when Kernel => Tick_Interval,
         when Newcomer =>
           (if Under.Flood then To_Period (Newcomer_Interval)
            else Session_Interval),
         when Stop | Environment | Line_Open | Mission_Begin
            | Camera_Order | Camera_Answer =>
            Session_Interval,
         when Line_Request | Line_Answer => Line_Interval,
         when Reload_Due | Reload_Done => To_Period (Reload_Period),
         when Line_Outcome | Receive | Send_Answer => Commands_Apart (Under),
         when Loss => To_Period (Link_Period),
         when Send_Look => Answer_Gap,
         when Send_Battery | Battery_Due | Battery_Done =>
            To_Period (Battery_Period),
         when Mission_Due => To_Period (Mission_Period),
         when Mission_Told =>
            Positive_Span'Max (1, Capped (Mission_Pause + Line_Interval)),
         when Send_Position | Send_Image | Capture | Mission_Seen
            | Send_Mission =>
            --  where the grid makes up for what it has lost
            --  (Vision.Image_Grid). A leg ends with a position
            Positive_Span (Vision.Image_Grid.Shortest (Image_Period)),
         when Ping_Due | Ping_Done => To_Period (Ping_Period),
         when Arena => Arena_Interval,
         when Camera => Camera_Interval,
         when Console => Command_Interval);

   function Processor_Of
     (Name : Activity_Name; Where : Placement; On : Machine)
      return Processor_Number
   is
     (if Where = One_Processor then 1
      elsif Name in Capture | Console | Environment then 2
      elsif Name = Arena then (if On.Many then 3 else 2)
      elsif Name = Camera then (if On.Many then 4 else 2)
      else 1);

   function Calls (Name : Activity_Name; Which : Operation_Name)
     return Natural
   is
     (case Which is
         when Outbox_Operation =>
           (case Name is
               when Line_Outcome | Battery_Done | Loss | Newcomer
                  | Mission_Look => 1,
               when Line_Answer | Receive | Camera_Order | Camera_Answer => 2,
               when Capture | Arena => 3,
               when Mission_Begin => 4,
               when others => 0),
         when Outbox_Take =>
           (case Name is
               when Send_Look => 1,
               --  and again when it has been sent: that, and what is next
               when Send_Answer .. Send_Image => 2,
               when others => 0),
         when Line_Operation =>
           (case Name is
               when Line_Request | Line_Answer | Line_Outcome | Reload_Due
                  | Reload_Done | Battery_Due | Battery_Done | Ping_Due
                  | Ping_Done | Receive => 1,
               when Loss => 2,
               when Stop | Mission_Look => 3,
               when Mission_Begin => 5,
               --  with the first look
               when others => 0),
         when Turn_Operation =>
           (case Name is
               when Receive | Loss | Mission_Look => 1,
               when Mission_Begin | Camera_Order | Camera_Answer | Arena =>
                 2,
               when others => 0),
         when Vision_Operation =>
           (case Name is
               when Stop => 1,
               when Mission_Look | Camera_Order | Camera_Answer => 3,
               when Loss => 4,
               when Arena => 5,
               when Mission_Begin => 6,
               when Camera | Capture => 8,
               --  with a look that finds no image; with the end of a camera
               when others => 0),
         when Session_Operation =>
           (case Name is
               when Stop | Loss => 2,
               when Newcomer => 9,
               when others => 0),
         when Journal_Operation =>
           (case Name is
               when Mission_Look => 1,
               when Mission_Begin => 2,
               when Line_Answer .. Line_Open | Receive | Loss => 3,
               --  the longest line
               when Stop => 5,
               when Console => 2,
               when Newcomer => Schedule.Refusals_Logged + 4,
               when others => 0));

   procedure Fill
     (Choice : Priority_Choice;
      Where  : Placement;
      On     : Machine;
      Under  : Load;
      Set    : out Activity_Set)
   is
      --  Everything but the jitters, and what comes of responses
      subtype Operations is Operation_Index range
        1 .. Operation_Name'Pos (Operation_Name'Last) + 1;

      Sections : Section_Array (Row_Index, Operations) :=
        (others => (others => 0));
      Ceilings : Ceiling_Array (Operations) := (others => 0);
      Lower    : Span;
      Far      : Microseconds;
      Wait     : Microseconds;

      subtype Image_Processor is Processor_Number range 1 .. 4;

      type Object_Name is
        (Outbox, Line, Turns, Vision, Session, Journal);

      function Object_Of (Which : Operation_Name) return Object_Name is
        (case Which is
            when Outbox_Operation | Outbox_Take => Outbox,
            when Line_Operation     => Line,
            when Turn_Operation     => Turns,
            when Vision_Operation   => Vision,
            when Session_Operation  => Session,
            when Journal_Operation  => Journal);

      function Longest_At
        (Where_Else : Processor_Number;
         Object     : Object_Name;
         Here       : Processor_Number) return Span
      with Global => (Input => (Set, Sections))
      is
         --  The longest section in the object on another processor than Here
         Result : Span := 0;
      begin
         if Where_Else /= Here then
            for A in Activity_Name loop
               if Set (Row (A)).Processor = Where_Else then
                  for O in Operation_Name loop
                     if Object_Of (O) = Object then
                        Result := Span'Max
                          (Result,
                           Sections (Row (A), Operation_Name'Pos (O) + 1));
                     end if;
                  end loop;
               end if;
            end loop;
         end if;
         return Result;
      end Longest_At;

   begin
      Set := (others => <>);
      for A in Activity_Name loop
         for O in Operation_Name loop
            if Calls (A, O) > 0 then
               Sections (Row (A), Operation_Name'Pos (O) + 1) :=
                 Capped (Operation_Time (O) * On.Percent / 100);
            end if;
         end loop;
         Set (Row (A)) :=
           (Processor => Processor_Of (A, Where, On),
            Priority  => Priority_Of (A, Choice),
            Period    => Period_Of (A, Under),
            Jitter    => 0,
            Budget    =>
              (if A in Mission_Under_Way and then not Under.Mission then 0
               else Budget_Of (A, On)),
            Suspension => 0,
            Deferral  => 0,
            Tail      =>
              (case A is
                  --  the last of its lines of the log
                  when Newcomer  => Budget_Of (A, On)
                    / (Schedule.Refusals_Logged + 4),
                  when Send_Look => Budget_Of (A, On) / 2,
                  when others    => 0),
            Blocking  => 0);
      end loop;

      --  the kernel on the other processors
      if Where = Real_Time_Apart then
         for Other in Row_Index range
           Row (Activity_Name'Last) + 1 .. Row_Index'Last
         loop
            if On.Many or else Other = Row (Activity_Name'Last) + 1 then
               Set (Other) := Set (Row (Kernel));
               Set (Other).Processor :=
                 Other - Row (Activity_Name'Last) + 1;
            end if;
         end loop;
      end if;

      for O in Operation_Name loop
         Ceilings (Operation_Name'Pos (O) + 1) := Ceiling_Of (O);
      end loop;

      for A in Activity_Name loop
         Lower := Ceiling_Blocking (Set, Sections, Ceilings, Row (A));
         Wait := 0;
         for O in Operation_Name loop
            --  a task on each other processor may be in the object just
            --  then; and who sleeps for it lets a less urgent one in here
            Far := 0;
            for P in Image_Processor loop
               Far := Far
                 + Longest_At (P, Object_Of (O), Set (Row (A)).Processor);
               pragma Loop_Invariant
                 (Far <= Microseconds (P) * Horizon);
            end loop;
            if Far > 0 and then not Stays_Here (A) then
               Wait := Wait + Microseconds (Calls (A, O)) * (Far + Lower);
            end if;
            pragma Loop_Invariant
              (Wait <= Microseconds (Operation_Name'Pos (O) + 1)
                 * (20 * 5 * Horizon));
         end loop;
         Set (Row (A)).Suspension := Capped (Wait);
         if A /= Kernel then
            Set (Row (A)).Blocking := Capped (Under.Latency + Lower);
            if not Is_Spaced (A) then
               Set (Row (A)).Deferral := Under.Latency;
            end if;
         end if;
      end loop;
   end Fill;

   procedure Bound_Activity
     (Set : Activity_Set; Which : Row_Index; Result : out Bound)
   is
      --  Orders that have waited for the line have their outcomes late and
      --  together, as its jitter says; but no sooner than the line has carried
      --  them. Of the bounds by the one and by the other the lower holds
      Paced : Activity_Set := Set;
      Other : Bound;
   begin
      Pre_Emptive_Bound (Set, Which, Result);
      if Which /= Row (Line_Outcome) then
         Paced (Row (Line_Outcome)).Period := Line_Interval;
         Paced (Row (Line_Outcome)).Jitter := 0;
         Paced (Row (Line_Outcome)).Deferral := 0;
         Pre_Emptive_Bound (Paced, Which, Other);
         if not Result.Exists then
            Result := Other;
         elsif Other.Exists then
            Result :=
              (Exists => True,
               Start  => Span'Min (Result.Start, Other.Start),
               Finish => Span'Min (Result.Finish, Other.Finish),
               Local  => Span'Min (Result.Local, Other.Local),
               Releases => 0);
         end if;
      end if;
   end Bound_Activity;

   procedure Bound_Line
     (Bounds : Row_Bounds;
      Owner  : Owner_Array;
      Under  : Load;
      Length : out Line_Times;
      Line   : out Line_Bounds)
   is
      function Own (Who : Line_Client; Last : Bound) return Microseconds is
        (if Owner (Who).Request.Exists and then Last.Exists
         then Owner (Who).Request.Local + Last.Local
         else Horizon);
      --  Of the task that has the line, between two transactions

      function Exchange
        (Bytes : Natural; Who : Line_Client; Last : Bound) return Span
      is
        (Capped
           (Frame_Time (Bytes + Short_Frame) + Under.Turnaround
            + Own (Who, Last)))
      with Pre => Bytes <= 100;

      subtype Client_Index is Activity_Index range
        1 .. Line_Client'Pos (Line_Client'Last) + 1;
      subtype Client_Set is Activity_Array (Client_Index);

      function Index (Who : Line_Client) return Client_Index is
        (Line_Client'Pos (Who) + 1);

      function Rank (Who : Line_Client) return Urgency is
        (Line_Client'Pos (Line_Client'Last) - Line_Client'Pos (Who) + 1);

      type Client_Times is array (Line_Client) of Span;

      Drive  : Span;   --  the longest stop or movement
      Order  : Span;   --  the longest of the monitor's orders
      Query  : Span;   --  the longest of those that do not end a mission
      Alone  : Bound;
      Behind : Bound;
      Beside : Bound;
      Silence : constant Span :=
        (if Under.Silent
         then Capped (Frame_Time (Longest_Frame) + Under.Time_Out
                      + Own (Unanswered, Owner (Unanswered).Outcome))
         else 0);
      Resumed : constant Span :=
        (if Under.Silent
         then Capped
           (Silence
            + Exchange
                (Probe_Frames, Unanswered, Owner (Unanswered).Answer))
         else 0);
      --  a stop does not wait for the probe
      Quiet   : constant Span :=
        (if Under.Silent then 0 else To_Span (Reload_Quiet));
      --  the exchange that is not answered may be a movement: begun even
      --  when the reload is nearly due

      function Asked_Apart return Positive_Span is
        (Positive_Span'Max
           (1, Span'Min (Horizon / 2,
                         Capped (Mission_Pause + Length (Mission)))));
      --  From one request of a mission to the next, on the average

      procedure Bound_One
        (Who : Line_Client; Lengths : Client_Times; Result : out Bound)
      with Global => (Bounds, Under, Length)
      is
         --  Of Who, where each client's transactions have these lengths; 0 for
         --  one that does not occur
         Clients : Client_Set := (others => <>);
      begin
         for C in Line_Client loop
            Clients (Index (C)) :=
              (Processor => 1,
               Priority  => Rank (C),
               Period    =>
                 (case C is
                     when Safe_State => Session_Interval,
                     when Reload     => To_Period (Reload_Period),
                     when Battery    => To_Period (Battery_Period),
                     when Ping       => To_Period (Ping_Period),
                     when Unanswered => Horizon,
                     when Mission    =>
                       (if Who = Mission then Horizon else Asked_Apart),
                     when others     => Commands_Apart (Under)),
               Jitter    =>
                 (case C is
                     when Safe_State  => Latest (Bounds (Loss)),
                     when Stop_Order | Movement | Other_Order =>
                        Latest (Bounds (Receive)),
                     when Reload      => Latest (Bounds (Reload_Due)),
                     when Mission     =>
                       (if Who = Mission then 0 else 2 * Asked_Apart),
                     --  a small turn, a question, a drive and a question
                     --  follow each other at once; then come two images
                     when Battery     => Latest (Bounds (Battery_Due)),
                     when Ping        => Latest (Bounds (Ping_Due)),
                     when Unanswered  => 0),
               Budget    => Lengths (C),
               Suspension => 0,
               Deferral  => 0,
               Tail      => 0,
               Blocking  => 0);
         end loop;
         Transaction_Bound (Clients, Index (Who), Result);
      end Bound_One;

      procedure Bound_Mission (Result : out Bound)
      with Global => (Bounds, Under, Length, Query)
      is
         --  From its request on: only one waits
         --  One that comes in the quiet zone waits for the reload, and until
         --  the next is known; and for what had begun before
         Zone  : Span;
         Until_Known : constant Microseconds :=
           Latest (Bounds (Reload_Due)) + Length (Reload)
           + (if Bounds (Reload_Done).Exists then Bounds (Reload_Done).Local
              else Horizon);
      begin
         Bound_One
           (Mission,
            (Safe_State | Stop_Order | Movement | Unanswered => 0,
             Reload      => Length (Reload),
             Mission     => Length (Mission),
             Battery     => Length (Battery),
             Other_Order => Query,
             Ping        => Length (Ping)),
            Result);
         Zone := Capped
           (Span'Max (To_Span (Reload_Quiet), Span'Max (Query, Length (Ping)))
            + Until_Known);
         Result.Start := Span'Min
           (Span'Max (Result.Start, Zone), To_Span (Mission_Limit));
         Result.Finish := Capped (Result.Start + Length (Mission));
         Result.Local := Result.Finish;
      end Bound_Mission;

      procedure Keep_Later (Item : Bound; Result : in out Bound)
      with Global => null
      is
         --  Result holds in this case, too
      begin
         if Item.Exists and then Result.Exists then
            Result :=
              (Exists   => True,
               Start    => Span'Max (Item.Start, Result.Start),
               Finish   => Span'Max (Item.Finish, Result.Finish),
               Local    => Span'Max (Item.Local, Result.Local),
               Releases => 0);
         else
            Result := (others => <>);
         end if;
      end Keep_Later;

   begin
      Length :=
        (Safe_State  => Exchange
           (Stop_Frame, Safe_State, Owner (Safe_State).Answer),
         Stop_Order  => Exchange
           (Stop_Frame, Stop_Order, Owner (Stop_Order).Answer),
         Movement    => Exchange
           (Longest_Frame, Movement, Owner (Movement).Outcome),
         Mission     =>
           (if Under.Mission
            then Exchange (Mission_Frame, Mission, Owner (Mission).Answer)
            else 0),
         Other_Order => Capped
           (Exchange (Stop_Frame, Other_Order, Owner (Other_Order).Answer)
            + Exchange
                (Short_Frame, Other_Order, Owner (Other_Order).Outcome)),
         --  what ends the robot's run stops it first
         Reload      => Exchange
           (Short_Frame, Reload, Owner (Reload).Outcome),
         Battery     => Exchange
           (Short_Frame, Battery, Owner (Battery).Outcome),
         Ping        => Exchange (Short_Frame, Ping, Owner (Ping).Outcome),
         Unanswered  => 0);
      Drive := Span'Max (Length (Stop_Order), Length (Movement));
      Order := Span'Max (Drive, Length (Other_Order));
      Query := Length (Battery);
      --  the least urgent task that carries out one

      --  The monitor's orders are one stream: where one is analysed, or has
      --  the line, the next is no nearer than Command_Interval. So the
      --  stream appears once in each set, at its most urgent; where others
      --  may be in progress they appear below as well.
      --
      --  An order by hand ends the mission, and what that has asked for is
      --  not sent any more. So for what is more urgent than a mission one of
      --  its requests may be in progress, and for a mission itself only
      --  questions. What is less urgent waits for all its requests, for
      --  questions, and for one order by hand (here as urgent as Safe_State,
      --  and as rare).

      Line := (others => <>);

      Bound_One
        (Safe_State,
         (Safe_State  => Length (Safe_State),
          Stop_Order  => 0,
          Reload      => Length (Reload),
          Movement    => 0,
          Mission     => Length (Mission),
          Battery     => Length (Battery),
          Other_Order => Order,
          Ping        => Length (Ping),
          Unanswered  => Silence),
         Line (Safe_State));

      Bound_One
        (Stop_Order,
         (Safe_State | Movement | Other_Order => 0,
          Stop_Order  => Drive,
          Reload      => Length (Reload),
          Mission     => Length (Mission),
          Battery     => Length (Battery),
          Ping        => Length (Ping),
          Unanswered  => Silence),
         Line (Stop_Order));

      --  The reload waits for an order begun before it is due, which may be
      --  a mission's stop, and for stops; or before these also for one
      --  exchange that had begun when the quiet zone did
      Bound_One
        (Reload,
         (Safe_State | Movement | Mission | Battery | Other_Order => 0,
          Stop_Order  => Length (Stop_Order),
          Reload      => Length (Reload),
          Ping        => Capped
            (Span'Max (Length (Ping), Length (Mission))
             + Drive - Length (Stop_Order)),
          Unanswered  => Resumed),
         Behind);
      Bound_One
        (Reload,
         (Safe_State | Movement | Mission | Battery | Other_Order | Ping => 0,
          Stop_Order  => Drive,
          Reload      => Length (Reload),
          Unanswered  => Resumed),
         Alone);
      Bound_One
        (Reload,
         (Safe_State | Movement | Battery | Other_Order | Ping => 0,
          Stop_Order  => Length (Stop_Order),
          Reload      => Length (Reload),
          Mission     => Span'Min (Length (Stop_Order), Length (Mission)),
          Unanswered  => Resumed),
         Beside);
      if Behind.Exists then
         Line (Reload) :=
           (Exists => True,
            Start  => Span'Max (Behind.Start, Quiet) - Quiet,
            Finish => Span'Max (Behind.Finish, Quiet) - Quiet,
            Local  => Span'Max (Behind.Local, Quiet) - Quiet,
            Releases => 0);
         Keep_Later (Alone, Line (Reload));
         Keep_Later (Beside, Line (Reload));
      end if;

      Bound_One
        (Movement,
         (Safe_State | Stop_Order | Other_Order => 0,
          Reload      => Length (Reload),
          Movement    => Drive,
          Mission     => Length (Mission),
          Battery     => Length (Battery),
          Ping        => Length (Ping),
          Unanswered  => Resumed),
         Line (Movement));

      Bound_Mission (Line (Mission));

      Bound_One
        (Battery,
         (Safe_State  => (if Under.Mission then Drive else 0),
          Stop_Order  => (if Under.Mission then 0 else Drive),
          Reload      => Length (Reload),
          Movement    => 0,
          Mission     => Length (Mission),
          Battery     => Length (Battery),
          Other_Order => Length (Other_Order),
          Ping        => Length (Ping),
          Unanswered  => Resumed),
         Line (Battery));

      Bound_One
        (Other_Order,
         (Safe_State  => (if Under.Mission then Order else 0),
          Stop_Order | Movement => 0,
          Reload      => Length (Reload),
          Mission     => Length (Mission),
          Battery     => Length (Battery),
          Other_Order => (if Under.Mission then Query else Order),
          Ping        => Length (Ping),
          Unanswered  => Resumed),
         Line (Other_Order));

      Bound_One
        (Ping,
         (Safe_State  => (if Under.Mission then Order else 0),
          Stop_Order  => (if Under.Mission then Query else Order),
          Reload      => Length (Reload),
          Movement | Other_Order => 0,
          Mission     => Length (Mission),
          Battery     => Length (Battery),
          Ping        => Length (Ping),
          Unanswered  => Resumed),
         Line (Ping));
   end Bound_Line;

   procedure Set_Jitters
     (Set     : in out Activity_Set;
      Bounds  : Row_Bounds;
      Line    : Line_Bounds;
      Under   : Load;
      Changed : out Boolean)
   is
      All_Answered : constant Boolean :=
        Line (Movement).Exists and then Line (Other_Order).Exists;
      --  Otherwise answers come as fast as the line works, however late

      Line_Period : constant Positive_Span := Line_Interval;
      Line_Jitter : constant Span := Latest (Bounds (Line_Answer));
      Line_End    : constant Span := Latest (Bounds (Line_Outcome));

      procedure Change (Which : Row_Index; Period : Positive_Span; To : Span)
      with Global => (In_Out => (Set, Changed))
      is
         --  To this jitter
      begin
         if Set (Which).Jitter /= To or else Set (Which).Period /= Period then
            Set (Which).Jitter := To;
            Set (Which).Period := Period;
            Changed := True;
         end if;
      end Change;

      procedure Change_Deferral (Which : Row_Index; To : Span)
      with Global => (In_Out => (Set, Changed))
      is
      begin
         if Set (Which).Deferral /= To then
            Set (Which).Deferral := To;
            Changed := True;
         end if;
      end Change_Deferral;

   begin
      Changed := False;
      for A in Activity_Name loop
         if A in Line_Outcome | Line_Open and then not All_Answered
         then
            Change (Row (A), Line_Period, Line_Jitter);
         elsif A = Send_Answer and then not All_Answered then
            --  as fast as the line works, and th_receiveFromMon's own
            Change
              (Row (A), Positive_Span'Max (1, Line_Period / 2),
               Capped (Line_Period
                       + Span'Max (Latest (Bounds (Receive)),
                                   Span'Max (Line_Jitter, Line_End))));
         else
            Change
              (Row (A), Set (Row (A)).Period,
               (case A is
                   when Reload_Done  =>
                      Latest_Answered (Line (Reload), Period_Of (A, Under)),
                   when Mission_Begin | Camera_Order =>
                      Latest (Bounds (Receive)),
                   when Line_Open    => Latest (Line (Other_Order)),
                   when Line_Outcome => Latest_Answer (Line),
                   when Battery_Done =>
                      Latest_Answered (Line (Battery), Period_Of (A, Under)),
                   when Ping_Done    =>
                      Latest_Answered (Line (Ping), Period_Of (A, Under)),
                   when Send_Answer  => Span'Max
                     (Latest (Bounds (Receive)), Latest_Answer (Line)),
                   when Mission_Told =>
                      Capped (2 * Period_Of (A, Under)),
                   when Send_Battery => Latest (Bounds (Battery_Done)),
                   when Send_Mission => Latest (Bounds (Mission_Seen)),
                   when Send_Position | Send_Image | Mission_Seen =>
                      Latest (Bounds (Capture)),
                   when others       => 0));
         end if;
         if not Is_Spaced (A) then
            Change_Deferral (Row (A), Put_Off (Set (Row (A)), Bounds (A)));
         end if;
      end loop;
   end Set_Jitters;

   procedure Bound_Chain
     (Set     : Activity_Set;
      Members : Member_Set;
      Pauses  : Span;
      Result  : out Bound)
   is
      --  Of activities of one processor that set each other off, one after the
      --  other: together they are like one with the lowest of their
      --  priorities. Pauses: message gaps on the way
      Others_Set : Activity_Set := Set;
      Host       : Row_Index    := Row_Index'Last;
      Whole      : Activity     := (Priority => Urgency'Last, others => <>);
      Budget     : Microseconds := Microseconds (Pauses);
      Sleeps     : Microseconds := 0;
   begin
      for A in Activity_Name loop
         if Members (A) then
            Budget := Budget + Set (Row (A)).Budget;
            --  also for those within the chain that are woken
            Sleeps := Sleeps
              + Set (Row (A)).Suspension + Set (Row (A)).Blocking;
            Whole.Processor := Set (Row (A)).Processor;
            Whole.Priority :=
              Urgency'Min (Whole.Priority, Set (Row (A)).Priority);
            if A not in Line_Request | Line_Answer | Line_Outcome then
               --  these go on for other transactions; the rest is the
               --  chain's own
               Whole.Period :=
                 Positive_Span'Min (Whole.Period, Set (Row (A)).Period);
               Others_Set (Row (A)).Budget := 0;
               Host := Row (A);
            end if;
         end if;
         pragma Loop_Invariant
           (Budget <= (Microseconds (Row (A)) + 1) * Horizon
            and then Sleeps <= Microseconds (Row (A)) * (2 * Horizon));
      end loop;
      if Budget > Horizon or else Sleeps > Horizon then
         Result := (others => <>);
         return;
      end if;
      Whole.Budget := Budget;
      Whole.Suspension := Sleeps;
      Others_Set (Host) := Whole;
      Bound_Activity (Others_Set, Host, Result);
   end Bound_Chain;

   procedure Judge
     (Set    : Activity_Set;
      Bounds : Row_Bounds;
      Owner  : Owner_Array;
      Line   : Line_Bounds;
      On     : Machine;
      Under  : Load;
      Result : out Requirement_Array)
   is
      Spread : constant Span :=
        Capped ((Capture_High - Capture_Low) * On.Percent / 100);
      Asked, Told, Ended : Bound;
      Ordered : Microseconds;

      procedure Conclude
        (Name : Requirement_Name; Value : Microseconds; Known : Boolean)
      with Global => (In_Out => Result), Pre => Value <= 100 * Horizon
      is
      begin
         Result (Name).Bound := Value;
         Result (Name).Known := Known;
      end Conclude;

      function Before (Who : Schedule.Task_Name) return Requirement is
        (Limit  => To_Period (Schedule.Table (Who).Deadline / One),
         others => <>);

   begin
      Result :=
        (F2_Admitted     => Before (Schedule.Th_Server),
         F4_Own_Answer   => Before (Schedule.Th_Receive_From_Mon),
         F4_Robot_Answer => Before (Schedule.Th_Send_To_Mon),
         F4_Unsolicited      => Before (Schedule.Th_Send_To_Mon),
         F6_Stop         => Before (Schedule.Th_Com_Mon_Perdue),
         F11_Reload      => Before (Schedule.Th_Start_Robot_WD),
         F12_First_Byte  => Before (Schedule.Th_Move),
         F12_At_Robot    => (Limit => Order_Limit, others => <>),
         F13_Level       =>
           (Limit => To_Period (Battery_Period), others => <>),
         F13_Processor   => Before (Schedule.Th_Battery_Level),
         F15_Image       => (Limit => Image_Period, others => <>),
         F15_Jitter      => Before (Schedule.Th_Capture_Img),
         Mission_Order | Mission_At_Robot =>
           (if Under.Mission then Before (Schedule.Th_Mission)
            else (others => <>)));

      --  th_server has just seen to another; then to the connection, then
      --  to its first line where a token is asked for

      Conclude
        (F2_Admitted,
         2 * (Microseconds (To_Period (Newcomer_Interval))
              + Bounds (Newcomer).Finish),
         Bounds (Newcomer).Exists);

      --  answers: an image may be under way, and a pause follows it. Of
      --  unsolicited messages all but that pause

      Bound_Chain
        (Set,
         (Receive | Send_Image | Send_Answer => True, others => False),
         Answer_Gap, Told);
      Conclude (F4_Own_Answer, Told.Finish, Told.Exists);

      Bound_Chain
        (Set,
         (Line_Answer | Line_Outcome | Send_Image | Send_Answer => True,
          others => False),
         Answer_Gap, Told);
      Conclude (F4_Robot_Answer, Told.Finish, Told.Exists);

      Bound_Chain
        (Set,
         (Line_Answer | Battery_Done | Send_Image | Send_Battery => True,
          others => False),
         0, Ended);
      Conclude (F4_Unsolicited, Ended.Finish, Ended.Exists);

      --  the robot's line

      Bound_Chain
        (Set,
         (Receive | Line_Request => True, others => False),
         0, Asked);
      Conclude (F12_First_Byte, Asked.Finish, Asked.Exists);
      Conclude
        (F12_At_Robot,
         Line (Movement).Start + Owner (Movement).Request.Local
         + Frame_Time (Longest_Frame),
         Line (Movement).Exists and then Owner (Movement).Request.Exists);
      Conclude
        (F11_Reload,
         Line (Reload).Start + Owner (Reload).Request.Local,
         Line (Reload).Exists and then Owner (Reload).Request.Exists);
      Conclude
        (F6_Stop,
         Line (Safe_State).Start + Owner (Safe_State).Request.Local
         + Frame_Time (Stop_Frame),
         Line (Safe_State).Exists and then Owner (Safe_State).Request.Exists);

      --  the mission: the image, the newest one, is due, searched, looked at

      Ordered :=
        Camera_Interval + Bounds (Mission_Seen).Finish + Line (Mission).Start
        + Owner (Mission).Request.Local;
      for Name in Mission_Order .. Mission_At_Robot loop
         Conclude
           (Name,
            (if Name = Mission_Order then Ordered
             else Ordered + Frame_Time (Longest_Frame)),
            Under.Mission
            and then Bounds (Mission_Seen).Exists
            and then Line (Mission).Exists
            and then Owner (Mission).Request.Exists);
      end loop;

      --  the battery: to its request, and from the answer on. An answer
      --  may go before the level, and news of a mission, and an image before
      --  that, each with its pause after it. All but the hold

      Bound_Chain
        (Set,
         (Battery_Due | Line_Request => True, others => False),
         0, Asked);
      Conclude
        (F13_Processor, Asked.Finish + Ended.Finish,
         Asked.Exists and then Ended.Exists);
      Bound_Chain
        (Set,
         (Send_Answer | Send_Battery => True, others => False), 0, Told);
      Conclude
        (F13_Level,
         Line (Battery).Finish + Ended.Finish
         + Answer_Gap + Told.Finish
         + (if Under.Mission then 2 else 1) * (Message_Gap + Told.Finish),
         Line (Battery).Exists and then Ended.Exists and then Told.Exists);

      --  the image: in time for the next one; and how far its sending may
      --  be from its place in the period, but for a pause

      Conclude (F15_Image, Bounds (Capture).Finish, Bounds (Capture).Exists);
      Bound_Chain
        (Set,
         (Send_Battery | Send_Image => True, others => False), 0, Ended);
      Conclude
        (F15_Jitter,
         Spread + Ended.Finish
         + (if Bounds (Capture).Finish >= Set (Row (Capture)).Budget
            then Bounds (Capture).Finish - Set (Row (Capture)).Budget
            else 0),
         Bounds (Capture).Exists and then Ended.Exists);
   end Judge;

   procedure Analyse
     (Choice : Priority_Choice;
      Where  : Placement;
      On     : Machine;
      Under  : Load;
      Result : out Analysis)
   is
      procedure Bound_One
        (Set : Activity_Set; Name : Activity_Name; Value : out Bound)
      with Global => Under
      is
         Normal : Activity_Set := Set;
      begin
         --  Stop: the run ends, and nothing is promised beside the stop.
         --  Newcomer: without a flood there is no session yet
         if Name /= Stop then
            Normal (Row (Stop)).Budget := 0;
         end if;
         if Name /= Newcomer and then not Under.Flood then
            Normal (Row (Newcomer)).Budget := 0;
         end if;
         Normal (Row (Name)) := Set (Row (Name));
         Bound_Activity (Normal, Row (Name), Value);
      end Bound_One;

      procedure Bound_Owner
        (Set : Activity_Set; Who : Line_Client; Value : out Owner_Bounds)
      with Global => (Choice, Under)
      is
         Alone : Activity_Set := Set;
         Own   : constant Task_Activity :=
           (case Who is
               when Safe_State            => Loss,
               when Reload                => Reload_Due,
               when Stop_Order | Movement => Line_Request,
               when Other_Order | Ping    => Ping_Due,
               when Battery               => Battery_Due,
               when Mission               => Mission_Due,
               --  the least urgent task of those that do it
               when Unanswered            =>
                 (if Under.Mission then Mission_Due else Battery_Due));
         --  of the task that carries it out

         function Comes_Once (Item : Activity) return Boolean is
           (Frame_Time (Longest_Frame + Short_Frame) + Under.Turnaround
            + Longest_Own + Item.Jitter + Item.Deferral <= Item.Period);
         --  In an exchange that is answered

      begin
         Alone (Row (Line_Request)).Priority := Priority_Of (Own, Choice);
         Alone (Row (Line_Answer)).Priority := Priority_Of (Own, Choice);
         --  an order that opens the line exchanges once: it is over sooner
         --  than one that stops the robot first
         Alone (Row (Line_Open)).Budget := 0;
         --  what follows an answer is counted as Line_Outcome, of each
         Alone (Row (Reload_Done)).Budget := 0;
         Alone (Row (Battery_Done)).Budget := 0;
         Alone (Row (Ping_Done)).Budget := 0;
         if Who not in Other_Order | Unanswered then
            --  the task does nothing else meanwhile
            for A in Task_Activity loop
               if A not in Line_Request .. Line_Open
                 and then Task_Of (A) = Task_Of (Own)
               then
                  Alone (Row (A)).Budget := 0;
               end if;
            end loop;
         end if;
         Alone (Row (Line_Answer)).Budget := 0;
         Alone (Row (Line_Outcome)).Budget := 0;
         Bound_One (Alone, Line_Request, Value.Request);
         Alone (Row (Line_Answer)).Budget := Set (Row (Line_Answer)).Budget;
         Alone (Row (Line_Request)).Budget := 0;
         if Who /= Unanswered then
            --  What comes once in an exchange is in the bound of the request.
            --  In two parts an exchange may meet one tick more
            for A in Activity_Name loop
               if A /= Line_Answer and then Comes_Once (Set (Row (A))) then
                  Alone (Row (A)).Budget := 0;
               end if;
            end loop;
            Alone (Row (Line_Answer)).Budget := Capped
              (Set (Row (Line_Answer)).Budget + Set (Row (Kernel)).Budget);
         end if;
         Bound_One (Alone, Line_Answer, Value.Answer);
         Alone (Row (Line_Answer)).Budget := Capped
           (Alone (Row (Line_Answer)).Budget
            + Set (Row (case Who is
                           when Reload => Reload_Done,
                           when Ping   => Ping_Done,
                           when others => Line_Outcome)).Budget);
         Alone (Row (Line_Answer)).Suspension := Capped
           (Set (Row (Line_Answer)).Suspension
            + Set (Row (Line_Outcome)).Suspension
            + Set (Row (Line_Outcome)).Blocking);
         Bound_One (Alone, Line_Answer, Value.Outcome);
         if Who /= Unanswered
           and then Value.Request.Local + Value.Outcome.Local > Longest_Own
         then
            Value := (others => <>);
         end if;
      end Bound_Owner;

      In_Session : Activity_Set;
      Changed    : Boolean;
   begin
      Fill (Choice, Where, On, Under, Result.Set);
      for Round in 1 .. Max_Rounds loop
         for A in Activity_Name loop
            Bound_One (Result.Set, A, Result.Bounds (A));
         end loop;
         for C in Line_Client loop
            Bound_Owner (Result.Set, C, Result.Owner (C));
         end loop;
         Bound_Line
           (Result.Bounds, Result.Owner, Under, Result.Line_Length,
            Result.Line);
         Set_Jitters
           (Result.Set, Result.Bounds, Result.Line, Under, Changed);
         Result.Settled := not Changed;
         exit when Result.Settled;
      end loop;

      for A in Activity_Name loop
         Result.Deadlines (A) :=
           (case A is
               when Kernel | Console | Environment => 0,
               when Send_Look       => 0,          --  it waits once more
               when Loss            => 50_000,     --  F5
               when Newcomer        => To_Period (Newcomer_Interval),
               when Stop            => 100_000,
               when Reload_Due      => 50_000,     --  F11
               when Mission_Under_Way => 0,
               --  one look at a time: late, it only comes later
               when others          => Period_Of (A, Under));
      end loop;
      In_Session := Result.Set;
      In_Session (Row (Stop)).Budget := 0;
      if not Under.Flood then
         In_Session (Row (Newcomer)).Budget := 0;
      end if;
      Judge
        (In_Session, Result.Bounds, Result.Owner, Result.Line, On, Under,
         Result.Requirements);
      if not Result.Settled then
         for R of Result.Requirements loop
            R.Known := False;
         end loop;
      end if;
   end Analyse;

   function Promises_Kept (Result : Analysis) return Boolean is
     (Result.Settled
      and then
        (for all R in Requirement_Name =>
           (if Always (R) then Met (Result.Requirements (R)))));

   function Deadlines_Met (Result : Analysis) return Boolean is
     (Promises_Kept (Result)
      and then
        (for all A in Activity_Name =>
           Result.Deadlines (A) = 0
           or else (Result.Bounds (A).Exists
                    and then Result.Bounds (A).Local
                      <= Result.Deadlines (A))));

   function All_Met (Result : Analysis) return Boolean is
     (Deadlines_Met (Result)
      and then
        (for all R of Result.Requirements => R.Limit = 0 or else Met (R)));

   function Load_Of
     (Result : Analysis; Processor : Processor_Number) return Microseconds
   is
      Sum : Microseconds := 0;
   begin
      for A in Result.Set'Range loop
         if Result.Set (A).Processor = Processor then
            Sum := Sum
              + Result.Set (A).Budget * 10_000 / Result.Set (A).Period;
         end if;
         pragma Loop_Invariant (Sum <= Microseconds (A) * 10_000 * Horizon);
      end loop;
      return Sum;
   end Load_Of;

end Supervisor_Model;
