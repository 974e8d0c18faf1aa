--  SPDX-License-Identifier: GPL-3.0-or-later
--  One injection.

with Ada.Exceptions;
with Interfaces.C;       use type Interfaces.C.int;

with Answer_Ledgers;    use Answer_Ledgers;
with Expectations;      use Expectations;
with Faults;            use Faults;
with Instants;          use Instants;
with Host_Time;
with Process_Facts;
with Random_Numbers;    use Random_Numbers;
with Standstills;
with Tolerances;        use Tolerances;

package body Trials is

   End_Limit : constant Duration := 2.0;
   --  for a supervisor that ends: it has 0.8 s for an orderly stop

   Images_Limit : constant Duration := 5.0;
   --  for the first image of a camera

   Drive_Limit : constant Duration := 2.0;
   --  for the robot to stand after RSTP; how fast that is, is measured
   --  elsewhere

   The_World : World;

   Is_Kept : Boolean := False;
   --  its supervisor is to live on after a violation

   function Name (First : Positive; Second : Natural) return String is
     (To_String (Element (First).Name)
      & (if Second = 0 then ""
         else " + " & To_String (Element (Second).Name)));

   function Is_In_Need (First : Positive; Second : Natural) return Plan is
      --  Of this world
   begin
      return P : Plan := (Terminal => Is_Kept, others => <>) do
         Element (First).Prepare (P);
         if Second > 0 then
            Element (Second).Prepare (P);
         end if;
      end return;
   end Is_In_Need;

   procedure Pick_Situation
     (First  : Positive;
      Second : Natural;
      Robot  : out Robot_Situation;
      Camera : out Camera_Situation)
   is
      --  At random, as the faults allow
      Other     : constant Positive := (if Second = 0 then First else Second);
      The_Robot : constant Robot_Need := Robot_Need'Max
        (Element (First).Robot, Element (Other).Robot);
      Lowest    : constant Robot_Situation :=
        (case The_Robot is
            when Any_Robot     => Line_Closed,
            when Robot_Started => Started,
            when Robot_Moving  => Moving);
   begin
      --  most often it moves: there the faults can do harm
      Robot := Robot_Situation'Val
        (Integer'Min
           (Robot_Situation'Pos (Robot_Situation'Last),
            Whole (The_World.Source, Robot_Situation'Pos (Lowest),
                   Robot_Situation'Pos (Robot_Situation'Last) + 2)));
      if Robot = Moving_With_Watchdog
        and then Chance (The_World.Source, 2)
      then
         Robot := Moving;
      end if;

      if Camera_Streaming in Element (First).Camera | Element (Other).Camera
      then
         Camera := (if Chance (The_World.Source, 2) then Streaming
                    else With_Position);
      elsif No_Camera in Element (First).Camera | Element (Other).Camera
        or else Chance (The_World.Source, 2)
      then
         Camera := Camera_Closed;
      else
         Camera := Camera_Situation'Val
           (Whole (The_World.Source, 1,
                   Camera_Situation'Pos (Camera_Situation'Last)));
      end if;
   end Pick_Situation;

   procedure Lift (Number : Positive) is
   begin
      Element (Number).Lift (The_World);
   exception
      when Occurrence : Failed =>
         The_World.Violate
           ("at the end of " & To_String (Element (Number).Name) & ": "
            & Ada.Exceptions.Exception_Message (Occurrence));
   end Lift;

   procedure Inject_All
     (First   : Positive;
      Second  : Natural;
      Outcome : in out Result)
   is
      W : World renames The_World;

      procedure Inject (Number : Positive) is
      begin
         Element (Number).Inject (W);
      exception
         when Occurrence : Failed =>
            W.Violate
              (To_String (Element (Number).Name) & ": "
               & Ada.Exceptions.Exception_Message (Occurrence));
         when Occurrence : Skipped =>
            Outcome.Ends_As := Impossible_Here;
            Outcome.Account := To_Unbounded_String
              (Ada.Exceptions.Exception_Message (Occurrence));
      end Inject;

   begin
      W.Talk (Span (W.Source, 0.0, 0.4), Calm => True);
      Inject (First);
      if Outcome.Ends_As /= Impossible_Here then
         if Second > 0 then
            if not W.Present and then not Chance (W.Source, 3) then
               W.Try_To_Join;
            end if;
            W.Talk (Span (W.Source, 0.0, 0.5));
            Inject (Second);
         end if;
         W.Talk (Span (W.Source, 0.05, 0.5));
      end if;
      if Second > 0 then
         Lift (Second);
      end if;
      Lift (First);
      W.Reachable := True;
   end Inject_All;

   procedure Expect_End is
      --  The supervisor ends as it should; then there is a new one
      W      : World renames The_World;
      Start  : constant Instant := Now;
      Status : Integer;
   begin
      begin
         Status := W.Supervisor.Exit_Status;
         Check_Within (Now - Start, End_Limit + Noise, "its end");
         if Status /= W.Expected_Status then
            W.Violate
              (Supervisor_Lives,
               "it ended with status" & Status'Image & " instead of"
               & W.Expected_Status'Image);
         end if;
      exception
         when Occurrence : Failed =>
            W.Violate
              (Supervisor_Lives,
               Ada.Exceptions.Exception_Message (Occurrence));
            return;
      end;
      W.Listen;
      W.Present := False;
      W.Await_Standing;
      if not W.Robot_Ready or else not W.Line_Works then
         W.Emulator.Tell ("reset-robot");
         W.Emulator.Await_Status ("state", "idle");
      end if;
      W.Start_Supervisor;
   end Expect_End;

   procedure Expect_Session_Goes_On is
      W : World renames The_World;
   begin
      W.Expect_Answers;
      if W.Present then
         W.Say ("nope", Refused);
         W.Expect_Answers;
      end if;
   exception
      when Occurrence : Failed =>
         W.Violate
           (Answered_Once, Ada.Exceptions.Exception_Message (Occurrence));
   end Expect_Session_Goes_On;

   procedure Expect_New_Session is
      W        : World renames The_World;
      Watchdog : constant Boolean := Chance (W.Source, 2);
      Found_In : constant Duration :=
        (if W.Found_By = Never then 0.0
         else Duration'Max (0.0, W.Found_By - Now));
   begin
      W.Await_Standing;
      if not W.Robot_Ready or else not W.Line_Works then
         W.Emulator.Tell ("reset-robot");
         W.Emulator.Await_Status ("state", "idle");
         W.Line_Works := True;
      end if;
      W.Join (Found_In + Return_Limit + Noise);
      --  as at the start: nothing is open
      W.Order ("RPIN", "ANAK");
      W.Order ("CPCO", "ANAK");
      W.Bring_To (if Watchdog then Moving_With_Watchdog else Moving);
      if W.The_Plan.Camera = "" and then W.Camera > Camera_Closed then
         W.Order ("COPN", "AACK");
         declare
            Seen : constant Natural := W.Monitor.Count_Of ("CIMG");
            Late : Boolean;
            Start : constant Instant := Now;
         begin
            loop
               Late := Now - Start > Images_Limit;
               exit when W.Monitor.Count_Of ("CIMG") > Seen;
               Check (not Late, "no image comes");
               delay 0.005;
            end loop;
         end;
      end if;
      --  a stop and a close must be effective even if the line was late four
      --  times in a row
      W.Order ("RSTP", "AACK ATIM ANAK");
      W.Expect_Status ("moving", "0", Within => Drive_Limit);
      if Chance (W.Source, 2) then
         --  else the end of the session does it
         W.Order ("CCLS", "AACK");
         W.Order ("RCLS", "AACK ATIM");
      else
         W.Say ("RGFW");
         W.Expect_Answers;
      end if;
      W.Lose (Orderly);
      W.Await_Standing;
   exception
      when Occurrence : Failed =>
         W.Violate
           (Session_Works, Ada.Exceptions.Exception_Message (Occurrence));
   end Expect_New_Session;

   procedure Expect_Invariants (First : Positive; Second : Natural) is
      W    : World renames The_World;
      Ends : constant Consequence := Consequence'Max
        (Element (First).Ends,
         (if Second = 0 then Nothing else Element (Second).Ends));
   begin
      if W.Expected_End then
         Expect_End;
      elsif not W.Supervisor.Is_Running then
         W.Violate
           (Supervisor_Lives,
            "it has ended with status"
            & Integer'Image (W.Supervisor.Exit_Status));
         return;
      else
         Expect_Session_Goes_On;
         if Ends = Nothing and then not W.Present then
            W.Violate
              ("the session has ended without a reason",
               By => A_Stopped_Machine);
         elsif Ends = Session_Ends and then Second = 0 and then W.Present
         then
            W.Violate
              ("the session has not ended", By => A_Stopped_Machine);
         end if;
      end if;
      W.End_Session;
      if W.Violations = 0 then
         Expect_New_Session;
      end if;
      if W.Violations = 0 then
         W.Expect_No_Leaks;
      end if;
   end Expect_Invariants;

   function Tail (Text : String) return String is
      --  Its last lines, indented
      Lines  : constant := 40;
      Longest : constant := 160;
      Count  : Natural := 0;
      First  : Natural := Text'Last + 1;
      Result : Unbounded_String;
      Line   : Natural;
   begin
      while First > Text'First loop
         if Text (First - 1) = ASCII.LF then
            Count := Count + 1;
            exit when Count > Lines;
         end if;
         First := First - 1;
      end loop;
      Line := First;
      for Place in First .. Text'Last loop
         if Text (Place) = ASCII.LF then
            Append
              (Result,
               "   | " & Text (Line .. Integer'Min
                                 (Place - 1, Line + Longest - 1))
               & ASCII.LF);
            Line := Place + 1;
         end if;
      end loop;
      return To_String (Result);
   end Tail;

   procedure Give_Up is
      --  After faults that leave the world in an unknown state
      W : World renames The_World;
   begin
      if not Is_Kept or else not W.Is_Built
        or else not W.Supervisor.Is_Running
      then
         W.Destroy;
         return;
      end if;
      W.Monitor.Close;
      W.Present := False;
      W.Nobody_Since := Never;
      W.Emulator.Tell ("reset-robot");
      W.Emulator.Await_Status ("state", "idle");
   exception
      when Failed =>
         W.Destroy;
   end Give_Up;

   procedure Run_Once
     (First      : Positive;
      Second     : Natural;
      Seed       : Natural;
      Repetition : Positive;
      Outcome    : out Result)
   is
      W      : World renames The_World;
      Needed : constant Plan := Is_In_Need (First, Second);
      Robot  : Robot_Situation := Line_Closed;
      Camera : Camera_Situation := Camera_Closed;
      Begun  : Boolean := False;
   begin
      Outcome := (others => <>);
      Start
        (W.Source, Seed, Name (First, Second) & Repetition'Image);
      W.Violations := 0;
      W.Explained_By := A_Late_Line;
      W.Figures := (others => <>);
      W.Account := Null_Unbounded_String;
      W.Remarks := Null_Unbounded_String;
      W.Alone := Second = 0;
      W.Line_Works := True;
      W.Robot_Ready := True;
      W.Reachable := True;
      W.Nobody_Since := Never;
      W.Found_By := Never;
      begin
         Pick_Situation (First, Second, Robot, Camera);
         if not W.Is_Built or else Needed.Fresh or else W.The_Plan /= Needed
         then
            W.Build (Needed);
         end if;
         W.Emulator.Clear_Journal;
         W.Begin_Session (Robot, Camera);
         Begun := True;
         Inject_All (First, Second, Outcome);
         if Outcome.Ends_As /= Impossible_Here then
            Expect_Invariants (First, Second);
         else
            Give_Up;
         end if;
      exception
         when Occurrence : Failed =>
            W.Violate
              ((if Begun then "" else "before the fault: ")
               & Ada.Exceptions.Exception_Message (Occurrence));
         when Occurrence : Skipped =>
            Outcome.Ends_As := Impossible_Here;
            Outcome.Account := To_Unbounded_String
              (Ada.Exceptions.Exception_Message (Occurrence));
            Give_Up;
      end;
      Outcome.Figures := W.Figures;
      if W.Violations > 0 then
         Outcome.Ends_As := Violated;
         Outcome.Account :=
           W.Account & W.Remarks
           & "   robot " & Robot_Situation'Image (Robot)
           & ", camera " & Camera_Situation'Image (Camera)
           & (if W.Is_Built then
                ", log (its last lines):" & ASCII.LF
                & Tail (W.Supervisor.Log_Text)
                & "   at the robot:" & ASCII.LF & W.Wire_Tail
                & "   its threads:" & Process_Facts.Thread_Waits (W.Pid)
                & ASCII.LF
              else (1 => ASCII.LF));
         Give_Up;
      elsif W.Remarks /= Null_Unbounded_String then
         Outcome.Account :=
           W.Remarks & "   log (its last lines):" & ASCII.LF
           & Tail (W.Supervisor.Log_Text);
      end if;
   end Run_Once;

   procedure Run
     (First      : Positive;
      Second     : Natural;
      Seed       : Natural;
      Repetition : Positive;
      Outcome    : out Result)
   is
      Taken       : Duration;
      Late        : Boolean;
      Stopped     : Boolean;
      Repeated    : Natural := 0;
      Interrupted : Natural := 0;
      Excused     : Unbounded_String;
      --  what was violated in those that were made again
   begin
      loop
         Standstills.Forget;
         Taken := Host_Time.Taken;
         Run_Once (First, Second, Seed, Repetition, Outcome);
         Late := The_World.Explained_By = A_Late_Line
           and then The_World.Line_Was_Late;
         Stopped := The_World.Explained_By in A_Late_Line | A_Stopped_Machine
           and then Host_Time.Taken - Taken >= Host_Grant;
         exit when Outcome.Ends_As /= Violated
           or else not (Late or else Stopped)
           or else Repeated = Line_Attempts - 1
           or else Interrupted = Host_Attempts - 1;
         Append (Excused, "   made again:" & ASCII.LF & The_World.Account);
         if Stopped then
            Interrupted := Interrupted + 1;
            Standstills.Await_Calm (Limit => 5.0 * Interrupted);
         else
            Repeated := Repeated + 1;
         end if;
      end loop;
      Outcome.Account := Excused & Outcome.Account;
      Outcome.Figures.Repeated := Outcome.Figures.Repeated + Repeated;
      Outcome.Figures.Interrupted :=
        Outcome.Figures.Interrupted + Interrupted;
   end Run;

   procedure Build is
   begin
      Is_Kept := True;
      The_World.Build ((Terminal => True, others => <>));
   end Build;

   function Process return Interfaces.C.int is
     (if The_World.Is_Built then The_World.Pid else -1);

   function Port return Positive is (The_World.Port);

   procedure Finish is
   begin
      The_World.Destroy;
      The_Link.Remove;
   end Finish;

end Trials;
