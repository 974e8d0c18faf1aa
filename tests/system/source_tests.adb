--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14, F15: cameras of every rate, and V4L2 cameras of every kind.

with Ada.Directories;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;

with Emulators;
with Expectations;          use Expectations;
with Images;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Paced_Cameras;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;
with Supervisors;

procedure Source_Tests is

   --  Cameras of every rate, side by side: each with a supervisor and a
   --  monitor of its own

   type Watch is limited record
      Camera     : Paced_Cameras.Camera;
      Supervisor : Supervisors.Supervisor;
      Monitor    : Monitor_Clients.Client;
   end record;

   --  V4L2 cameras: tests/system/v4l2_camera stands for the kernel's

   function V4l2_Settings return String is
     (Programs.Temporary_Folder & "/v4l2_camera");

   function Small_Image return String is
      --  The path of one; made at the first use
      Path : constant String := Programs.Temporary_Folder & "/small.jpg";
      E    : Emulators.Emulator;
   begin
      if not Ada.Directories.Exists (Path) then
         E.Start (Camera => True, Options => "--frame-size 160x120");
         E.Save_Snapshot (Path);
      end if;
      return Path;
   end Small_Image;

   procedure Begin_Watch
     (W : in out Watch; Image : String; Rate : Float; Jitter : Duration) is
      --  Image: the path of one of 160x120
   begin
      W.Camera.Start (Image, Rate, Jitter);
      W.Supervisor.Start ("--frame-size 160x120 --camera " & W.Camera.Url);
      W.Monitor.Connect (W.Supervisor.Port);
      W.Monitor.Expect ("COPN", "AACK");
   end Begin_Watch;

   procedure Judge
     (W        : Watch;
      From, To : Instant;
      Name     : String;
      Rate     : Float;
      Jitter   : Duration;
      All_Sent : Boolean)
   is
      --  What came between the two: Rate is that of the source, or a lower
      --  mean; All_Sent: every image is to come
      Wanted   : constant Float := Float'Min (10.0, Rate);
      Longest  : constant Duration := Duration (1.0 / Rate) + 2.0 * Jitter;
      --  Between two images of the source
      Ages     : Samples.Set;
      Between  : Samples.Set;
      First    : Instant := Never;
      Last     : Instant := Never;
      Number   : Natural := 0;
      Left_Out : Natural := 0;
      Mean     : Float;
      Item     : Message;
      Mark     : Paced_Cameras.Mark;
   begin
      for K in 1 .. W.Monitor.Count loop
         Item := W.Monitor.Element (K);
         if Item.Label = "CIMG" and then Item.Time - From >= 0.0
           and then To - Item.Time >= 0.0
         then
            Mark := Paced_Cameras.Mark_Of (To_String (Item.Data));
            if First = Never then
               First := Item.Time;
            else
               Check (Mark.Number > Number,
                      Name & ": image" & Mark.Number'Image & " after"
                      & Number'Image);
               Left_Out := Left_Out + Mark.Number - Number - 1;
               Between.Add (abs (Item.Time - Last - Duration (1.0 / Wanted)));
            end if;
            Ages.Add (Item.Time - Mark.Time);
            Last := Item.Time;
            Number := Mark.Number;
         end if;
      end loop;
      Check_In_Time
        (Ages.Count > 10,
         Name & ":" & Natural'Image (Ages.Count) & " images, the last of"
         & W.Monitor.Count'Image & " messages "
         & (if W.Monitor.Count = 0 then ""
            else Milliseconds
              (To - W.Monitor.Element (W.Monitor.Count).Time))
         & " before the end");
      Mean := Float (Between.Count) / Float (Duration'(Last - First));
      Note (Name & ":" & Natural'Image (Ages.Count) & " images, "
            & Rounded (Mean) & " a second, interval off by "
            & Milliseconds (Between.Quantile (0.99))
            & " (99 %), age " & Milliseconds (Ages.Quantile (0.99))
            & " (99 %), " & Milliseconds (Ages.Quantile (1.0)) & " (longest)");

      --  the first and the last may each come earlier or later
      Check_In_Time
        (abs (Mean - Wanted) <= 0.01 * Wanted
           + Wanted * Float (2.0 * Jitter) / Float (Duration'(Last - First)),
         Name & ": " & Rounded (Mean) & " images a second");
      Check_In_Time (not All_Sent or else Left_Out = 0,
                     Name & ":" & Left_Out'Image & " left out");
      --  a busy machine takes its time over one or the other
      Check_Within (Ages.Quantile (0.95), Longest + 0.02,
                    Name & ": age of 95 in 100");
      Check_Within
        (Ages.Quantile (1.0), Longest + 0.1, Name & ": age of the oldest");
      if Rate >= 10.0 then
         Check_Within (Between.Quantile (0.95), 0.02,
                       Name & ": intervals of 95 in 100 off");
      end if;
   end Judge;

   procedure Sources is

      type Kind is (Steady, Drifts, Changes);

      type Source is record
         Rate   : Float;
         Jitter : Duration := 0.0;
         What   : Kind := Steady;
      end record;

      Each : constant array (Positive range <>) of Source :=
        ((5.0, others => <>), (7.5, others => <>), (9.9, others => <>),
         (10.0, others => <>), (10.1, others => <>), (12.0, others => <>),
         (15.0, others => <>), (25.0, others => <>), (29.97, others => <>),
         (30.0, others => <>), (60.0, others => <>),
         (5.0, 0.03, Steady), (9.9, 0.03, Steady), (10.0, 0.03, Steady),
         (10.1, 0.03, Steady), (12.0, 0.03, Steady), (30.0, 0.03, Steady),
         (10.1, 0.0, Drifts),
         (30.0, 0.0, Changes));

      Dim   : constant array (1 .. 4) of Float := (30.0, 12.0, 7.5, 30.0);
      --  The light of the one that changes, for Stage each
      Stage : constant Duration := 4.0;
      Step  : constant Duration := 0.2;
      Path  : constant String := Small_Image;
      Watches : array (Each'Range) of Watch;
      Begun   : Instant;
      Part    : Instant;
   begin
      for K in Each'Range loop
         Begin_Watch (Watches (K), Path, Each (K).Rate, Each (K).Jitter);
      end loop;
      delay 3.0;
      Begun := Now;
      for Light in Dim'Range loop
         Part := Now;
         for K in Each'Range loop
            if Each (K).What = Changes then
               Watches (K).Camera.Set_Rate (Dim (Light));
            end if;
         end loop;
         while Now - Part < Stage loop
            delay Step;
            for K in Each'Range loop
               if Each (K).What = Drifts then
                  Watches (K).Camera.Set_Rate
                    (10.1 - 0.2 * Float (Duration'(Now - Begun))
                       / Float (Stage * Dim'Length));
               end if;
            end loop;
         end loop;
         for K in Each'Range loop
            if Each (K).What = Changes then
               Judge (Watches (K), Part + 1.0, Now,
                      "changed to " & Rounded (Dim (Light)), Dim (Light), 0.0,
                      All_Sent => Dim (Light) < 10.0);
            end if;
         end loop;
      end loop;
      for K in Each'Range loop
         case Each (K).What is
            when Steady =>
               Judge (Watches (K), Begun, Now,
                      Rounded (Each (K).Rate) & " +-"
                      & Milliseconds (Each (K).Jitter),
                      Each (K).Rate, Each (K).Jitter,
                      All_Sent => Each (K).Rate < 10.0);
            when Drifts =>
               --  half of the time ten, then down to 9.9
               Judge (Watches (K), Begun, Now, "drifting", 9.975, 0.0,
                      All_Sent => False);
            when Changes =>
               null;
         end case;
      end loop;
   end Sources;

   procedure Set_Camera
     (Image  : String;
      Format : String  := "MJPG";
      Size   : String  := "640 480";
      Rate   : String  := "30 1";
      Broken : Natural := 0;
      State  : String  := "on")
   is
      --  What there is to be opened from now on
      File    : File_Type;
      Renamed : Boolean;
   begin
      Create (File, Out_File, V4l2_Settings & ".new");
      Put_Line (File, "format " & Format);
      Put_Line (File, "size " & Size);
      Put_Line (File, "rate " & Rate);
      Put_Line (File, "image " & Image);
      Put_Line (File, "broken" & Broken'Image);
      Put_Line (File, "state " & State);
      Close (File);
      GNAT.OS_Lib.Rename_File (V4l2_Settings & ".new", V4l2_Settings, Renamed);
      Check (Renamed, "the camera's settings cannot be changed");
   end Set_Camera;

   function Launcher return String is
     (Programs.Preload ("libv4l2_camera.so")
      & " V4L2_CAMERA=" & V4l2_Settings);
   --  Of a supervisor that finds that camera

   procedure Picture
     (Path : String; True_Pose : out Emulators.Truth;
      Size : String := "640x480")
   is
      --  The arena as a JPEG, and where the robot is in it
      E : Emulators.Emulator;
   begin
      E.Start (Camera  => True,
               Options => "--noise 0 --pose 30,40,60 --frame-size " & Size);
      E.Save_Snapshot (Path);
      True_Pose := E.Pose;
   end Picture;

   procedure Start (R : in out Rig; Source : String := "0") is
      --  A supervisor with that camera, and a monitor
   begin
      R.Supervisor.Start ("--camera " & Source, Launcher => Launcher);
      Connect (R);
   end Start;

   procedure Expect_Check (Granted : String) is
      --  --check names what the camera grants
      S : Supervisors.Supervisor;
   begin
      S.Run ("--check --port 0 --camera 0", Launcher => Launcher);
      Check (S.Exit_Status in 0 | 1, "--check");
      Check (Index (S.Output_Text, "camera: delivers images, " & Granted) > 0,
             "--check says " & S.Output_Text);
   end Expect_Check;

   procedure Expect_Picture (R : in out Rig; X, Y : Float) is
      --  Images of 640x480, grey, with the robot at X, Y
      Unused : Message;
      Seen   : Images.Facts;
      Found  : Boolean;
      At_X   : Float;
      At_Y   : Float;
   begin
      R.Monitor.Skip_To_Now;
      for Number in 1 .. 3 loop
         Unused := R.Monitor.Next_Of ("CIMG");
      end loop;
      Seen := Images.Seen (R.Monitor.Last_Image);
      Check (Seen.Width = 640 and then Seen.Height = 480,
             "image of" & Seen.Width'Image & " x" & Seen.Height'Image);
      Check (Seen.Coloured = 0, "a colour where there is none");
      Images.Find_Marker (R.Monitor.Last_Image, Found, At_X, At_Y);
      Check
        (Found and then abs (At_X - X) <= 2.0 and then abs (At_Y - Y) <= 2.0,
         "the robot of the image is seen at" & At_X'Image & At_Y'Image
         & " instead of" & X'Image & Y'Image);
   end Expect_Picture;

   procedure Expect_Own_Jpeg (R : in out Rig; Path : String; Count : Positive)
   is
      --  So many images with the very bytes of the file
      Unused : Message;
   begin
      R.Monitor.Skip_To_Now;
      for Number in 1 .. Count loop
         Unused := R.Monitor.Next_Of ("CIMG");
         Check (Images.Is_File (R.Monitor.Last_Image, Path),
                "image" & Number'Image & " is not the camera's");
      end loop;
   end Expect_Own_Jpeg;

   procedure Expect_Rate (R : in out Rig; Rate : Float) is
      Count : constant := 15;
      First : Instant;
      Last  : Instant;
      Mean  : Float;
   begin
      R.Monitor.Skip_To_Now;
      First := R.Monitor.Next_Of ("CIMG").Time;
      for Number in 1 .. Count loop
         Last := R.Monitor.Next_Of ("CIMG").Time;
      end loop;
      Mean := Float (Count) / Float (Duration'(Last - First));
      Check_In_Time
        (abs (Mean - Rate) <= 0.05 * Rate,
         Rounded (Mean) & " images a second instead of " & Rounded (Rate));
   end Expect_Rate;

   procedure V4l2_Motion_Jpeg is
      Path : constant String := Programs.Temporary_Folder & "/v4l2.jpg";
      Pose : Emulators.Truth;
   begin
      Picture (Path, Pose);
      Set_Camera (Path);
      Expect_Check ("MJPG 640x480, 30 a second");
      declare
         R : Rig;
      begin
         Start (R);
         Open_Camera (R);
         Expect_Own_Jpeg (R, Path, Count => 5);
         R.Monitor.Expect ("CPCO", "AACK");
         Check (R.Monitor.Next_Of ("CPOS").Data /= "", "no position");
         R.Monitor.Expect ("CCLS", "AACK");
         Open_Camera (R);
      end;
      declare
         R : Rig;
      begin
         Start (R, "/dev/video0");
         Open_Camera (R);
         Expect_Own_Jpeg (R, Path, Count => 3);
      end;
   end V4l2_Motion_Jpeg;

   procedure V4l2_Pixels is
      Path : constant String := Programs.Temporary_Folder & "/pixels.jpg";
      Raw  : constant String := Programs.Temporary_Folder & "/pixels.yuyv";
      Pose : Emulators.Truth;
      R    : Rig;
   begin
      Picture (Path, Pose);
      Images.Write_Yuyv (Path, Raw);
      Set_Camera (Raw, Format => "YUYV");
      Expect_Check ("YUYV 640x480, 30 a second");
      Start (R);
      Open_Camera (R);
      Expect_Picture (R, Pose.Cx, Pose.Cy);
   end V4l2_Pixels;

   procedure V4l2_Other_Size is
      Path : constant String := Programs.Temporary_Folder & "/large.jpg";
      Pose : Emulators.Truth;
      R    : Rig;
   begin
      Picture (Path, Pose, Size => "800x600");
      Set_Camera (Path, Size => "800 600");
      Expect_Check ("MJPG 800x600, 30 a second");
      Start (R);
      Open_Camera (R);
      Expect_Picture (R, 0.8 * Pose.Cx, 0.8 * Pose.Cy);
   end V4l2_Other_Size;

   procedure V4l2_Rates is
      Path : constant String := Programs.Temporary_Folder & "/rate.jpg";
      Raw  : constant String := Programs.Temporary_Folder & "/rate.yuyv";
      Pose : Emulators.Truth;
      R    : Rig;

      procedure Expect (Granted : String; Rate : Float) is
      begin
         Expect_Check (Granted);
         Open_Camera (R);
         Expect_Rate (R, Rate);
         R.Monitor.Expect ("CCLS", "AACK");
      end Expect;

   begin
      Picture (Path, Pose);
      Images.Write_Yuyv (Path, Raw);
      Set_Camera (Path);
      Start (R);
      Expect ("MJPG 640x480, 30 a second", 10.0);
      Set_Camera (Path, Rate => "15 1");
      Expect ("MJPG 640x480, 15 a second", 10.0);
      Set_Camera (Path, Rate => "15 2");
      Expect ("MJPG 640x480, 7.5 a second", 7.5);
      Set_Camera (Path, Broken => 3);
      Expect ("MJPG 640x480, 30 a second", 10.0);
      Set_Camera (Raw, Format => "YUYV");
      Expect ("YUYV 640x480, 30 a second", 10.0);
   end V4l2_Rates;

   procedure V4l2_Unplugged is
      Path : constant String := Programs.Temporary_Folder & "/plug.jpg";
      Pose : Emulators.Truth;
      Item : Message;
      R    : Rig;
   begin
      Picture (Path, Pose);
      Set_Camera (Path);
      Start (R);
      Open_Camera (R);
      for Attempt in 1 .. 2 loop
         Set_Camera (Path, State => "gone");
         Item := R.Monitor.Next_Of ("MSSG");
         Check (Index (Item.Data, "camera closed") > 0,
                "the monitor is told " & To_String (Item.Data));
         R.Monitor.Expect ("COPN", "ANAK");
         R.Monitor.Expect_Silence ("CIMG", For_Time => 0.3);
         Set_Camera (Path);
         Open_Camera (R);
         Expect_Own_Jpeg (R, Path, Count => 3);
      end loop;
      R.Monitor.Expect ("CCLS", "AACK");
   end V4l2_Unplugged;

   procedure V4l2_Broken_Jpeg is
      Path : constant String := Programs.Temporary_Folder & "/broken.jpg";
      Pose : Emulators.Truth;
      R    : Rig;
   begin
      Picture (Path, Pose);

      --  Now and then: what is broken is left out
      Set_Camera (Path, Broken => 3);
      Start (R);
      Open_Camera (R);
      Expect_Own_Jpeg (R, Path, Count => 10);
      R.Monitor.Expect ("CCLS", "AACK");

      --  Nothing else, and no other format is granted
      Set_Camera (Path, Broken => 1);
      R.Monitor.Expect ("COPN", "ANAK");
      Set_Camera (Path);
      Open_Camera (R);
      Expect_Own_Jpeg (R, Path, Count => 3);
   end V4l2_Broken_Jpeg;

   procedure V4l2_Busy is
      Path : constant String := Programs.Temporary_Folder & "/busy.jpg";
      Pose : Emulators.Truth;
      R    : Rig;
   begin
      Picture (Path, Pose);
      Set_Camera (Path, State => "busy");
      Start (R);
      R.Monitor.Expect ("COPN", "ANAK");
      R.Supervisor.Expect_Log ("another program uses it");
      Set_Camera (Path, State => "meta");
      R.Monitor.Expect ("COPN", "ANAK");
      R.Supervisor.Expect_Log ("it gives no images, perhaps metadata");
      R.Monitor.Expect ("COPN", "ANAK");
      Set_Camera (Path);
      Open_Camera (R);
      Expect_Own_Jpeg (R, Path, Count => 3);
   end V4l2_Busy;

begin
   Add ("F15_Cameras_Of_Every_Rate", Sources'Access, Timed => True);
   Add ("F14_V4L2_Motion_JPEG", V4l2_Motion_Jpeg'Access);
   Add ("F14_V4L2_Pixels", V4l2_Pixels'Access);
   Add ("F14_V4L2_Other_Size", V4l2_Other_Size'Access);
   Add ("F15_V4L2_Rates", V4l2_Rates'Access, Timed => True);
   Add ("F15_V4L2_Unplugged", V4l2_Unplugged'Access);
   Add ("F15_V4L2_Broken_JPEG", V4l2_Broken_Jpeg'Access);
   Add ("F14_V4L2_Busy", V4l2_Busy'Access);
end Source_Tests;
