--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14 to F19: the camera, the arena and the positions.

with Ada.Directories;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Emulators;
with Expectations;          use Expectations;
with Images;
with Instants;              use Instants;
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

   procedure Expect_Seen
     (R : in out Rig; Id : Natural; Truth : Emulators.Truth)
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
   end Expect_Seen;

   function Facts_After (R : in out Rig; Count : Positive) return Images.Facts
   is
      --  Of the last of Count images: the first may have been under way
   begin
      R.Monitor.Skip_To_Now;
      R.Monitor.Await ("CIMG", Count);
      return Images.Seen (R.Monitor.Image);
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
      Play (R, Arena_Searched);
      Check (Images.Seen (R.Monitor.Image).Coloured >= Images.Drawn,
             "the arena is not drawn in the image of the search");
   end Find_Arena;

   procedure Start_Still (R : in out Rig) is
      --  A file as camera, and the emulator that has made it
      Path : constant String := Programs.Temporary_Folder & "/arena.jpg";
   begin
      R.Emulator.Start
        (Camera => True, Options => "--pose 30,40,60 --marker-id 7");
      R.Emulator.Save_Snapshot (Path);
      Start (R, "--camera " & Path);
   end Start_Still;

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

   procedure Open_And_Close (R : in out Rig) is
      Cycle  : constant String :=
        "COPN AACK, COPN AACK, comes CIMG, CCLS AACK, CCLS AACK";
      Before : Process_Facts.Footprint;
   begin
      Play (R, Cycle, Times => 2);
      Before := Process_Facts.Footprint_Of (R.Supervisor.Pid);
      Play (R, Cycle, Times => 10);
      Play (R, "status viewers 0");
      Process_Facts.Expect_Flat (R.Supervisor.Pid, Before,
                                 Kilobytes => 20_000);
      --  images come and go
   end Open_And_Close;

   procedure Open_Fails is

      procedure Refuse (Source : String) is
         R : Rig;
      begin
         Start (R, "--camera " & Source);
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
        (E.Camera_Url
           (1 .. Index (E.Camera_Url, "/", Ada.Strings.Backward)) & "pose");
   end Open_Fails;

   procedure Loaded_When_Opened (R : in out Rig) is
      --  OpenCV, while the robot drives; before, the supervisor is small
      Small : constant := 20_000;
      --  Kilobytes
      Size  : constant Natural :=
        Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);

      function Is_Loaded return Boolean is
        (Process_Facts.Has_Mapped
           (R.Supervisor.Pid, Programs.Vision_Library));
   begin
      Note ("without the camera" & Size'Image & " kB");
      Check (Size < Small, "large without the camera:" & Size'Image & " kB");
      Check (not Is_Loaded, "loaded before the camera is opened");
      Play (R, With_Images & ", status moving 1, status disabled_count 0");
      Check (Is_Loaded, "not loaded");
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
      Copy_File (Programs.Supervisor, Copy, Form => "preserve=all_attributes");
      Assemble (R, Camera => True, Program => Copy);
      Play (R, "COPN ANAK, log libdestijl_vision.so: cannot open,"
            & " ROPN AACK, RSOW AACK, RGFW AACK, status moving 1, CCLS AACK,"
            & " COPN ANAK");
      Copy_File (Programs.Vision_Library, Library);
      Play (R, With_Images);
   end Library_Missing;

   procedure Open_Takes_Long (R : in out Rig) is
      --  A camera that accepts the connection and sends nothing delays neither
      --  the robot, nor the end of the session, nor that of the supervisor.
      Opening : constant String := "send COPN, log received COPN";
      Item    : Message;
      Time    : constant Instant := Now;
   begin
      R.Monitor.Skip_To_Now;
      Play (R, Opening & ", send RSTP");
      Item := R.Monitor.Next_Answer;
      Check_Within (Item.Time - Time, 10.0, "to refuse the camera");
      Check_Label (Item, "ANAK", "COPN");
      Play (R, "answer AACK");
      Check (R.Emulator.Await_On_Wire ("M=0").First < Item.Time,
             "the stop waits for the camera");

      --  The monitor disconnects while the camera is being opened; then the
      --  supervisor is stopped
      Play (R, Opening & ", close, over, tell camera on, connect, "
            & With_Images & ", CCLS AACK, tell camera stall");
      Play (R, Opening & ", signal 15, ends 0");
   end Open_Takes_Long;

   procedure Add_Period
     (Name, Label       : String;
      Count             : Positive;
      Period, Tolerance : Duration;
      Longest           : Duration;
      Options           : String := "")
   is

      procedure Run (R : in out Rig) is
      begin
         Check_Period (R, Label, Count, Period, Tolerance, Longest);
         Check (R.Monitor.Broken_Images = 0, "a broken image");
      end Run;

   begin
      Script (Name, (if Label = "CPOS" then With_Positions else With_Images),
              Run'Access, Camera => True, Supervisor_Options => Options,
              Timed => True);
   end Add_Period;

   procedure Still_Image_Period is
      R : Rig;
   begin
      Start_Still (R);
      Play (R, With_Positions);
      Check_Period (R, "CIMG", 4, 0.1, 0.01, 0.3);
   end Still_Image_Period;

   procedure Other_Rate_And_Size (R : in out Rig) is
   begin
      Expect_Size (R, 320, 240);
      Check (R.Monitor.Image'Length < 40_000, "a large image");
   end Other_Rate_And_Size;

   procedure Own_Jpeg (R : in out Rig) is
      --  The camera's JPEG is passed on unchanged, unless something is drawn
      Path : constant String := Programs.Temporary_Folder & "/own.jpg";

      procedure Expect_Own (Own : Boolean; What : String) is
      begin
         Expect_Drawn (R, not Own, What);
         Check (Images.Is_File (R.Monitor.Image, Path) = Own,
                What & (if Own then ": not" else ": still")
                & " the camera's own image");
      end Expect_Own;

   begin
      --  Without noise all images are equal
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

   procedure Changing_Size (R : in out Rig) is
      --  In mid-stream, there and back

      procedure Change (Size : String; Width, Height : Positive) is
      begin
         R.Emulator.Tell ("camera size " & Size);
         Expect_Size (R, Width, Height);
      end Change;

   begin
      Expect_Size (R, 640, 480);
      Change ("320x180", 640, 360);
      Change ("1x1", 480, 480);
      Change ("1920x1080", 640, 360);
      Change ("640x480", 640, 480);

      --  Damaged for less than the camera's time-out: such images may be sent
      --  if they can be decoded, others may not
      for Attempt in 1 .. 4 loop
         Play (R, "tell camera garbage, wait 0.3, tell camera mend");
         Expect_Size (R, 640, 480);
      end loop;
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Changing_Size;

   procedure Still_Image is
      R : Rig;
   begin
      Start_Still (R);
      Play (R, With_Positions);
      Expect_Seen (R, 7, R.Emulator.Pose);
      Play (R, "CCLS AACK, " & With_Images);
   end Still_Image;

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

   procedure Arena_Decided (R : in out Rig) is
      --  Rejected, then confirmed, searched again, and discarded with the
      --  camera; positions stay true inside it
   begin
      Find_Arena (R);
      Play (R, "CARN ANAK, send CAIN, CARN ANAK");
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

   procedure Add_Drawn (Choice : String; Arena : Boolean) is

      procedure Run (R : in out Rig) is
         Coloured : Natural := Facts_After (R, 2).Coloured;
      begin
         Check (Coloured < Images.Drawn / 4, "the robot is drawn");
         Find_Arena (R);
         R.Monitor.Send_Line ("CACO");
         Coloured := Facts_After (R, 2).Coloured;
         Check ((if Arena then Coloured >= Images.Drawn
                 else Coloured < Images.Drawn / 4),
                "confirmed, coloured are" & Coloured'Image);
         Check (Next_Position (R).Id = 1, "the robot is not seen");
      end Run;

   begin
      Script ("F17_F18_Drawn_As_Asked_" & Choice, With_Positions, Run'Access,
              Camera => True, Supervisor_Options => "--draw " & Choice);
   end Add_Drawn;

   procedure Nothing_Found is
      --  Neither the arena nor a robot
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/empty.jpg";
   begin
      Images.Write_Empty (Path);
      Start (R, "--camera " & Path);
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

   procedure Decision_Alone (R : in out Rig) is
      --  Without a search
   begin
      Expect_Drawn (R, False, "an arena that was never found");
      R.Monitor.Expect ("what", "ACER");
   end Decision_Alone;

   procedure Positions_True (R : in out Rig) is

      procedure Try (X, Y, Heading : Integer) is
      begin
         R.Emulator.Tell
           ("pose " & Image (X) & " " & Image (Y) & " " & Image (Heading));
         Expect_Seen (R, 42, R.Emulator.Pose);
      end Try;

      Upright : Float;
   begin
      for Step in 0 .. 11 loop
         Try (X => 15 + (Step * 37) mod 50, Y => 12 + (Step * 23) mod 36,
              Heading => Step * 30);
      end loop;
      Try (40, 30, 45);
      Try (40, 30, 180);
      Try (40, 30, 90);
      Upright := Next_Position (R).Angle;
      Check (abs (Upright - 90.0) <= 1.0,
             "an upright marker is at" & Upright'Image);
   end Positions_True;

   procedure Positions_Every_Image (R : in out Rig) is
      Count  : constant := 40;
      Before : Natural;
      Shown  : Natural;
   begin
      R.Monitor.Skip_To_Now;
      Before := R.Monitor.Count_Of ("CIMG");
      R.Monitor.Await ("CPOS", Count);
      Shown := R.Monitor.Count_Of ("CIMG") - Before;
      Check (abs (Shown - Count) <= 4,
             Count'Image & " positions," & Shown'Image & " images");
      Check (Images.Seen (R.Monitor.Image).Coloured >= Images.Drawn / 4,
             "the robot is not drawn");
   end Positions_Every_Image;

   procedure Position_Of_Late_Image (R : in out Rig) is
      --  The camera is a second late
      Here      : constant Emulators.Truth := R.Emulator.Pose;
      There     : Emulators.Truth;
      Moved     : Instant;
      Item      : Message;
      Displaced : Float := 0.0;

      function Is_At (Place : Emulators.Truth) return Boolean is
        (abs (Parsed (Item).Cx - Place.Cx) <= 12.0
         and then abs (Parsed (Item).Cy - Place.Cy) <= 12.0);

   begin
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

   procedure Position_Of_Triangle (R : in out Rig) is
   begin
      Expect_Seen (R, 0, R.Emulator.Pose);
   end Position_Of_Triangle;

   procedure Position_Stopped (R : in out Rig) is
      Mark : Natural;
   begin
      for Attempt in 1 .. 3 loop
         Play (R, With_Positions & ", CPCO AACK, CPST AACK, CPST AACK");
         --  one may have been under way
         R.Monitor.Await ("CIMG", 3);
         Mark := R.Monitor.Count_Of ("CPOS");
         R.Monitor.Await ("CIMG", 5);
         Check (R.Monitor.Count_Of ("CPOS") = Mark, "positions go on");
         Check (Images.Seen (R.Monitor.Image).Coloured < Images.Drawn,
                "the robot is still drawn");
      end loop;
   end Position_Stopped;

   procedure Loop_Closes (R : in out Rig) is
      --  Order, motion, image, position
      Before : constant Position := Next_Position (R);
      After  : Position;
   begin
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
   Script ("F14_F16_Open_And_Close", "", Open_And_Close'Access,
           Camera => True);
   Add ("F14_Open_Fails", Open_Fails'Access);
   Script ("F14_Library_Loaded_When_Opened",
           Guarded & ", RGFW AACK, CPCO ANAK, CCLS AACK",
           Loaded_When_Opened'Access, Camera => True);
   Add ("F14_Library_Missing", Library_Missing'Access);
   Script ("F14_Open_Takes_Long", Forward & ", tell camera stall",
           Open_Takes_Long'Access, Camera => True,
           Supervisor_Options => "--log-level debug", In_Time => True);
   Script ("F14_Not_Open_Is_ANAK",
           "CPCO ANAK, CASA ANAK, CPST AACK, CCLS AACK, " & With_Images
           & ", CCLS AACK, CASA ANAK", Camera => True);
   --  F15: 10.0 images a second within 1 %, jitter 20 ms at p99
   Add_Period ("F15_Image_Period", "CIMG", 12, 0.1, 0.003, 0.2);
   Add_Period ("F15_Other_Period", "CIMG", 4, 0.25, 0.02, 0.5, "--fps 4");
   Add ("F15_Still_Image_Period", Still_Image_Period'Access, Timed => True);
   Script ("F15_Other_Rate_Size_And_Quality", With_Images,
           Other_Rate_And_Size'Access, Camera => True,
           Supervisor_Options =>
             "--fps 4 --frame-size 320x240 --jpeg-quality 40");
   Script ("F15_Own_JPEG_Of_The_Camera", With_Images, Own_Jpeg'Access,
           Camera => True, Emulator_Options => "--noise 0 --pose 30,40,60",
           Supervisor_Options => "--jpeg-quality 20");
   Script ("F15_Image_Size_Changes_And_Damage", With_Images,
           Changing_Size'Access, Camera => True);
   Add ("F14_Still_Image_As_Camera", Still_Image'Access);
   Script ("F16_No_Image_After_Close",
           With_Images & ", wait $, CCLS AACK, silence 0.4 CIMG CPOS, "
           & With_Positions & ", wait $, CCLS AACK, silence 0.4 CIMG CPOS",
           Each => "0.05 0.15 0.25", Camera => True);
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
   Script ("F17_Arena_Confirmed_Or_Rejected", With_Images,
           Arena_Decided'Access, Camera => True,
           Emulator_Options => "--pose 20,15,30");
   Add_Drawn ("arena", Arena => True);
   Add_Drawn ("none", Arena => False);
   Script ("F17_Arena_Of_Stalled_Camera",
           With_Images & ", tell camera stall, wait 1.0, send CASA, send nope,"
           & " answer ANAK, answer ACER, log camera closed, tell camera on,"
           & " CCLS AACK, " & With_Images, Camera => True);
   --  The search waits for an image, until the camera counts as failed
   Add ("F17_F18_Neither_Arena_Nor_Robot", Nothing_Found'Access);
   Script ("F17_Decision_Without_Search",
           "send CACO|CAIN, " & With_Images & ", send CACO|CAIN",
           Decision_Alone'Access, Camera => True);
   Script ("F18_Positions_True", With_Positions, Positions_True'Access,
           Camera => True, Emulator_Options => "--marker-id 42 --noise 3");
   Script ("F18_Positions_In_Every_Image", With_Positions,
           Positions_Every_Image'Access, Camera => True);
   Add_Period ("F18_Position_Period", "CPOS", 8, 0.1, 0.004, 0.3);
   Script ("F18_Position_Of_Triangle", With_Positions,
           Position_Of_Triangle'Access, Camera => True,
           Emulator_Options => "--marker triangle --pose 50,20,120",
           Supervisor_Options => "--marker triangle");
   Script ("F18_Position_Of_Late_Image", With_Positions,
           Position_Of_Late_Image'Access, Camera => True,
           Emulator_Options =>
             "--pose 20,20,0 --camera-delay 1000 --position-noise 2",
           In_Time => True);
   Script ("F19_Position_Stopped", "CPST AACK", Position_Stopped'Access,
           Camera => True);
   Script ("F12_F18_Loop_Closes", Guarded & ", " & With_Positions,
           Loop_Closes'Access, Camera => True,
           Emulator_Options => "--pose 20,30,0");
end Camera_Tests;
