--  SPDX-License-Identifier: GPL-3.0-or-later
--  The jitter of the periodic tasks, compared with cyclictest.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Real_Time;         use Ada.Real_Time;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;
with System;

with Bench_Settings;
with Both_Ends;             use Both_Ends;
with Child_Processes;       use Child_Processes;
with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Reports;
with Samples;
with Schedule;
with Supervisors;

procedure Report_Period_Times is
   --  No command is sent meanwhile: by design a reload waits for a current
   --  exchange

   type Subject is (Battery, Reload, Image);

   Image_Period : constant Time_Span := Milliseconds (100);

   Period_Of : constant array (Subject) of Time_Span :=
     (Battery => Schedule.Battery_Period,
      Reload  => Schedule.Reload_Period,
      Image   => Image_Period);

   Priority_Of : constant array (Subject) of System.Priority :=
     (Battery => Schedule.Battery_Priority,
      Reload  => Schedule.Reload_Priority,
      Image   => Schedule.Capture_Priority);

   function Linux_Priority (Of_Subject : Subject) return Natural is
     (if Own_Process.Real_Time_Allowed
      then Priority_Of (Of_Subject) + 1 else 0);

   function Late
     (Events : Event_Vectors.Vector; Text : String; Period : Time_Span)
      return Samples.Set
   is
      --  How much later than on the grid of the earliest each has come
      Length : constant Duration := To_Duration (Period);
      First  : Instant := Never;
      Past   : Duration;
      Result : Samples.Set;
   begin
      for Item of Events loop
         if Item.Text = Text then
            if First = Never then
               First := Item.Begun;
            end if;
            Past := Item.Begun - First;
            Result.Add
              (Past - Length * Integer (Float (Past) / Float (Length)));
         end if;
      end loop;
      return Result.From_Least;
   end Late;

   function Cyclictest_Latencies (From : Child) return Samples.Set is
      --  Of its histogram, to the microsecond
      Result : Samples.Set;
   begin
      for Number in 1 .. From.Count (Output) loop
         declare
            Line  : constant String :=
              To_String (From.Element (Output, Number).Text);
            Blank : constant Natural := Index (Line, " ");
         begin
            if Line'Length > 0 and then Is_Digit (Line (Line'First))
              and then Blank > 0
            then
               for Count in 1 .. Natural'Value (Line (Blank .. Line'Last)) loop
                  Result.Add
                    (Duration
                       (Natural'Value (Line (Line'First .. Blank - 1)))
                     / 1_000_000);
               end loop;
            end if;
         end;
      end loop;
      return Result;
   end Cyclictest_Latencies;

   Camera     : Emulators.Emulator;
   Supervisor : Supervisors.Supervisor;
   Cyclic     : array (Subject) of Child;
   Program    : GNAT.OS_Lib.String_Access :=
     GNAT.OS_Lib.Locate_Exec_On_Path ("cyclictest");
   Compared   : constant Boolean :=
     GNAT.OS_Lib."/=" (Program, null)
     and then Own_Process.Real_Time_Allowed;
   Ours       : Samples.Set;

   procedure Compare (Name : String; Of_Subject : Subject) is
      --  Ours with cyclictest
      Floor : Samples.Set;
   begin
      if not Compared then
         Reports.Put (Name, Ours);
         return;
      end if;
      Check (Cyclic (Of_Subject).Exit_Status = 0, "cyclictest has failed");
      delay 0.2;
      --  its last lines
      Floor := Cyclictest_Latencies (Cyclic (Of_Subject)).From_Least;
      Reports.Compare (Name & ", to cyclictest", Ours, Floor,
                       (1 => (Reports.P999_Ratio, 1.5)));
   end Compare;

begin
   Reports.Begin_Section ("periods", "how late, against the earliest of all");
   Open_Line (Both_Ends.Ours);
   Camera.Start (Camera => True);
   Supervisor.Start ("--message-gap 0 --serial " & Device (Both_Ends.Ours)
                     & " --camera " & Camera.Camera_Url);
   Connect (Both_Ends.Ours, Supervisor.Port, By_Lines => True);
   Send (Both_Ends.Ours, "ROPN" & ASCII.LF & "RSWW" & ASCII.LF);
   Await_Message (Both_Ends.Ours, "AACK", Count => 2);
   Forget (Both_Ends.Ours);
   Send (Both_Ends.Ours, "COPN" & ASCII.LF);
   Await_Message (Both_Ends.Ours, "CIMG", Count => 5);
   if Compared then
      for Which in Subject loop
         Cyclic (Which).Launch
           ("cyclictest",
            Words
              ("--mlockall --quiet --default-system --threads=1"
               & " --histogram=20000 --priority="
               & Image (Linux_Priority (Which))
               & " --interval="
               & Image (Period_Of (Which) / Microseconds (1))
               & " --loops="
               & Image
                 (Milliseconds (1000 * Bench_Settings.Seconds)
                  / Period_Of (Which))));
      end loop;
   end if;
   Own_Process.Prefer_Real_Time (True);
   Serve (0.5);
   Forget (Both_Ends.Ours);
   Serve (Duration (Bench_Settings.Seconds));
   Own_Process.Prefer_Real_Time (False);

   for Which in Battery .. Reload loop
      Ours := Late (Frames (Both_Ends.Ours),
                    (if Which = Battery then "v" else "w"), Period_Of (Which));
      Compare (To_Lower (Which'Image), Which);
   end loop;
   Ours := Late (Messages (Both_Ends.Ours), "CIMG", Image_Period);
   Compare ("image", Image);
   Check ((for all Item of Messages (Both_Ends.Ours) => Item.Text /= "ATIM"),
          "the robot counts as lost: the machine was busy elsewhere for as"
          & " long as four time-outs");
   if not Compared then
      Reports.Put_Note
        ("not compared with cyclictest: that needs the package rt-tests"
         & " and real-time priorities");
   end if;
   Close_All;
   GNAT.OS_Lib.Free (Program);
   Reports.End_Section;
end Report_Period_Times;
