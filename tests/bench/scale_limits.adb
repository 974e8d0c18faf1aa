--  SPDX-License-Identifier: GPL-3.0-or-later
--  How much the supervisor can do.

with Ada.Containers.Indefinite_Ordered_Maps;
with Ada.Directories;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Base64;
with Bench_Settings;
with Both_Ends;         use Both_Ends;
with Bytes;
with Emulators;
with Instants;          use Instants;
with Monitor.Outbox;
with Own_Process;
with Paced_Cameras;
with Plain_Numbers;     use Plain_Numbers;
with Process_Facts;
with Programs;
with Reports;
with Samples;
with Supervisors;

package body Scale_Limits is

   Fastest : constant := 100;
   --  images a second that --fps takes

   Jpeg : constant Bytes.Byte_Array (1 .. Monitor.Outbox.Max_Jpeg) :=
     (others => 17);
   Text : Monitor.Outbox.Message_Buffer := (others => ' ');
   --  too large for a stack

   function Recording return String is
     (" --trace " & Programs.Temporary_Folder & "/scale.txt");

   --  Without and with a recording, in turns

   procedure Take_Picture (Size : String; Path : String) is
      --  Of the emulated arena with its robot
      Camera : Emulators.Emulator;
   begin
      Camera.Start (Camera => True, Options => "--frame-size " & Size);
      Camera.Save_Snapshot (Path);
   end Take_Picture;

   function Keeps
     (Picture, Size : String; Positions : Boolean; Rate : Positive)
      return Boolean
   is
      --  No period without its image, for a while
      Supervisor : Supervisors.Supervisor;
      Camera     : Paced_Cameras.Camera;
      Span       : constant Duration :=
        Duration'Max (1.5, Duration (Bench_Settings.Seconds) / 20);
      Last       : Instant := Never;
      Longest    : Duration := 0.0;
   begin
      --  a little faster than is asked for: each period has a new image
      Camera.Start (Picture, Float (Rate + Rate / 10 + 1));
      Supervisor.Start ("--message-gap 0 --frame-size " & Size & " --fps "
                        & Image (Rate) & " --camera " & Camera.Url);
      Connect (Ours, Supervisor.Port, By_Lines => True);
      Send (Ours, "COPN" & ASCII.LF
            & (if Positions then "CPCO" & ASCII.LF else ""));
      Await_Message (Ours, "CIMG", Count => 3);
      Serve (0.3);
      Forget (Ours);
      Own_Process.Prefer_Real_Time (True);
      Serve (Span);
      Own_Process.Prefer_Real_Time (False);
      for Item of Messages (Ours) loop
         if Item.Text = "CIMG" then
            if Last /= Never then
               Longest := Duration'Max (Longest, Item.Ended - Last);
            end if;
            Last := Item.Ended;
         end if;
      end loop;
      Close_All;
      Camera.Stop;
      Supervisor.Stop;
      return Last /= Never and then Longest < 1.5 / Rate;
   end Keeps;

   function Highest_Rate
     (Picture, Size : String; Positions : Boolean) return Natural
   is
      Good : Natural  := 0;
      Bad  : Positive := Fastest + 1;
      Next : Positive := Fastest;
   begin
      --  until they are as close as five in a hundred
      while Bad - Good > 1 + Good / 20 loop
         --  one failure may be the machine's
         if Keeps (Picture, Size, Positions, Next)
           or else Keeps (Picture, Size, Positions, Next)
         then
            Good := Next;
         else
            Bad := Next;
         end if;
         Next := Integer'Max (1, (Good + Bad) / 2);
      end loop;
      return Good;
   end Highest_Rate;

   procedure Report_Rates is

      procedure Report_Size (Size : String) is
         Picture : constant String :=
           Programs.Temporary_Folder & "/" & Size & ".jpg";
      begin
         Take_Picture (Size, Picture);
         for Positions in Boolean loop
            Reports.Put_Number
              ("highest rate, " & Size
               & (if Positions then ", positions" else ""),
               Float (Highest_Rate (Picture, Size, Positions)), "images/s");
         end loop;
         Ada.Directories.Delete_File (Picture);
      end Report_Size;

   begin
      Report_Size ("320x240");
      Report_Size ("640x480");
      Report_Size ("1280x720");
      Report_Size ("1920x1080");
   end Report_Rates;

   procedure Report_Processor_Use (Positions : Boolean) is

      package Maps is new Ada.Containers.Indefinite_Ordered_Maps
        (String, Duration);
      subtype Times is Maps.Map;

      With_Opencv : constant String := "th_camera th_captureImg th_arene";

      Span : constant Duration :=
        Duration'Max (5.0, Duration (Bench_Settings.Seconds) / 4);
      Name : constant String := (if Positions then " with positions" else "");

      Camera : Emulators.Emulator;

      procedure Look (Supervisor : Supervisors.Supervisor; Result : out Times)
      is
         --  What each thread has used
         use Ada.Directories;
         Folder : constant String :=
           "/proc/" & Image (Integer (Supervisor.Pid)) & "/task";

         procedure Add (Which : Directory_Entry_Type) is
            Thread : constant String := Folder & "/" & Simple_Name (Which);
         begin
            if Simple_Name (Which) not in "." | ".." then
               declare
                  Line : constant String :=
                    Process_Facts.File_Line (Thread & "/schedstat");
               begin
                  --  nanoseconds on a processor come first
                  Result.Include
                    (Process_Facts.File_Line (Thread & "/comm") & " "
                     & Simple_Name (Which),
                     Duration
                       (Long_Long_Integer'Value
                          (Line (1 .. Index (Line, " ") - 1)) / 1_000)
                     / 1_000_000);
               end;
            end if;
         end Add;

      begin
         Result := Maps.Empty_Map;
         Search (Folder, "", (Directory => True, others => False), Add'Access);
      end Look;

      function Encoding_Time return Duration is
         --  Of an image like those that have come, in base64: what
         --  th_captureImg does that is not OpenCV's
         Rounds : constant := 200;
         Last   : Natural;
         Size   : Natural := 0;
         Begun  : Instant;
         Each   : Samples.Set;
      begin
         for Item of Messages (Ours) loop
            if Item.Text = "CIMG" then
               Size := Item.Size / 4 * 3;
            end if;
         end loop;
         for Round in 1 .. Rounds loop
            Begun := Now;
            Base64.Encode (Jpeg, Size, Text, 6, Last);
            Each.Add (Now - Begun);
         end loop;
         return Each.Quantile (0.5);
      end Encoding_Time;

      procedure Measure (Recorded, Told : Boolean; Share : in out Float) is
         --  Adds half of the share of a core that it uses without OpenCV.
         --  Recorded: with --trace. Told: what goes to OpenCV, and all of it
         Supervisor : Supervisors.Supervisor;
         Before     : Times;
         After      : Times;
         All_Of_It  : Duration := 0.0;
         Own        : Duration := 0.0;
      begin
         Open_Line (Ours);
         Supervisor.Start
           ("--serial " & Device (Ours) & " --camera " & Camera.Camera_Url
            & (if Recorded then Recording else ""));
         Connect (Ours, Supervisor.Port, By_Lines => True);
         Send (Ours, "ROPN" & ASCII.LF & "RSWW" & ASCII.LF & "COPN" & ASCII.LF
               & (if Positions then "CPCO" & ASCII.LF else ""));
         Await_Message (Ours, "CIMG", Count => 5);
         Look (Supervisor, Before);
         Serve (Span);
         Look (Supervisor, After);
         for Place in After.Iterate loop
            declare
               Thread : constant String := Maps.Key (Place);
               Title  : constant String :=
                 Thread (1 .. Index (Thread, " ") - 1);
               Used   : constant Duration := Maps.Element (Place)
                 - (if Before.Contains (Thread) then Before (Thread)
                    else 0.0);
            begin
               All_Of_It := All_Of_It + Used;
               if Index (Title, "th_") = 1
                 and then Index (With_Opencv, Title) = 0
               then
                  Own := Own + Used;
               end if;
               if Told and then Index (With_Opencv, Title) > 0
                 and then Used > 0.0
               then
                  Reports.Put_Number
                    ("processor, " & Title & Name,
                     100.0 * Float (Used) / Float (Span), "% of a core");
               end if;
            end;
         end loop;
         if Told then
            Reports.Put_Number ("processor, all of it" & Name,
                                100.0 * Float (All_Of_It) / Float (Span),
                                "% of a core");
         end if;
         Share := Share
           + 50.0 * (Float (Own) / Float (Span) + Float (10 * Encoding_Time));
         Close_All;
      end Measure;

      Share    : Float := 0.0;
      Recorded : Float := 0.0;
   begin
      Camera.Start (Camera => True);
      Measure (Recorded => False, Told => True,  Share => Share);
      Measure (Recorded => True,  Told => False, Share => Recorded);
      Measure (Recorded => True,  Told => False, Share => Recorded);
      Measure (Recorded => False, Told => False, Share => Share);
      Reports.Put_Number
        ("processor, without OpenCV" & Name, Share, "% of a core",
         Wanted => (1 => (Reports.Value, 1.0, False)));
      Reports.Put_Number
        ("processor, without OpenCV" & Name & ", with --trace", Recorded,
         "% of a core",
         Floor  => Share,
         Wanted => (1 => (Reports.Ratio, 1.02, False)));
   end Report_Processor_Use;

   procedure Report_Commands is

      procedure Count (Name, Command, Answer : String) is
         Turns  : constant := 4;
         Plain  : Float := 0.0;
         Traced : Float := 0.0;

         function Rate (Options : String) return Float is
            Supervisor : Supervisors.Supervisor;
            Window     : constant := 32;  --  sent together
            Span       : constant Duration :=
              Duration (Bench_Settings.Seconds) / 10 / Turns;
            Total      : Natural := 0;
            Begun      : Instant;
            Result     : Float;
         begin
            Open_Line (Ours);
            Supervisor.Start ("--serial " & Device (Ours) & Options);
            Connect (Ours, Supervisor.Port, By_Lines => True);
            Send (Ours, "ROPN" & ASCII.LF & "RSOW" & ASCII.LF);
            Await_Message (Ours, "AACK", Count => 2);
            Begun := Now;
            while Now - Begun < Span loop
               Forget (Ours);
               Send (Ours, Window * (Command & ASCII.LF));
               Await_Message (Ours, Answer, Count => Window);
               Total := Total + Window;
            end loop;
            Result := Float (Total) / Float (Duration'(Now - Begun));
            Close_All;
            return Result;
         end Rate;

      begin
         for Turn in 1 .. Turns loop
            Plain := Plain + Rate ("") / Float (Turns);
            Traced := Traced + Rate (Recording) / Float (Turns);
         end loop;
         Reports.Put_Number (Name, Plain, "a second");
         Reports.Put_Number (Name & ", with --trace", Traced, "a second",
                             Floor  => Plain,
                             Wanted => (1 => (Reports.Ratio, 0.98, True)));
      end Count;

   begin
      Count ("commands answered by the supervisor itself", "what", "ACER");
      Count ("movements through an unpaced line", "RMOV:50", "AACK");
   end Report_Commands;

   procedure Report is
   begin
      Reports.Begin_Section ("scale", "how much it can do");
      Report_Rates;
      Report_Processor_Use (Positions => False);
      Report_Processor_Use (Positions => True);
      Report_Commands;
      Reports.Put_Note
        ("highest rate without a missed period, of" & Fastest'Image
         & " tried; processor: at 10 images/s of 640x480");
      Reports.Put_Note
        ("at 9600 baud an exchange of 8 and 3 bytes takes 11.5 ms: 87"
         & " movements a second at most");
      Reports.End_Section;
   end Report;

end Scale_Limits;
