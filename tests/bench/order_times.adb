--  SPDX-License-Identifier: GPL-3.0-or-later
--  Orders and answers, beside a bare forwarder.

with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Bench_Settings;
with Both_Ends;         use Both_Ends;
with Busy_Loops;
with Child_Processes;   use Child_Processes;
with Emulators;
with Expectations;      use Expectations;
with Instants;          use Instants;
with Own_Priority;
with Programs;
with Reports;
with Samples;
with Schedule;
with Supervisors;

package body Order_Times is

   Block : constant := 50;
   --  Exchanges through one of the two before it is the other's turn: what
   --  the machine does meanwhile concerns both

   Attempts : constant := 5;

   Silence_Limit : constant Duration := 0.080 + 3 * 0.001_042;
   --  The robot's answer is waited for 80 ms from the end of the command,
   --  whose three bytes would take so long at 9600 baud

   type Passage is (Ours, Floor);

   Place_Of : constant array (Passage) of Place :=
     (Ours => Both_Ends.Ours, Floor => Both_Ends.Floor);

   type Distribution is array (Passage) of Samples.Set;

   type Condition is (Idle, Loaded, With_Gap);

   Orders, Answers : array (Condition) of Distribution;
   Stops           : Samples.Set;
   Left_Out        : Natural := 0;
   --  exchanges that were repeated
   Measured        : Boolean := False;

   Source : Generator;
   Amount : Natural := 0;

   procedure Measure_All;

   procedure Measure (Under : Condition);
   --  Idle: no camera. Loaded: images with positions, two busy loops.
   --  With_Gap: images without more, and the default gap between messages

   procedure One (Through : Passage; Result : out Exchange);

   procedure Measure_Stops;
   --  Ours must be there

   procedure Compare (Name : String; Of_Both : Distribution);
   --  Against the goal of orders and answers

   ---------
   -- One --
   ---------

   procedure One (Through : Passage; Result : out Exchange) is
      --  a different one each time
      Value : constant String :=
        Trim (Natural'Image (1 + Amount mod 9_000), Both);
   begin
      Amount := Amount + 1;
      Serve (0.001 + 0.002 * Duration (Random (Source)));
      Both_Ends.Measure
        (Place_Of (Through),
         (case Through is
             when Ours  => "RMOV:" & Value & ASCII.LF,
             when Floor => Framed ("M=" & Value)),
         "M=" & Value, Result);
   end One;

   -------------------
   -- Measure_Stops --
   -------------------

   procedure Measure_Stops is
      Unused, Begun, Time : Instant;
   begin
      for Number in 1 .. Integer'Max (20, Bench_Settings.Sample_Count / 10)
      loop
         Serve (0.01);
         Forget (Both_Ends.Ours);
         Set_Unanswered (Both_Ends.Ours, "b");
         Send (Both_Ends.Ours, "RGST" & ASCII.LF);
         Await_Frame (Both_Ends.Ours, "b", Unused);
         Serve (0.002 + 0.07 * Duration (Random (Source)));
         Begun := Now;
         Send (Both_Ends.Ours, "RSTP" & ASCII.LF);
         Await_Frame (Both_Ends.Ours, "M=0", Time);
         Stops.Add (Time - Begun);
         Await_Message (Both_Ends.Ours, "ATIM AACK", Count => 2);
      end loop;
   end Measure_Stops;

   -------------
   -- Measure --
   -------------

   procedure Measure (Under : Condition) is
      Forwarder  : Child;
      Supervisor : Supervisors.Supervisor;
      Camera     : Emulators.Emulator;
      Load       : Busy_Loops.Load;
      Result     : Exchange;
      Line       : Unbounded_String;
      Options    : Arguments := Words ("forward");
   begin
      for Which in Passage loop
         Open_Line (Place_Of (Which));
      end loop;
      Options.Append (Device (Both_Ends.Floor));
      --  that of the task which writes to the line: Linux counts from 1
      Options.Append
        (Trim (Integer'Image
                 (if Own_Priority.Real_Time_Allowed
                  then Schedule.Line_Priority + 1 else 0), Both));
      Forwarder.Start (Programs.Beside ("forwarder"), Options);
      Check
        (Forwarder.Awaited (Errors, "listening on", 5.0) > 0,
         "the forwarder does not listen");
      Line := Forwarder.Element
        (Errors, Forwarder.Awaited (Errors, "listening on", 0.0)).Text;
      Connect
        (Both_Ends.Floor,
         Positive'Value
           (Slice (Line, Index (Line, ":") + 1, Length (Line))),
         By_Lines => False);

      if Under /= Idle then
         Camera.Start (Camera => True);
      end if;
      Supervisor.Start
        ("--serial " & Device (Both_Ends.Ours)
         & (if Under = With_Gap then "" else " --message-gap 0")
         & (if Under = Idle then "" else " --camera " & Camera.Camera_Url));
      Connect (Both_Ends.Ours, Supervisor.Port, By_Lines => True);
      Own_Priority.Prefer_Real_Time (True);
      Send (Both_Ends.Ours, "ROPN" & ASCII.LF & "RSOW" & ASCII.LF);
      Await_Message (Both_Ends.Ours, "AACK", Count => 2);
      if Under /= Idle then
         Forget (Both_Ends.Ours);
         Send (Both_Ends.Ours,
               "COPN" & ASCII.LF
               & (if Under = Loaded then "CPCO" & ASCII.LF else ""));
         Await_Message (Both_Ends.Ours, "CIMG", Count => 10);
      end if;
      Own_Priority.Prefer_Real_Time (False);
      if Under = Loaded then
         Load.Start;
      end if;
      Own_Priority.Prefer_Real_Time (True);
      Serve (0.5);

      while Orders (Under) (Floor).Count < Bench_Settings.Sample_Count loop
         for Which in Passage loop
            for Count in 1 .. Block loop
               for Attempt in 1 .. Attempts loop
                  One (Which, Result);
                  exit when Result.Clean;
                  Left_Out := Left_Out + 1;
                  Check
                    (Attempt < Attempts,
                     "no exchange succeeds any more: " & Which'Image);
                  --  what is late comes meanwhile
                  Serve (0.2);
               end loop;
               Orders (Under) (Which).Add (Result.Order);
               Answers (Under) (Which).Add (Result.Answer);
            end loop;
         end loop;
      end loop;
      if Under = Idle then
         Measure_Stops;
      end if;
      Own_Priority.Prefer_Real_Time (False);
      Close_All;
   end Measure;

   -----------------
   -- Measure_All --
   -----------------

   procedure Measure_All is
   begin
      if not Measured then
         Measured := True;
         for Under in Condition loop
            Measure (Under);
         end loop;
      end if;
   end Measure_All;

   -------------
   -- Compare --
   -------------

   procedure Compare (Name : String; Of_Both : Distribution) is
      use Reports;
   begin
      Reports.Compare
        (Name, Of_Both (Ours), Of_Both (Floor),
         "median <= 1.5 x, p99 <= 2 x the floor",
         Ratio (Of_Both (Ours), Of_Both (Floor), 0.5) <= 1.5
         and then Ratio (Of_Both (Ours), Of_Both (Floor), 0.99) <= 2.0);
   end Compare;

   -------------------
   -- Report_Orders --
   -------------------

   procedure Report_Orders is
      Limit : Duration;
   begin
      Reports.Begin_Section
        ("orders", "monitor's order to first byte at the robot's end");
      Measure_All;
      Compare ("order, idle", Orders (Idle));
      Compare ("order, full load", Orders (Loaded));
      Limit := Silence_Limit + Orders (Idle) (Ours).Quantile (0.999);
      Reports.Put
        ("stop while another order waits for a silent robot", Stops,
         "max <= " & Milliseconds (Limit)
         & ", the rest of its time-out and an order",
         Stops.Quantile (1.0) <= Limit);
      Reports.Put_Note
        (Trim (Left_Out'Image, Both)
         & " exchanges were repeated: something else was on the line, or"
         & " they failed");
      Reports.End_Section;
   end Report_Orders;

   --------------------
   -- Report_Answers --
   --------------------

   procedure Report_Answers is
   begin
      Reports.Begin_Section
        ("answers", "robot's answer to the monitor's receipt");
      Measure_All;
      Compare ("answer, idle", Answers (Idle));
      Compare ("answer, full load", Answers (Loaded));
      Reports.Put
        ("answer, while images stream, default gap",
         Answers (With_Gap) (Ours), "p99.9 < 10 ms",
         Answers (With_Gap) (Ours).Quantile (0.999) < 0.010);
      Reports.End_Section;
   end Report_Answers;

begin
   Reset (Source, 5544);
end Order_Times;
