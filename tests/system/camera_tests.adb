--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14 to F19: the camera, the arena and the positions.

with Ada.Directories;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Dialogues;             use Dialogues;
with Emulators;
with Expectations;          use Expectations;
with Images;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Plain_Numbers;         use Plain_Numbers;
with Process_Facts;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;

procedure Camera_Tests is

   type Position is record
      Id             : Integer := 0;
      Angle          : Float := 0.0;
      Cx, Cy, Dx, Dy : Float := 0.0;
   end record;

   function Parsed (Item : Message) return Position is
      --  Of a CPOS message; raises Failed where it is malformed
      Text   : constant String := To_String (Item.Data);
      Parts  : constant Arguments := Words (Text, ';');
      Fields : array (1 .. 5) of Float;
   begin
      Check (Natural (Parts.Length) = 6 and then Count (Text, ";") = 5,
             "not six fields in " & Text);
      for Number in Fields'Range loop
         declare
            Field : constant String := Parts (Number + 1);
         begin
            Check (Index (Field, ".") = Field'Last - 6,
                   "not six decimals in " & Text);
            Fields (Number) := Float'Value (Field);
         end;
      end loop;
      return (Integer'Value (Parts (1)), Fields (1), Fields (2), Fields (3),
              Fields (4), Fields (5));
   exception
      when Constraint_Error =>
         raise Failed with "malformed CPOS:" & Text;
   end Parsed;

   function Next_Position (R : in out Rig) return Position is
     (Parsed (R.Monitor.Next_Of ("CPOS")));

   function Expect_Seen (R : in out Rig; Id : Natural; Truth : Emulators.Truth)
     return Position
   is
      --  The robot as exactly as F18 has it, twice in succession. The first
      --  positions may be of images under way
      Soon  : constant := 20;
      Right : Natural := 0;
      Seen  : Position;
      Turn  : Float;
   begin
      for Number in 1 .. Soon loop
         Seen := Next_Position (R);
         Turn := abs (Seen.Angle - Truth.Angle);
         Right :=
           (if Seen.Id = Id
              and then abs (Seen.Cx - Truth.Cx) <= 2.0
              and then abs (Seen.Cy - Truth.Cy) <= 2.0
              and then abs (Seen.Dx - Truth.Dx) <= 2.0
              and then abs (Seen.Dy - Truth.Dy) <= 2.0
              and then Float'Min (Turn, 360.0 - Turn) <= 1.0
              and then Seen.Angle > -180.0 and then Seen.Angle <= 180.0
            then Right + 1 else 0);
         exit when Right = 2;
      end loop;
      Check (Right = 2,
             "seen" & Seen.Id'Image & Seen.Angle'Image & Seen.Cx'Image
             & Seen.Cy'Image & ", true are" & Truth.Angle'Image
             & Truth.Cx'Image & Truth.Cy'Image);
      return Seen;
   end Expect_Seen;

   procedure Expect_Seen
     (R : in out Rig; Id : Natural; Truth : Emulators.Truth)
   is
      Unused : constant Position := Expect_Seen (R, Id, Truth);
   begin
      null;
   end Expect_Seen;

   function Facts_After (R : in out Rig; Count : Positive) return Images.Facts
   is
      --  Of the last of Count images: the first may have been under way
   begin
      R.Monitor.Skip_To_Now;
      R.Monitor.Await ("CIMG", Count);
      return Images.Seen (R.Monitor.Last_Image);
   end Facts_After;

   procedure Expect_Size (R : in out Rig; Width, Height : Positive) is
      --  Soon
      Facts : Images.Facts;
   begin
      for Number in 1 .. 20 loop
         Facts := Facts_After (R, 1);
         exit when Facts.Width = Width and then Facts.Height = Height;
      end loop;
      Check (Facts.Width = Width and then Facts.Height = Height,
             "image of" & Facts.Width'Image & " x" & Facts.Height'Image);
   end Expect_Size;

   procedure Expect_Drawn (R : in out Rig; Drawn : Boolean; What : String) is
   begin
      Check ((Facts_After (R, Count => 5).Coloured >= Images.Drawn) = Drawn,
             What & (if Drawn then " is not drawn" else " is drawn"));
   end Expect_Drawn;

   procedure Find_Arena (R : in out Rig) is
   begin
      Search_Arena (R);
      Check (Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn,
             "the arena is not drawn in the image of the search");
   end Find_Arena;

   procedure Check_Period
     (R         : in out Rig;
      Label     : String;
      Count     : Positive;
      Period    : Duration;
      Tolerance : Duration;
      Longest   : Duration)
   is
      --  In most of five runs of Count periods: their mean is Period within
      --  Tolerance, none is longer than Longest
      Means   : Samples.Set;
      Periods : Samples.Set;
      First   : Instant;
      Last    : Instant;
      Time    : Instant;
   begin
      R.Monitor.Skip_To_Now;
      Last := R.Monitor.Next_Of (Label).Time;
      for Run in 1 .. 5 loop
         First := Last;
         for Number in 1 .. Count loop
            Time := R.Monitor.Next_Of (Label).Time;
            Periods.Add (Time - Last);
            Last := Time;
         end loop;
         Means.Add ((Last - First) / Count);
         Note (Label & ": mean period " & Milliseconds (Means.Last));
      end loop;
      Note ("longest " & Milliseconds (Periods.Quantile (1.0)));
      Check_Within (abs (Means.Quantile (0.5) - Period), Tolerance,
                    "the period of " & Label & " off");
      Check_Within
        (Periods.Usual_Worst (Count), Longest, "the longest of " & Label);
   end Check_Period;

   procedure Open_And_Close is
      R           : Rig;
      Descriptors : Natural;
      Threads     : Natural;
   begin
      Assemble (R, Camera => True);
      for Attempt in 1 .. 12 loop
         Play (R, "COPN AACK, COPN AACK, comes CIMG, CCLS AACK, CCLS AACK");
         if Attempt = 2 then
            Descriptors := Process_Facts.Descriptors (R.Supervisor.Pid);
            Threads := Process_Facts.Threads (R.Supervisor.Pid);
         end if;
      end loop;
      R.Emulator.Await_Status ("viewers", "0");
      Check (Process_Facts.Descriptors (R.Supervisor.Pid) <= Descriptors,
             "descriptors leak with the camera");
      Check (Process_Facts.Threads (R.Supervisor.Pid) <= Threads,
             "threads leak with the camera");
   end Open_And_Close;

   procedure Open_Fails is

      procedure Refuse (Source : String) is
         R : Rig;
      begin
         R.Supervisor.Start ("--camera " & Source);
         Connect (R);
         Play (R, "COPN ANAK, CPCO ANAK, COPN ANAK, silence 0.2 CIMG");
      end Refuse;

      E : Emulators.Emulator;
   begin
      Refuse ("/no/such/camera.avi");
      Refuse ("/dev/null");
      Refuse (Programs.Copied_Supervisor);
      Refuse ("http://127.0.0.1:1/stream.mjpg");
      E.Start (Camera => True);
      --  answers, but with text
      Refuse
        (E.Camera_Url (1 .. Index (E.Camera_Url, "/", Backward)) & "pose");
   end Open_Fails;

   procedure Loaded_When_Opened is
      --  OpenCV, while the robot drives; before, the supervisor is small
      Small : constant := 20_000;
      --  Kilobytes
      R     : Rig;
      Size  : Natural;
   begin
      Assemble (R, Camera => True);
      Play (R, "ROPN AACK, RSWW AACK, RGFW AACK, CPCO ANAK, CCLS AACK");
      Size := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
      Note ("without the camera" & Size'Image & " kB");
      Check (Size < Small, "large without the camera:" & Size'Image & " kB");
      Check
        (not Process_Facts.Has_Mapped
               (R.Supervisor.Pid, Programs.Vision_Library),
         "loaded before the camera is opened");
      Open_Camera (R);
      Check
        (Process_Facts.Has_Mapped
           (R.Supervisor.Pid, Programs.Vision_Library), "not loaded");
      Play (R, "status moving 1, status disabled_count 0");
   end Loaded_When_Opened;

   procedure Library_Missing is
      --  The robot works nevertheless, and it is looked for each time
      use Ada.Directories;
      Folder  : constant String := Programs.Temporary_Folder & "/bare";
      Copy    : constant String := Folder & "/destijl";
      Library : constant String :=
        Folder & "/" & Simple_Name (Programs.Vision_Library);
      R       : Rig;
   begin
      Create_Path (Folder);
      if Exists (Library) then
         --  of an attempt before
         Delete_File (Library);
      end if;
      Copy_File (Programs.Supervisor, Copy);
      Check (Libc.Chmod (To_C (Copy), 8#755#) = 0, "the copy cannot be run");
      Assemble (R, Camera => True, Program => Copy);
      Play (R, "COPN ANAK, log libdestijl_vision.so: cannot open,"
            & " ROPN AACK, RSOW AACK, RGFW AACK, status moving 1, CCLS AACK,"
            & " COPN ANAK");
      Copy_File (Programs.Vision_Library, Library);
      Open_Camera (R);
   end Library_Missing;

   procedure Open_Takes_Long is
      --  A camera that accepts the connection and sends nothing delays neither
      --  the robot, nor the end of the session, nor that of the supervisor.
      R    : Rig;
      Item : Message;
      Time : Instant;

      procedure Begin_Opening is
         Mark : constant Natural := R.Supervisor.Log_Length;
      begin
         Time := Now;
         R.Monitor.Send_Line ("COPN");
         R.Supervisor.Expect_Log ("received COPN", After => Mark);
      end Begin_Opening;

   begin
      Assemble (R, Camera => True, Supervisor_Options => "--log-level debug");
      Move_Forward (R);
      R.Emulator.Tell ("camera stall");
      R.Monitor.Skip_To_Now;
      Begin_Opening;
      R.Monitor.Send_Line ("RSTP");
      Item := R.Monitor.Next_Answer;
      Check_Within (Item.Time - Time, 10.0, "to refuse the camera");
      Check (Item.Label = "ANAK", "COPN was answered " & Item.Label);
      Check_Label (R.Monitor.Next_Answer, "AACK", "the stop");
      Check (R.Emulator.Await_On_Wire ("M=0").First < Item.Time,
             "the stop waits for the camera");

      --  The monitor disconnects while the camera is being opened
      Begin_Opening;
      Time := Now;
      R.Monitor.Close;
      R.Supervisor.Expect_Log ("session closed");
      Check_Within (R.Supervisor.Time_Of ("session closed") - Time, 2.0,
                    "closing the session");
      R.Emulator.Tell ("camera on");
      Connect (R);
      Open_Camera (R);
      R.Monitor.Expect ("CCLS", "AACK");

      --  The supervisor is stopped while the camera is being opened
      R.Emulator.Tell ("camera stall");
      Begin_Opening;
      Time := Now;
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "exit status");
      Check_Within (Now - Time, 3.0, "the end");
   end Open_Takes_Long;

   procedure Add_Period
     (Name, Label       : String;
      Count             : Positive;
      Period, Tolerance : Duration;
      Longest           : Duration;
      Options           : String := "")
   is

      procedure Run is
         R : Rig;
      begin
         Assemble (R, Camera => True, Supervisor_Options => Options);
         Open_Camera (R, Positions => Label = "CPOS");
         Check_Period (R, Label, Count, Period, Tolerance, Longest);
         Check (R.Monitor.Broken_Images = 0, "a broken image");
      end Run;

   begin
      Add (Name, Run'Access, Timed => True);
   end Add_Period;

   procedure Still_Image_Period is
      E    : Emulators.Emulator;
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/arena.jpg";
   begin
      E.Start (Camera => True);
      E.Save_Snapshot (Path);
      R.Supervisor.Start ("--camera " & Path);
      Connect (R);
      Open_Camera (R, Positions => True);
      Check_Period (R, "CIMG", 4, 0.1, 0.01, 0.3);
   end Still_Image_Period;

   procedure Other_Rate_And_Size is
      R : Rig;
   begin
      Assemble (R, Camera => True,
                Supervisor_Options =>
                  "--fps 4 --frame-size 320x240 --jpeg-quality 40");
      Open_Camera (R);
      Expect_Size (R, 320, 240);
      Check (R.Monitor.Last_Image'Length < 40_000, "a large image");
   end Other_Rate_And_Size;

   procedure Own_Jpeg is
      --  The camera's JPEG is passed on unchanged, unless something is drawn
      Path : constant String := Programs.Temporary_Folder & "/own.jpg";
      R    : Rig;

      procedure Expect_Own (Own : Boolean; What : String) is
      begin
         Expect_Drawn (R, not Own, What);
         Check (Images.Is_File (R.Monitor.Last_Image, Path) = Own,
                What & (if Own then ": not" else ": still")
                & " the camera's own image");
      end Expect_Own;

   begin
      --  Without noise all images are equal
      Assemble (R, Camera => True,
                Emulator_Options => "--noise 0 --pose 30,40,60",
                Supervisor_Options => "--jpeg-quality 20");
      Open_Camera (R);
      R.Emulator.Save_Snapshot (Path);
      Expect_Own (True, "from the beginning");
      R.Monitor.Expect ("CPCO", "AACK");
      Expect_Own (False, "with positions");
      R.Monitor.Expect ("CPST", "AACK");
      Expect_Own (True, "without positions again");
      Find_Arena (R);
      R.Monitor.Send_Line ("CACO");
      Expect_Own (False, "with the arena");
   end Own_Jpeg;

   procedure Changing_Size is
      --  In mid-stream, there and back
      R : Rig;

      procedure Change (Size : String; Width, Height : Positive) is
      begin
         R.Emulator.Tell ("camera size " & Size);
         Expect_Size (R, Width, Height);
      end Change;

   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      Expect_Size (R, 640, 480);
      Change ("320x180", 640, 360);
      Change ("1x1", 480, 480);
      Change ("1920x1080", 640, 360);
      Change ("640x480", 640, 480);
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Changing_Size;

   procedure Damaged_Images is
      --  For less than the camera's time-out; damaged images may be sent if
      --  they can be decoded, others may not
      R : Rig;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      for Attempt in 1 .. 4 loop
         Play (R, "tell camera garbage, wait 0.3, tell camera mend");
         Expect_Size (R, 640, 480);
      end loop;
      Check (R.Monitor.Broken_Images = 0, "a broken image");
      R.Monitor.Expect ("CCLS", "AACK");
   end Damaged_Images;

   procedure Still_Image is
      --  A file as camera
      E    : Emulators.Emulator;
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/arena.jpg";
   begin
      E.Start (Camera => True, Options => "--pose 30,40,60 --marker-id 7");
      E.Save_Snapshot (Path);
      R.Supervisor.Start ("--camera " & Path);
      Connect (R);
      Open_Camera (R, Positions => True);
      Expect_Seen (R, 7, E.Pose);
      R.Monitor.Expect ("CCLS", "AACK");
      Open_Camera (R);
   end Still_Image;

   procedure No_Image_After_Close is
      R : Rig;
   begin
      Assemble (R, Camera => True);
      for Attempt in 1 .. 6 loop
         Open_Camera (R, Positions => Attempt mod 2 = 0);
         delay 0.13 * Attempt / 3;
         R.Monitor.Expect ("CCLS", "AACK");
         R.Monitor.Expect_Silence ("CIMG CPOS", For_Time => 0.4);
      end loop;
   end No_Image_After_Close;

   type Coordinates is array (1 .. 8) of Float;

   procedure Check_Ground (Answer, Size : String; Expected : Coordinates) is
      First : Natural := Answer'First + Size'Length;
      Last  : Natural;
   begin
      Check (Head (Answer, Size'Length) = Size, Answer);
      for Value of Expected loop
         Last := Index (Answer & ';', ";", First + 1) - 1;
         Check (abs (Float'Value (Answer (First + 1 .. Last)) - Value) < 2.0,
                Answer & " instead of" & Value'Image);
         First := Last + 1;
      end loop;
      Check (First > Answer'Last, Answer);
   end Check_Ground;

   procedure Arena_Decided is
      --  Rejected, then confirmed, searched again, and discarded with the
      --  camera; positions stay true inside it
      R : Rig;
   begin
      Assemble (R, Camera => True, Emulator_Options => "--pose 20,15,30");
      Open_Camera (R);
      Find_Arena (R);
      R.Monitor.Expect ("CARN", "ANAK");
      R.Monitor.Send_Line ("CAIN");
      R.Monitor.Expect ("CARN", "ANAK");
      Expect_Drawn (R, False, "the rejected arena");
      for Attempt in 1 .. 2 loop
         Find_Arena (R);
         --  again while one waits for the decision
         Find_Arena (R);
         R.Monitor.Send_Line ("CACO");
         --  the emulated camera shows a centimetre with 6.33 pixels
         R.Monitor.Send_Line ("CARN");
         Check_Ground
           (To_String (R.Monitor.Next_Answer ("CARN").Data), "80;60;8",
            (66.8, 50.1, 573.2, 50.1, 573.2, 429.9, 66.8, 429.9));
         Expect_Drawn (R, True, "the confirmed arena");
      end loop;
      R.Monitor.Expect ("CPCO", "AACK");
      Expect_Seen (R, 1, R.Emulator.Pose);
      Play (R, "CCLS AACK, CARN ANAK, " & With_Images);
      Expect_Drawn (R, False, "the discarded arena");
   end Arena_Decided;

   procedure Drawn_As_Asked is

      procedure Expect (Choice : String; Arena : Boolean) is
         R        : Rig;
         Coloured : Natural;
      begin
         Assemble
           (R, Camera => True, Supervisor_Options => "--draw " & Choice);
         Open_Camera (R, Positions => True);
         Coloured := Facts_After (R, 2).Coloured;
         Check (Coloured < Images.Drawn / 4, "the robot is drawn");
         Find_Arena (R);
         R.Monitor.Send_Line ("CACO");
         Coloured := Facts_After (R, 2).Coloured;
         Check ((if Arena then Coloured >= Images.Drawn
                 else Coloured < Images.Drawn / 4),
                Choice & ": confirmed, coloured are" & Coloured'Image);
         Check (Next_Position (R).Id = 1, "the robot is not seen");
      end Expect;

   begin
      Expect ("arena", Arena => True);
      Expect ("none", Arena => False);
   end Drawn_As_Asked;

   procedure Nothing_Found is
      --  Neither the arena nor a robot
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/empty.jpg";
   begin
      Images.Write_Empty (Path);
      R.Supervisor.Start ("--camera " & Path);
      Connect (R);
      --  no decision: the images continue
      Play (R, With_Images & ", CASA ANAK, comes CIMG, comes CIMG, CPCO AACK");
      for Number in 1 .. 5 loop
         declare
            Seen : constant Position := Next_Position (R);
         begin
            Check
              (Seen.Id = -1 and then Seen.Cx = -1.0 and then Seen.Cy = -1.0,
               "no robot is seen at" & Seen.Cx'Image & Seen.Cy'Image);
         end;
      end loop;
      R.Monitor.Await ("CIMG");
   end Nothing_Found;

   procedure Decision_Alone is
      --  Without a search
      R : Rig;
   begin
      Assemble (R, Camera => True);
      Play
        (R, "send CACO, send CAIN, " & With_Images & ", send CACO, send CAIN");
      Expect_Drawn (R, False, "an arena that was never found");
      R.Monitor.Expect ("what", "ACER");
   end Decision_Alone;

   procedure Positions_True is
      R    : Rig;
      Seen : Position;

      procedure Try (X, Y, Heading : Integer) is
      begin
         R.Emulator.Tell
           ("pose " & Image (X) & " " & Image (Y) & " " & Image (Heading));
         Seen := Expect_Seen (R, 42, R.Emulator.Pose);
      end Try;

   begin
      Assemble (R, Camera => True,
                Emulator_Options => "--marker-id 42 --noise 3");
      Open_Camera (R, Positions => True);
      for Step in 0 .. 11 loop
         Try (X => 15 + (Step * 37) mod 50, Y => 12 + (Step * 23) mod 36,
              Heading => Step * 30);
      end loop;
      Try (40, 30, 45);
      Try (40, 30, 180);
      Try (40, 30, 90);
      Check (abs (Seen.Angle - 90.0) <= 1.0,
             "an upright marker is at" & Seen.Angle'Image);
   end Positions_True;

   procedure Positions_Every_Image is
      Count  : constant := 40;
      R      : Rig;
      Before : Natural;
      After  : Natural;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R, Positions => True);
      R.Monitor.Skip_To_Now;
      Before := R.Monitor.Count_Of ("CIMG");
      R.Monitor.Await ("CPOS", Count);
      After := R.Monitor.Count_Of ("CIMG");
      Check (abs (After - Before - Count) <= 4,
             Count'Image & " positions," & Natural'Image (After - Before)
             & " images");
      Check (Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn / 4,
             "the robot is not drawn");
   end Positions_Every_Image;

   procedure Position_Of_Late_Image is
      --  The camera is a second late
      R         : Rig;
      Here      : Emulators.Truth;
      There     : Emulators.Truth;
      Moved     : Instant;
      Item      : Message;
      Displaced : Float := 0.0;

      function Is_At (Place : Emulators.Truth) return Boolean is
        (abs (Parsed (Item).Cx - Place.Cx) <= 12.0
         and then abs (Parsed (Item).Cy - Place.Cy) <= 12.0);

   begin
      Assemble (R, Camera => True,
                Emulator_Options =>
                  "--pose 20,20,0 --camera-delay 1000 --position-noise 2");
      Open_Camera (R, Positions => True);
      Here := R.Emulator.Pose;
      for Number in 1 .. 20 loop
         Item := R.Monitor.Next_Of ("CPOS");
         Check (Is_At (Here), "it is not seen where it stands");
         Displaced := Float'Max (Displaced, abs (Parsed (Item).Cx - Here.Cx));
      end loop;
      Check (Displaced > 0.5, "positions without noise");
      Moved := Now;
      R.Emulator.Tell ("pose 60 40 0");
      There := R.Emulator.Pose;
      loop
         Item := R.Monitor.Next_Of ("CPOS");
         exit when Is_At (There);
         Check (Is_At (Here), "it is seen elsewhere");
      end loop;
      Check (Item.Time - Moved >= 1.0, "images are not late");
      Check_Within (Item.Time - Moved, 2.0, "an image");
   end Position_Of_Late_Image;

   procedure Position_Of_Triangle is
      R : Rig;
   begin
      Assemble (R, Camera => True,
                Emulator_Options => "--marker triangle --pose 50,20,120",
                Supervisor_Options => "--marker triangle");
      Open_Camera (R, Positions => True);
      Expect_Seen (R, 0, R.Emulator.Pose);
   end Position_Of_Triangle;

   procedure Position_Stopped is
      R    : Rig;
      Mark : Natural;
   begin
      Assemble (R, Camera => True);
      R.Monitor.Expect ("CPST", "AACK");
      for Attempt in 1 .. 3 loop
         Open_Camera (R, Positions => True);
         R.Monitor.Expect ("CPCO", "AACK");
         R.Monitor.Expect ("CPST", "AACK");
         R.Monitor.Expect ("CPST", "AACK");
         --  one may have been under way
         R.Monitor.Await ("CIMG", 3);
         Mark := R.Monitor.Count_Of ("CPOS");
         R.Monitor.Await ("CIMG", 5);
         Check (R.Monitor.Count_Of ("CPOS") = Mark, "positions go on");
         Check (Images.Seen (R.Monitor.Last_Image).Coloured < Images.Drawn,
                "the robot is still drawn");
      end loop;
   end Position_Stopped;

   procedure Loop_Closes is
      --  Order, motion, image, position
      R      : Rig;
      Before : Position;
      After  : Position;
   begin
      Assemble (R, Camera => True, Emulator_Options => "--pose 20,30,0");
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Before := Next_Position (R);
      Play (R, "RMOV:200 AACK, status moving 0");
      for Number in 1 .. 20 loop
         After := Next_Position (R);
         exit when After.Cx - Before.Cx > 60.0;
      end loop;
      Note ("20 cm are" & Float'Image (After.Cx - Before.Cx) & " px");
      Check (After.Cx - Before.Cx > 60.0, "the robot has not moved");
      Check (abs (After.Cy - Before.Cy) < 3.0, "not straight on");
   end Loop_Closes;

begin
   Add ("F14_F16_Open_And_Close", Open_And_Close'Access);
   Add ("F14_Open_Fails", Open_Fails'Access);
   Add ("F14_Library_Loaded_When_Opened", Loaded_When_Opened'Access);
   Add ("F14_Library_Missing", Library_Missing'Access);
   Add ("F14_Open_Takes_Long", Open_Takes_Long'Access, In_Time => True);
   Script ("F14_Not_Open_Is_ANAK",
           "CPCO ANAK, CASA ANAK, CPST AACK, CCLS AACK, " & With_Images
           & ", CCLS AACK, CASA ANAK", Camera => True);
   --  F15: 10.0 images a second within 1 %, jitter 20 ms at p99
   Add_Period ("F15_Image_Period", "CIMG", 12, 0.1, 0.003, 0.2);
   Add_Period ("F15_Other_Period", "CIMG", 4, 0.25, 0.02, 0.5, "--fps 4");
   Add ("F15_Still_Image_Period", Still_Image_Period'Access, Timed => True);
   Add ("F15_Other_Rate_Size_And_Quality", Other_Rate_And_Size'Access);
   Add ("F15_Own_JPEG_Of_The_Camera", Own_Jpeg'Access);
   Add ("F15_Image_Size_Changes", Changing_Size'Access);
   Add ("F15_Damaged_Images", Damaged_Images'Access);
   Add ("F14_Still_Image_As_Camera", Still_Image'Access);
   Add ("F16_No_Image_After_Close", No_Image_After_Close'Access);
   Script ("F15_Camera_Stops_Delivering",
           With_Images & ", tell camera stall, comes "
           & "MSSG:camera closed: it , log camera closed: it ,"
           & " silence 0.7 CIMG MSSG, CPCO ANAK, RPIN ANAK, tell camera on, "
           & With_Positions & ", CCLS AACK", Camera => True);
   Script ("F15_Camera_Silent_For_A_Time",
           With_Images & ", tell camera stall, comes "
           & "MSSG:camera closed: it has delivered nothing for 2.5 s",
           Camera => True,
           Timed => True);
   --  A URL is not given up before
   Script ("F15_Camera_Goes_Away",
           With_Positions & ", tell camera off, comes "
           & "MSSG:camera closed: it delivers no images any more,"
           & " silence 0.5 CIMG CPOS, COPN ANAK, tell camera on, "
           & With_Images, Camera => True);
   --  Its stream is closed; a new one refused at first
   Add ("F17_Arena_Confirmed_Or_Rejected", Arena_Decided'Access);
   Add ("F17_F18_Drawn_As_Asked", Drawn_As_Asked'Access);
   Script ("F17_Arena_Of_Stalled_Camera",
           With_Images & ", tell camera stall, wait 1.0, send CASA, send nope,"
           & " answer ANAK, answer ACER, log camera closed, tell camera on,"
           & " CCLS AACK, " & With_Images, Camera => True);
   --  The search waits for an image, until the camera counts as failed
   Add ("F17_F18_Neither_Arena_Nor_Robot", Nothing_Found'Access);
   Add ("F17_Decision_Without_Search", Decision_Alone'Access);
   Add ("F18_Positions_True", Positions_True'Access);
   Add ("F18_Positions_In_Every_Image", Positions_Every_Image'Access);
   Add_Period ("F18_Position_Period", "CPOS", 8, 0.1, 0.004, 0.3);
   Add ("F18_Position_Of_Triangle", Position_Of_Triangle'Access);
   Add ("F18_Position_Of_Late_Image",
        Position_Of_Late_Image'Access, In_Time => True);
   Add ("F19_Position_Stopped", Position_Stopped'Access);
   Add ("F12_F18_Loop_Closes", Loop_Closes'Access);
end Camera_Tests;
