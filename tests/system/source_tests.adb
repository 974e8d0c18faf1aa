--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14, F15: cameras of every rate, and V4L2 cameras of every kind.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;

with Child_Processes;       use Child_Processes;
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
with Supervisors;           use Supervisors;

procedure Source_Tests is

   function In_Folder (Name : String) return String is
     (Programs.Temporary_Folder & "/" & Name);

   function Picture_Path return String is (In_Folder ("arena.jpg"));
   function Raw_Path return String is (In_Folder ("arena.yuyv"));

   function Picture (Size : String := "640x480") return Emulators.Truth is
      --  The arena as a JPEG, in Picture_Path, and where the robot is in it
      E : Emulators.Emulator;
   begin
      E.Start (Camera  => True,
               Options => "--noise 0 --pose 30,40,60 --frame-size " & Size);
      E.Save_Snapshot (Picture_Path);
      return E.Pose;
   end Picture;

   --  Cameras of every rate, side by side: each with a supervisor and a
   --  monitor of its own

   type Watch is limited record
      Camera : Paced_Cameras.Camera;
      Rig    : Rigs.Rig;
   end record;

   procedure Judge
     (W        : Watch;
      From, To : Instant;
      Name     : String;
      Rate     : Float;
      Jitter   : Duration := 0.0)
   is
      --  What came between the two: Rate is that of the source
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
      for K in 1 .. W.Rig.Monitor.Count loop
         Item := W.Rig.Monitor.Element (K);
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
         & W.Rig.Monitor.Count'Image & " messages "
         & (if W.Rig.Monitor.Count = 0 then ""
            else Milliseconds
              (To - W.Rig.Monitor.Element (W.Rig.Monitor.Count).Time))
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
      Check_In_Time (Rate >= 10.0 or else Left_Out = 0,
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

      type Source is record
         Rate   : Float;
         Jitter : Duration := 0.0;
      end record;

      Steady : constant array (Positive range <>) of Source :=
        ((5.0, 0.0), (7.5, 0.0), (9.9, 0.0), (10.0, 0.0), (10.1, 0.0),
         (12.0, 0.0), (15.0, 0.0), (25.0, 0.0), (29.97, 0.0), (30.0, 0.0),
         (60.0, 0.0), (5.0, 0.03), (9.9, 0.03), (10.0, 0.03), (10.1, 0.03),
         (12.0, 0.03), (30.0, 0.03));

      Light : constant array (1 .. 4) of Float := (30.0, 12.0, 7.5, 30.0);
      --  Rates of one that changes with the light

      Watches  : array (Steady'Range) of Watch;
      Changing : Watch;
      Begun    : Instant;
      Changed  : Instant;
      Unused   : constant Emulators.Truth := Picture ("160x120");

      procedure Begin_Watch (W : in out Watch; From : Source) is
      begin
         W.Camera.Start (Picture_Path, From.Rate, From.Jitter);
         Start (W.Rig, "--frame-size 160x120 --camera " & W.Camera.Url);
         Play (W.Rig, "COPN AACK");
      end Begin_Watch;

   begin
      for K in Steady'Range loop
         Begin_Watch (Watches (K), Steady (K));
      end loop;
      Begin_Watch (Changing, (30.0, 0.0));
      delay 3.0;
      Begun := Now;
      for Rate of Light loop
         Changed := Now;
         Changing.Camera.Set_Rate (Rate);
         delay 4.0;
         Judge (Changing, Changed + 1.0, Now, "changed to " & Rounded (Rate),
                Rate);
      end loop;
      for K in Steady'Range loop
         Judge (Watches (K), Begun, Now,
                Rounded (Steady (K).Rate) & " +-"
                & Milliseconds (Steady (K).Jitter),
                Steady (K).Rate, Steady (K).Jitter);
      end loop;
   end Sources;

   --  V4L2 cameras: tests/preload/v4l2_camera.c stands for the kernel's

   function Settings return String is (In_Folder ("v4l2_camera"));

   function Launcher return String is
     (Programs.Preload ("libv4l2_camera.so") & " V4L2_CAMERA=" & Settings);
   --  Of a supervisor that finds that camera

   procedure Set_Camera
     (Image  : String  := Picture_Path;
      Format : String  := "MJPG";
      Size   : String  := "640 480";
      Rate   : String  := "30 1";
      Broken : Natural := 0;
      State  : String  := "on")
   is
      --  What there is to be opened from now on
      LF      : constant Character := ASCII.LF;
      Renamed : Boolean;
   begin
      GNAT.OS_Lib.Rename_File
        (Programs.New_File
           ("v4l2_camera.new",
            "format " & Format & LF & "size " & Size & LF & "rate " & Rate & LF
            & "image " & Image & LF & "broken" & Broken'Image & LF
            & "state " & State & LF),
         Settings, Renamed);
      Check (Renamed, "the camera's settings cannot be changed");
   end Set_Camera;

   procedure Start_V4l2 (R : in out Rig; Source : String := "0") is
   begin
      Start (R, "--camera " & Source, Launcher);
   end Start_V4l2;

   procedure Expect_Check (Granted : String) is
      --  --check names what the camera grants
      S : Supervisor;
   begin
      S.Run ("--check --port 0 --camera 0", Launcher);
      Check (S.Exit_Status in 0 | 1, "--check");
      Check (S.Says ("camera: delivers images, " & Granted, From => Output),
             "--check says " & S.Text (Output));
   end Expect_Check;

   procedure Expect_Picture (R : in out Rig; X, Y : Float) is
      --  Images of 640x480, grey, with the robot at X, Y
      Seen   : Images.Facts;
      Found  : Boolean;
      At_X   : Float;
      At_Y   : Float;
   begin
      Play (R, With_Images & ", comes CIMG, comes CIMG, comes CIMG");
      Seen := Images.Seen (R.Monitor.Image);
      Check (Seen.Width = 640 and then Seen.Height = 480,
             "image of" & Seen.Width'Image & " x" & Seen.Height'Image);
      Check (Seen.Coloured = 0, "a colour where there is none");
      Images.Find_Marker (R.Monitor.Image, Found, At_X, At_Y);
      Check
        (Found and then abs (At_X - X) <= 2.0 and then abs (At_Y - Y) <= 2.0,
         "the robot of the image is seen at" & At_X'Image & At_Y'Image
         & " instead of" & X'Image & Y'Image);
   end Expect_Picture;

   procedure Expect_Own_Jpeg (R : in out Rig; Count : Positive := 3) is
      --  It can be opened, and so many images have the very bytes of the file
      Item : Message;
   begin
      Play (R, With_Images);
      for Number in 1 .. Count loop
         Item := R.Monitor.Next_Of ("CIMG");
         Check (Images.Is_File (R.Monitor.Image (Item.Number), Picture_Path),
                "image" & Number'Image & " is not the camera's");
      end loop;
   end Expect_Own_Jpeg;

   procedure Expect_Rate (R : in out Rig; Granted : String; Rate : Float) is
      Count : constant := 15;
      First : Instant;
      Last  : Instant;
      Mean  : Float;
   begin
      Expect_Check (Granted & " a second");
      Play (R, With_Images);
      R.Monitor.Skip_To_Now;
      First := R.Monitor.Next_Of ("CIMG").Time;
      for Number in 1 .. Count loop
         Last := R.Monitor.Next_Of ("CIMG").Time;
      end loop;
      Mean := Float (Count) / Float (Duration'(Last - First));
      Check_In_Time
        (abs (Mean - Rate) <= 0.05 * Rate,
         Granted & ": " & Rounded (Mean) & " images a second");
      R.Monitor.Expect ("CCLS", "AACK");
   end Expect_Rate;

   procedure V4l2_Motion_Jpeg is
      Unused : constant Emulators.Truth := Picture;
      R      : Rig;
   begin
      Set_Camera;
      Expect_Check ("MJPG 640x480, 30 a second");
      Start_V4l2 (R);
      Expect_Own_Jpeg (R, Count => 5);
      Play (R, "CPCO AACK, comes CPOS, CCLS AACK, " & With_Images);
      Start_V4l2 (R, "/dev/video0");
      Expect_Own_Jpeg (R);
   end V4l2_Motion_Jpeg;

   procedure V4l2_Pixels_And_Sizes is
      Pose : Emulators.Truth := Picture;
      R    : Rig;
   begin
      Images.Write_Yuyv (Picture_Path, Raw_Path);
      Set_Camera (Raw_Path, Format => "YUYV");
      Expect_Check ("YUYV 640x480, 30 a second");
      Start_V4l2 (R);
      Expect_Picture (R, Pose.Cx, Pose.Cy);
      R.Monitor.Expect ("CCLS", "AACK");
      Pose := Picture ("800x600");
      Set_Camera (Size => "800 600");
      Expect_Check ("MJPG 800x600, 30 a second");
      Expect_Picture (R, 0.8 * Pose.Cx, 0.8 * Pose.Cy);
   end V4l2_Pixels_And_Sizes;

   procedure V4l2_Rates is
      Unused : constant Emulators.Truth := Picture;
      R      : Rig;
   begin
      Images.Write_Yuyv (Picture_Path, Raw_Path);
      Set_Camera;
      Start_V4l2 (R);
      Expect_Rate (R, "MJPG 640x480, 30", 10.0);
      Set_Camera (Rate => "15 1");
      Expect_Rate (R, "MJPG 640x480, 15", 10.0);
      Set_Camera (Rate => "15 2");
      Expect_Rate (R, "MJPG 640x480, 7.5", 7.5);
      Set_Camera (Broken => 3);
      Expect_Rate (R, "MJPG 640x480, 30", 10.0);
      Set_Camera (Raw_Path, Format => "YUYV");
      Expect_Rate (R, "YUYV 640x480, 30", 10.0);
   end V4l2_Rates;

   procedure V4l2_Unplugged is
      Unused : constant Emulators.Truth := Picture;
      Item   : Message;
      R      : Rig;
   begin
      Set_Camera;
      Start_V4l2 (R);
      Expect_Own_Jpeg (R);
      for Attempt in 1 .. 2 loop
         Set_Camera (State => "gone");
         Item := R.Monitor.Next_Of ("MSSG");
         Check (Index (Item.Data, "camera closed") > 0,
                "the monitor is told " & To_String (Item.Data));
         Play (R, "COPN ANAK, silence 0.3 CIMG");
         Set_Camera;
         Expect_Own_Jpeg (R);
      end loop;
      R.Monitor.Expect ("CCLS", "AACK");
   end V4l2_Unplugged;

   procedure V4l2_Broken_Or_Busy is
      Unused : constant Emulators.Truth := Picture;
      R      : Rig;
   begin
      --  Now and then: what is broken is left out
      Set_Camera (Broken => 3);
      Start_V4l2 (R);
      Expect_Own_Jpeg (R, Count => 10);
      R.Monitor.Expect ("CCLS", "AACK");

      --  Nothing else, and no other format is granted
      Set_Camera (Broken => 1);
      R.Monitor.Expect ("COPN", "ANAK");
      Set_Camera (State => "busy");
      Play (R, "COPN ANAK, log another program uses it");
      Set_Camera (State => "meta");
      R.Monitor.Expect ("COPN", "ANAK");
      R.Supervisor.Expect_Log ("it gives no images, perhaps metadata");
      R.Monitor.Expect ("COPN", "ANAK");
      Set_Camera;
      Expect_Own_Jpeg (R);
   end V4l2_Broken_Or_Busy;

begin
   Add ("F15_Cameras_Of_Every_Rate", Sources'Access, Timed => True);
   Add ("F14_V4L2_Motion_JPEG", V4l2_Motion_Jpeg'Access);
   Add ("F14_V4L2_Pixels_And_Sizes", V4l2_Pixels_And_Sizes'Access);
   Add ("F15_V4L2_Rates", V4l2_Rates'Access, Timed => True);
   Add ("F15_V4L2_Unplugged", V4l2_Unplugged'Access);
   Add ("F14_V4L2_Broken_Or_Busy", V4l2_Broken_Or_Busy'Access);
end Source_Tests;
