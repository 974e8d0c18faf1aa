--  SPDX-License-Identifier: GPL-3.0-or-later
--  Prints the response-time analysis of the supervisor. Exit status 1 where
--  a deadline is missed with the priorities of src/common/schedule.ads.

with Ada.Command_Line;  use Ada.Command_Line;
with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;

with Budgets;           use Budgets;
with Response_Times;    use Response_Times;
with Supervisor_Model;  use Supervisor_Model;

procedure Schedulability_Analysis with SPARK_Mode => Off is
   --  Off: it prints; what is computed is in SPARK

   Here : constant Machine := (others => <>);
   Pi   : constant Machine :=
     (Percent => 100 * Cortex_A53_Factor, Second | Many => True);

   Load_Here : constant Load := (others => <>);
   Load_By_Radio : constant Load :=
     (Turnaround => Radio_Turnaround,
      Commands   => Radio_Interval,
      Time_Out   => Radio_Time_Out,
      others     => <>);

   Whole : Boolean := False;
   --  every table, not only those of the priorities in use

   function Trimmed (Value : Microseconds) return String is
     (Trim (Microseconds'Image (Value), Both));

   function Milliseconds (Value : Microseconds) return String;
   --  With three decimals

   function Column (Text : String; Width : Positive) return String is
     (if Text'Length >= Width then " " & Text
      else (1 .. Width - Text'Length => ' ') & Text);

   function Part (Name : Activity_Name) return String is
     (case Name is
         when Line_Request    => "request",
         when Line_Answer     => "answer",
         when Line_Outcome    => "outcome",
         when Line_Open       => "open, close",
         when Reload_Due | Battery_Due | Ping_Due    => "due",
         when Reload_Done | Battery_Done | Ping_Done => "done",
         when Camera_Order    => "order",
         when Camera_Answer | Send_Answer => "answer",
         when Send_Look       => "gap",
         when Send_Battery    => "battery",
         when Send_Mission    => "mission",
         when Send_Position   => "position",
         when Mission_Begin   => "begin",
         when Mission_Due     => "due",
         when Mission_Seen    => "position",
         when Mission_Told    => "done",
         when Send_Image      => "image",
         when others          => "");

   function Meaning (Name : Requirement_Name) return String is
     (case Name is
         when F2_Admitted     => "F2  connection to its admission",
         when F4_Own_Answer   => "F4  command to the supervisor's answer",
         when F4_Robot_Answer => "F4  robot's answer to the monitor's",
         when F4_Unsolicited      => "F4  the same to the battery message *",
         when F6_Stop         => "F6  loss of the monitor to stop sent",
         when F11_Reload      => "F11 reload due to its first byte",
         when F12_First_Byte  => "F12 order to first byte, line free",
         when F12_At_Robot    => "F12 order to last byte, line in use",
         when F13_Level       => "F13 level due to its message, no hold",
         when F13_Processor   => "F13 the same without line and gap *",
         when F15_Image       => "F15 image due to image ready",
         when F15_Jitter      => "F15 jitter of the image sent *",
         when Mission_Order    => "mission: image to its order's first byte",
         when Mission_At_Robot => "mission: image to its order's last byte");

   procedure Print_Calls;
   --  For proofs/schedulability/calls: each activity's task, whether it stays
   --  on its processor, and how often it calls what

   procedure Print_Table (Item : Analysis);
   procedure Print_Line (Item : Analysis);
   procedure Print_Requirements (Item : Analysis);
   procedure Print_Loads (Item : Analysis);

   procedure Print_Silent (Item : Analysis; Time_Out : Span);
   --  Item: with one exchange that is not answered

   function Silence_Borne (Item : Analysis) return Boolean is
     --  the loss of the monitor at the same time would be a second failure
     (Item.Requirements (F11_Reload).Known
      and then Item.Requirements (F11_Reload).Bound <= Reload_Limit
      and then Met (Item.Requirements (F13_Level)));

   procedure Analyse_And_Print
     (Title  : String;
      Choice : Priority_Choice;
      Where  : Placement;
      On     : Machine;
      Under  : Load;
      Full   : Boolean;
      Good   : out Boolean);

   procedure Analyse_Flood
     (Title : String; On : Machine; Good : out Boolean);
   --  What is promised amid newcomers without end. Good: so are those

   procedure Analyse_Missions
     (Title : String; On : Machine; Demanded : Boolean; Good : out Boolean);
   --  What is promised while missions are under way. Demanded: a mission's
   --  order in time, too

   procedure Print_Limits (On : Machine; Under : Load := Load_Here);
   --  How far each assumption may be wrong before a deadline is missed

   function Milliseconds (Value : Microseconds) return String is
      Rest : constant String := Trimmed (1_000 + Value mod 1_000);
   begin
      return Trimmed (Value / 1_000) & "."
        & Rest (Rest'First + 1 .. Rest'Last);
   end Milliseconds;

   procedure Print_Calls is
   begin
      for A in Task_Activity loop
         Put (Task_Name (A) & " " & A'Image
              & (if Stays_Here (A) then " stays" else " -"));
         for O in Operation_Name loop
            if Calls (A, O) > 0 then
               Put (" " & O'Image & "=" & Trim (Calls (A, O)'Image, Both));
            end if;
         end loop;
         New_Line;
      end loop;
   end Print_Calls;

   procedure Print_Table (Item : Analysis) is

      procedure Put_Row (A : Activity_Name);

      procedure Put_Row (A : Activity_Name) is
         R        : Activity renames Item.Set (Row (A));
         B        : Bound renames Item.Bounds (A);
         Deadline : constant Span := Item.Deadlines (A);
      begin
         Put_Line
           (Head (Head (Task_Name (A), 18) & Part (A), 27)
            & Column (Trim (Urgency'Image (R.Priority), Both), 4)
            & Column (Trim (Processor_Number'Image (R.Processor), Both), 4)
            & Column (Milliseconds (R.Period), 10)
            & Column
                ((if Deadline = 0 then "-" else Milliseconds (Deadline)),
                 10)
            & Column (Milliseconds (R.Budget), 9)
            & Column (Milliseconds (R.Blocking), 9)
            & Column
                ((if B.Exists then Milliseconds (B.Local) else "none"), 9)
            & (if Deadline = 0 then ""
               elsif not B.Exists or else B.Local > Deadline
               then Column ("MISSED", 10)
               else Column (Milliseconds (Deadline - B.Local), 10)));
      end Put_Row;

   begin
      Put_Line
        (Head ("task", 27) & "prio cpu" & Column ("period", 10)
         & Column ("deadline", 10) & Column ("budget", 9)
         & Column ("blocking", 9) & Column ("response", 9)
         & Column ("margin", 10));
      for A in Activity_Name loop
         if Item.Set (Row (A)).Budget > 0 or else A = Environment then
            Put_Row (A);
         end if;
      end loop;
   end Print_Table;

   procedure Print_Line (Item : Analysis) is
      function Client_Name (C : Line_Client) return String is
        (case C is
            when Safe_State  => "end of a session",
            when Stop_Order  => "stop",
            when Reload      => "reload",
            when Movement    => "movement",
            when Mission     => "mission",
            when Battery     => "battery",
            when Other_Order => "other order",
            when Ping        => "ping",
            when Unanswered  => "unanswered");
   begin
      Put_Line
        (Head ("robot's line, by urgency", 27) & Column ("length", 18)
         & Column ("begun", 10) & Column ("ended", 9));
      for C in Line_Client range Line_Client'First .. Ping loop
         if Item.Line_Length (C) > 0 then
            Put_Line
              (Head (Client_Name (C), 27)
               & Column (Milliseconds (Item.Line_Length (C)), 18)
               & (if Item.Line (C).Exists
                  then Column (Milliseconds (Item.Line (C).Start), 10)
                    & Column (Milliseconds (Item.Line (C).Finish), 9)
                  else Column ("none", 10)));
         end if;
      end loop;
   end Print_Line;

   procedure Print_Requirements (Item : Analysis) is

      procedure Put_Row (R : Requirement_Name);

      procedure Put_Row (R : Requirement_Name) is
         This : Requirement renames Item.Requirements (R);
      begin
         Put_Line
           (Head (Meaning (R), 44)
            & Column
                ((if This.Known then Milliseconds (This.Bound)
                  else "none"), 10)
            & Column (Milliseconds (This.Limit), 10)
            & (if Met (This)
               then Column (Milliseconds (This.Limit - This.Bound), 10)
               elsif Always (R) then Column ("MISSED", 10)
               else Column ("not all", 10)));
      end Put_Row;

   begin
      Put_Line
        (Head ("from the cause to the effect", 44) & Column ("bound", 10)
         & Column ("demanded", 10) & Column ("margin", 10));
      for R in Requirement_Name loop
         if Item.Requirements (R).Limit > 0 then
            Put_Row (R);
         end if;
      end loop;
   end Print_Requirements;

   procedure Print_Loads (Item : Analysis) is
   begin
      Put ("processors' load:");
      for P in Processor_Number range 1 .. 4 loop
         declare
            Share : constant Microseconds := Load_Of (Item, P);
         begin
            if Share > 0 then
               Put ("  cpu" & P'Image & ":"
                    & Microseconds'Image (Share / 100) & " %");
            end if;
         end;
      end loop;
      New_Line;
   end Print_Loads;

   procedure Print_Silent (Item : Analysis; Time_Out : Span) is

      procedure Print (Name : Requirement_Name; Limit : Microseconds);
      --  Limit 0: none is demanded

      procedure Print (Name : Requirement_Name; Limit : Microseconds) is
         This : Requirement renames Item.Requirements (Name);
      begin
         Put_Line
           (Head (Meaning (Name), 44)
            & Column
                ((if This.Known then Milliseconds (This.Bound) else "none"),
                 10)
            & Column
                ((if Limit = 0 then "-" else Milliseconds (Limit)), 10)
            & (if Limit = 0 then ""
               elsif This.Known and then This.Bound <= Limit
               then Column (Milliseconds (Limit - This.Bound), 10)
               else Column ("exceeded", 10)));
      end Print;

   begin
      Put_Line
        ("one exchange not answered (time-out " & Trimmed (Time_Out / 1_000)
         & " ms)");
      Print (F6_Stop, Item.Requirements (F6_Stop).Limit);
      Print (F11_Reload, Reload_Limit);
      Print (F12_At_Robot, 0);
      Print (F13_Level, Item.Requirements (F13_Level).Limit);
   end Print_Silent;

   procedure Analyse_And_Print
     (Title  : String;
      Choice : Priority_Choice;
      Where  : Placement;
      On     : Machine;
      Under  : Load;
      Full   : Boolean;
      Good   : out Boolean)
   is
      Varied   : Load := Under;
      Result   : Analysis;
      Silent   : Analysis;
   begin
      Analyse (Choice, Where, On, Varied, Result);
      Varied.Silent := True;
      Analyse (Choice, Where, On, Varied, Silent);
      Good := Deadlines_Met (Result) and then Silence_Borne (Silent);
      New_Line;
      Put_Line ("== " & Title);
      if Full then
         Print_Table (Result);
         Print_Loads (Result);
         New_Line;
         Print_Line (Result);
         New_Line;
      end if;
      Print_Requirements (Result);
      Print_Silent (Silent, Under.Time_Out);
      Put_Line
        ("verdict: "
         & (if Good and then All_Met (Result)
            then "every deadline is met, in the worst case"
            elsif Good
            then "every deadline is met; what is demanded of 99 or 99.9 in"
              & " 100 not in the worst case"
            else "NOT every deadline is met"));
   end Analyse_And_Print;

   procedure Analyse_Flood
     (Title : String; On : Machine; Good : out Boolean)
   is
      Under  : constant Load := (Flood => True, others => <>);
      Slower : Machine := On;
      Result : Analysis;
   begin
      Analyse (Of_The_Table, Real_Time_Apart, On, Under, Result);
      Good := Result.Bounds (Newcomer).Exists
        and then Result.Bounds (Newcomer).Finish
          <= Result.Deadlines (Newcomer)
        and then Promises_Kept (Result);
      New_Line;
      Put_Line ("== amid a flood of newcomers, " & Title);
      Print_Loads (Result);
      Print_Requirements (Result);
      Put_Line ("verdict: what is demanded of every single one is "
                & (if Good then "kept" else "NOT kept"));
      Slower.Percent := 10;
      loop
         Analyse (Of_The_Table, Real_Time_Apart, Slower, Under, Result);
         exit when not Promises_Kept (Result);
         Slower.Percent := Slower.Percent + 10;
      end loop;
      Put_Line
        ("all of it up to" & Microseconds'Image (Slower.Percent - 10)
         & " per cent of the budgets");
   end Analyse_Flood;

   procedure Analyse_Missions
     (Title : String; On : Machine; Demanded : Boolean; Good : out Boolean)
   is
      Under  : constant Load := (Mission => True, others => <>);
      Result : Analysis;
   begin
      Analyse (Of_The_Table, Real_Time_Apart, On, Under, Result);
      Good := Deadlines_Met (Result)
        and then
          (not Demanded or else Met (Result.Requirements (Mission_At_Robot)));
      New_Line;
      Put_Line ("== beside missions, " & Title);
      Print_Table (Result);
      Print_Loads (Result);
      New_Line;
      Print_Line (Result);
      New_Line;
      Print_Requirements (Result);
      Put_Line
        ("verdict: " & (if Good then "" else "NOT ") & "every deadline is met"
         & (if Demanded then "" else ", but for a mission's order"));
      Print_Limits (On, Under);
   end Analyse_Missions;

   procedure Print_Limits (On : Machine; Under : Load := Load_Here) is

      generic
         Step, Last : Microseconds;
         with function Enough (Result : Analysis) return Boolean;
         with procedure Choose
           (Value : Microseconds; M : in out Machine; L : in out Load);
      function Largest return Microseconds;

      function Largest return Microseconds is
         Best   : Microseconds := 0;
         Value  : Microseconds := Step;
         Result : Analysis;
      begin
         while Value <= Last loop
            declare
               M : Machine := On;
               L : Load := Under;
            begin
               Choose (Value, M, L);
               Analyse (Of_The_Table, Real_Time_Apart, M, L, Result);
            end;
            exit when not Enough (Result);
            Best := Value;
            Value := Value + Step;
         end loop;
         return Best;
      end Largest;

      procedure Choose_Factor
        (Value : Microseconds; M : in out Machine; L : in out Load);
      procedure Choose_Latency
        (Value : Microseconds; M : in out Machine; L : in out Load);
      procedure Choose_Turnaround
        (Value : Microseconds; M : in out Machine; L : in out Load);

      procedure Choose_Factor
        (Value : Microseconds; M : in out Machine; L : in out Load)
      is
         pragma Unreferenced (L);
      begin
         M.Percent := Value;
      end Choose_Factor;

      procedure Choose_Latency
        (Value : Microseconds; M : in out Machine; L : in out Load)
      is
         pragma Unreferenced (M);
      begin
         L.Latency := Value;
      end Choose_Latency;

      procedure Choose_Turnaround
        (Value : Microseconds; M : in out Machine; L : in out Load)
      is
         pragma Unreferenced (M);
      begin
         L.Turnaround := Value;
      end Choose_Turnaround;

      function Factor_All is
        new Largest (10, 5_000, All_Met, Choose_Factor);
      function Factor_Most is
        new Largest (10, 5_000, Deadlines_Met, Choose_Factor);
      function Latency_All is
        new Largest (50, 20_000, All_Met, Choose_Latency);
      function Latency_Most is
        new Largest (50, 20_000, Deadlines_Met, Choose_Latency);
      function Turnaround_All is
        new Largest (500, 80_000, All_Met, Choose_Turnaround);
      function Turnaround_Most is
        new Largest (500, 80_000, Deadlines_Met, Choose_Turnaround);
   begin
      Put_Line ("how far it holds:                what is demanded of every"
                & " one    of 99 or 99.9 in 100");
      Put_Line ("   budgets, per cent        "
                & Column (Trimmed (Factor_Most), 20)
                & Column (Trimmed (Factor_All), 20));
      Put_Line ("   wake-up latency          "
                & Column (Milliseconds (Latency_Most), 20)
                & Column (Milliseconds (Latency_All), 20));
      Put_Line ("   the robot's turnaround   "
                & Column (Milliseconds (Turnaround_Most), 20)
                & Column (Milliseconds (Turnaround_All), 20));
   end Print_Limits;

   Good_Here, Good_On_Pi, Flood_Here, Flood_On_Pi, Missions_Here,
   Missions_On_Pi, Good, Unused : Boolean;

begin
   if Argument_Count = 1 and then Argument (1) = "--all" then
      Whole := True;
   elsif Argument_Count = 1 and then Argument (1) = "--calls" then
      Print_Calls;
      return;
   elsif Argument_Count > 0 then
      Put_Line (Standard_Error, "usage: schedulability [--all | --calls]");
      Set_Exit_Status (2);
      return;
   end if;

   Put_Line ("Response-time analysis, fixed priorities, immediate ceilings");
   Put_Line ("times in milliseconds; response: from the release to the end");
   Put_Line ("load: a command each " & Milliseconds (Command_Interval)
             & ", an image each 100.000; robot answers within "
             & Milliseconds (Robot_Turnaround));
   Put_Line ("*: but for a gap of " & Milliseconds (Message_Gap)
             & " after another unsolicited message");
   Put_Line ("cpu 1, the real-time processor (--cpu): all tasks but"
             & " th_captureImg, th_arene, th_camera, th_console");

   Analyse_And_Print
     ("priorities of schedule.ads, this machine: image work on cpu 2",
      Of_The_Table, Real_Time_Apart, Here, Load_Here, True, Good_Here);
   Print_Limits (Here);
   Analyse_And_Print
     ("priorities of schedule.ads, Cortex-A53: the second machine's budgets"
      & " times" & Positive_Span'Image (Pi.Percent / 100)
      & ", image work on cpu 2 to 4",
      Of_The_Table, Real_Time_Apart, Pi, Load_Here, True, Good_On_Pi);
   Print_Limits (Pi);
   Analyse_Missions ("this machine", Here, True, Missions_Here);
   Analyse_Missions ("Cortex-A53", Pi, False, Missions_On_Pi);
   Analyse_Flood ("this machine", Here, Flood_Here);
   Analyse_Flood ("Cortex-A53", Pi, Flood_On_Pi);
   Analyse_And_Print
     ("the report's priorities, one processor, this machine",
      Of_The_Report, One_Processor, Here,
      Load_Here, Whole, Unused);
   Analyse_And_Print
     ("the report's priorities, one processor, Cortex-A53",
      Of_The_Report, One_Processor, Pi,
      Load_Here, Whole, Unused);
   Analyse_And_Print
     ("the report's priorities, image work apart, this machine",
      Of_The_Report, Real_Time_Apart, Here, Load_Here, Whole, Unused);
   Analyse_And_Print
     ("the report's priorities, image work apart, Cortex-A53",
      Of_The_Report, Real_Time_Apart, Pi, Load_Here, Whole, Unused);
   Analyse_And_Print
     ("priorities of schedule.ads, one processor, this machine",
      Of_The_Table, One_Processor, Here,
      Load_Here, Whole, Unused);
   Analyse_And_Print
     ("by radio, this machine: a command each "
      & Milliseconds (Radio_Interval),
      Of_The_Table, Real_Time_Apart, Here, Load_By_Radio, Whole, Unused);

   New_Line;
   Put_Line
     ("ceilings: "
      & (if Ceilings_Hold (Of_The_Table) then "none below a caller"
         else "BELOW a caller's priority"));
   Good := Good_Here and then Good_On_Pi
     and then Missions_Here and then Missions_On_Pi
     and then Flood_Here and then Flood_On_Pi
     and then Ceilings_Hold (Of_The_Table);
   Put_Line
     ("schedulability: "
      & (if Good then "every deadline is met, on both machines"
         else "NOT every deadline is met"));
   Set_Exit_Status (if Good then Success else Failure);
end Schedulability_Analysis;
