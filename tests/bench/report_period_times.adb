--  SPDX-License-Identifier: GPL-3.0-or-later
--  The jitter of the periodic tasks, compared with cyclictest.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Real_Time;         use Ada.Real_Time;
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
with Reports;               use Reports;
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

   Camera     : Emulators.Emulator;
   Supervisor : Supervisors.Supervisor;
   Cyclic     : array (Subject) of Child;
   Program    : GNAT.OS_Lib.String_Access :=
     GNAT.OS_Lib.Locate_Exec_On_Path ("cyclictest");
   Compared   : constant Boolean :=
     GNAT.OS_Lib."/=" (Program, null)
     and then Own_Process.Real_Time_Allowed;

   procedure Put
     (Which : Subject; Events : Event_Vectors.Vector; Text : String)
   is
      --  When each of them has come
      Name   : constant String := To_Lower (Which'Image);
      Period : constant String :=
        Reports.Member ("period", To_Duration (Period_Of (Which)));
      First  : Instant := Never;
      Times  : Samples.Set;
   begin
      for Item of Events loop
         if Item.Text = Text then
            if First = Never then
               First := Item.Begun;
            end if;
            Times.Add (Item.Begun - First);
         end if;
      end loop;
      if not Compared then
         Reports.Put (Name, Times, More => Period);
         return;
      end if;
      Check (Cyclic (Which).Exit_Status = 0, "cyclictest has failed");
      --  its last lines
      delay 0.2;
      Reports.Put
        (Name & ", to cyclictest", Times,
         More => Period & ", ""cyclictest"": "
           & Quoted (Cyclic (Which).Text (Output)));
   end Put;

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

   Put (Battery, Frames (Both_Ends.Ours), "v");
   Put (Reload, Frames (Both_Ends.Ours), "w");
   Put (Image, Messages (Both_Ends.Ours), "CIMG");
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
end Report_Period_Times;
