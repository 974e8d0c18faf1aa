--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14 to F19: the camera, the arena and the positions.

with Ada.Directories;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;          use Interfaces.C;

with Emulators;
with Expectations;          use Expectations;
with Images;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Process_Facts;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;

package body Camera_Tests is

   procedure Open_And_Close;
   procedure Open_Fails;
   procedure Loaded_When_Opened;
   procedure Library_Missing;
   procedure Open_Takes_Long;
   procedure Not_Open_Is_Anak;
   procedure Image_Period;
   procedure Image_Size;
   procedure Own_Jpeg;
   procedure Changing_Size;
   procedure Damaged_Images;
   procedure Other_Image_Rate;
   procedure Still_Image;
   procedure No_Image_After_Close;
   procedure Camera_Stalls;
   procedure Camera_Goes;
   procedure Arena_Confirmed;
   procedure Arena_Rejected;
   procedure Drawn_As_Asked;
   procedure Arena_Searched_Again;
   procedure Arena_Of_Stalled_Camera;
   procedure Arena_Not_Found;
   procedure Arena_Decision_Without_Search;
   procedure Positions_True;
   procedure Positions_Every_Image;
   procedure Position_Not_Found;
   procedure Position_Of_Triangle;
   procedure Position_Of_Late_Image;
   procedure Position_Stopped;
   procedure Loop_Closes;

   type Position is record
      Id             : Integer := 0;
      Angle          : Float := 0.0;
      Cx, Cy, Dx, Dy : Float := 0.0;
   end record;

   function Parsed (Item : Message) return Position;
   --  Of a CPOS message; raises Failed where it is malformed

   procedure Check_Period
     (R         : in out Rig;
      Label     : String;
      Count     : Positive;
      Period    : Duration;
      Tolerance : Duration;
      Longest   : Duration);
   --  Between Count + 1 messages: Period within Tolerance in the mean, none
   --  longer than Longest

   function Parsed (Item : Message) return Position is
      Text   : constant String := To_String (Item.Data);
      First  : Positive := Text'First;
      Last   : Natural;
      Fields : array (1 .. 6) of Float;
      Id     : Integer := 0;
   begin
      for Number in Fields'Range loop
         Last := Index (Text & ";", ";", First) - 1;
         declare
            Field : constant String := Text (First .. Last);
            Point : constant Natural := Index (Field, ".");
         begin
            if Number = 1 then
               Id := Integer'Value (Field);
               Check (Point = 0, "the identifier of " & Text);
            else
               Fields (Number) := Float'Value (Field);
               Check
                 (Point > 0 and then Field'Last - Point = 6,
                  "not six decimals in " & Text);
            end if;
         end;
         First := Last + 2;
      end loop;
      Check (First > Text'Last, "too much in " & Text);
      return (Id, Fields (2), Fields (3), Fields (4), Fields (5),
              Fields (6));
   exception
      when Constraint_Error =>
         raise Failed with "malformed CPOS:" & Text;
   end Parsed;

   procedure Check_Period
     (R         : in out Rig;
      Label     : String;
      Count     : Positive;
      Period    : Duration;
      Tolerance : Duration;
      Longest   : Duration)
   is
      procedure Measure;

      procedure Measure is
         Periods : Samples.Set;
         First   : Instant;
         Last    : Instant;
         Item    : Message;
      begin
         R.Monitor.Skip_To_Now;
         Item := R.Monitor.Next_Of (Label, Within => 3.0);
         First := Item.Time;
         Last := First;
         for Number in 1 .. Count loop
            Item := R.Monitor.Next_Of (Label, Within => 3.0);
            Periods.Add (Item.Time - Last);
            Last := Item.Time;
         end loop;
         Note (Label & ": mean period " & Milliseconds ((Last - First) / Count)
               & ", shortest " & Milliseconds (Periods.Quantile (0.0))
               & ", longest " & Milliseconds (Periods.Quantile (1.0)));
         Check_Within
           (abs ((Last - First) / Count - Period), Tolerance,
            "the period of " & Label & " off");
         Check_Within
           (Periods.Quantile (1.0), Longest, "the longest of " & Label);
      end Measure;

   begin
      Measure_Calmly (Measure'Access);
   end Check_Period;

   procedure Open_And_Close is
      R           : Rig;
      Item        : Message;
      Descriptors : Natural := 0;
      Threads     : Natural := 0;
   begin
      Assemble (R, Camera => True);
      for Attempt in 1 .. 12 loop
         R.Monitor.Expect ("COPN", "AACK", Within => 10.0);
         R.Monitor.Expect ("COPN", "AACK");
         Item := R.Monitor.Next_Of ("CIMG", Within => 3.0);
         Check (Item.Size > 1_000, "a small image");
         R.Monitor.Expect ("CCLS", "AACK");
         R.Monitor.Expect ("CCLS", "AACK");
         if Attempt = 2 then
            Descriptors := Process_Facts.Descriptors (R.Supervisor.Pid);
            Threads := Process_Facts.Threads (R.Supervisor.Pid);
         end if;
      end loop;
      R.Emulator.Await_Status ("viewers", "0", Within => 3.0);
      Check
        (Process_Facts.Descriptors (R.Supervisor.Pid) <= Descriptors,
         "descriptors leak with the camera");
      Check
        (Process_Facts.Threads (R.Supervisor.Pid) <= Threads,
         "threads leak with the camera");
   end Open_And_Close;

   procedure Open_Fails is

      procedure Refuse (Source : String);

      procedure Refuse (Source : String) is
         R : Rig;
      begin
         R.Supervisor.Start ("--camera " & Source);
         Connect (R);
         R.Monitor.Expect ("COPN", "ANAK", Within => 10.0);
         R.Monitor.Expect ("CPCO", "ANAK");
         R.Monitor.Expect ("COPN", "ANAK", Within => 10.0);
         R.Monitor.Expect_Silence ("CIMG", For_Time => 0.2);
      end Refuse;

      E : Emulators.Emulator;
   begin
      Refuse ("/no/such/camera.avi");
      Refuse ("/dev/null");
      Refuse (Programs.Supervisor);
      Refuse ("http://127.0.0.1:1/stream.mjpg");
      E.Start (Camera => True);
      declare
         Url : constant String := E.Camera_Url;
      begin
         --  answers, but with text
         Refuse (Url (1 .. Index (Url, "/", Backward)) & "pose");
      end;
   end Open_Fails;

   procedure Loaded_When_Opened is
      --  OpenCV, while the robot drives; before, the supervisor is small
      Small : constant := 20_000;
      --  Kilobytes
      R     : Rig;
      Size  : Natural;
   begin
      Assemble (R, Camera => True);
      Start_Robot (R, Watchdog => True);
      R.Monitor.Expect ("RGFW", "AACK");
      R.Monitor.Expect ("CPCO", "ANAK");
      R.Monitor.Expect ("CCLS", "AACK");
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
      Check
        (R.Emulator.Status ("moving") = "1"
         and then R.Emulator.Status ("disabled_count") = "0",
         "the robot has stopped meanwhile");
   end Loaded_When_Opened;

   procedure Library_Missing is
      --  The robot works nevertheless
      Folder : constant String := Programs.Temporary_Folder & "/bare";
      Copy   : constant String := Folder & "/destijl";
      R      : Rig;
   begin
      Ada.Directories.Create_Directory (Folder);
      Ada.Directories.Copy_File (Programs.Supervisor, Copy);
      Check (Libc.Chmod (To_C (Copy), 8#755#) = 0, "the copy cannot be run");
      Assemble (R, Camera => True, Program => Copy);
      R.Monitor.Expect ("COPN", "ANAK");
      R.Supervisor.Expect_Log
        ("libdestijl_vision.so: cannot open", Within => 2.0);
      Start_Robot (R);
      R.Monitor.Expect ("RGFW", "AACK");
      R.Emulator.Await_Status ("moving", "1", Within => 1.0);
      R.Monitor.Expect ("CCLS", "AACK");

      --  It is looked for each time
      Ada.Directories.Copy_File
        (Programs.Vision_Library, Folder & "/libdestijl_vision.so");
      Open_Camera (R);
   end Library_Missing;

   procedure Open_Takes_Long is
      --  A camera that accepts the connection and sends nothing delays neither
      --  the robot, nor the end of the session, nor that of the supervisor.
      R    : Rig;
      Item : Message;
      Time : Instant;
   begin
      Assemble (R, Camera => True);
      Move_Forward (R);
      R.Emulator.Tell ("camera stall");
      R.Monitor.Skip_To_Now;
      Time := Now;
      R.Monitor.Send_Line ("COPN");
      delay 0.3;
      R.Monitor.Send_Line ("RSTP");
      Check
        (R.Emulator.Await_On_Wire ("M=0", Within => 0.5).First > Time,
         "the stop waits for the camera");
      Item := R.Monitor.Next_Answer (Within => 10.0);
      Note ("refused after " & Milliseconds (Item.Time - Time));
      Check (Item.Label = "ANAK", "COPN was answered " & Item.Label);
      Check (R.Monitor.Next_Answer.Label = "AACK", "the stop");

      --  The monitor disconnects while the camera is being opened
      R.Monitor.Send_Line ("COPN");
      delay 0.3;
      Time := Now;
      R.Monitor.Close;
      R.Supervisor.Expect_Log ("session closed", Within => 3.0);
      Check_Within
        (R.Supervisor.Time_Of ("session closed") - Time, 2.0,
         "closing the session");
      R.Emulator.Tell ("camera on");
      Connect (R);
      Open_Camera (R);
      R.Monitor.Expect ("CCLS", "AACK");

      --  The supervisor is stopped while the camera is being opened
      R.Emulator.Tell ("camera stall");
      R.Monitor.Send_Line ("COPN");
      delay 0.3;
      Time := Now;
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check
        (R.Supervisor.Exit_Status (Within => 3.0) = 0, "exit status");
      Note ("ended after " & Milliseconds (Now - Time));
   end Open_Takes_Long;

   procedure Not_Open_Is_Anak is
      R : Rig;
   begin
      Assemble (R, Camera => True);
      R.Monitor.Expect ("CPCO", "ANAK");
      R.Monitor.Expect ("CASA", "ANAK");
      R.Monitor.Expect ("CPST", "AACK");
      R.Monitor.Expect ("CCLS", "AACK");
      Open_Camera (R);
      R.Monitor.Expect ("CCLS", "AACK");
      R.Monitor.Expect ("CASA", "ANAK");
   end Not_Open_Is_Anak;

   procedure Image_Period is
      --  F15: 10.0 images a second within 1 %, jitter 20 ms at p99
      R : Rig;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      delay 0.5;
      Check_Period
        (R, "CIMG", Count => 60,
         Period => 0.1, Tolerance => 0.003, Longest => 0.2);
      Check (R.Monitor.Broken_Images = 0, "a broken image");
      Check
        (Images.Seen (R.Monitor.Last_Image).Coloured < Images.Drawn,
         "something is drawn without being asked for");
   end Image_Period;

   procedure Image_Size is
      R     : Rig;
      Facts : Images.Facts;
   begin
      Assemble
        (R, Camera => True,
         Supervisor_Options => "--frame-size 320x240 --jpeg-quality 40");
      Open_Camera (R);
      Facts := Images.Seen (R.Monitor.Last_Image);
      Check
        (Facts.Width = 320 and then Facts.Height = 240,
         "image of" & Facts.Width'Image & " x" & Facts.Height'Image);
      Check (R.Monitor.Last_Image'Length < 40_000, "a large image");
   end Image_Size;

   procedure Own_Jpeg is
      --  The camera's JPEG is passed on unchanged, unless something is drawn
      Path : constant String := Programs.Temporary_Folder & "/own.jpg";
      R    : Rig;

      procedure Expect_Own (Own : Boolean; What : String);

      procedure Expect_Own (Own : Boolean; What : String) is
         Item : Message;
      begin
         R.Monitor.Skip_To_Now;
         for Number in 1 .. 3 loop
            Item := R.Monitor.Next_Of ("CIMG", Within => 3.0);
         end loop;
         Check (Item.Size > 1_000, "a small image");
         Check
           (Images.Is_File (R.Monitor.Last_Image, Path) = Own,
            What & (if Own then ": not" else ": still")
            & " the camera's own image");
         Check
           ((Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn)
              /= Own, What & ": drawn");
      end Expect_Own;

   begin
      --  Without noise all images are equal
      Assemble
        (R, Camera => True,
         Emulator_Options => "--noise 0 --pose 30,40,60",
         Supervisor_Options => "--jpeg-quality 20");
      Open_Camera (R);
      R.Emulator.Save_Snapshot (Path);
      Expect_Own (True, "from the beginning");
      R.Monitor.Expect ("CPCO", "AACK");
      Expect_Own (False, "with positions");
      R.Monitor.Expect ("CPST", "AACK");
      Expect_Own (True, "without positions again");
      R.Monitor.Send_Line ("CASA");
      Check (R.Monitor.Next_Of ("CIMG", Within => 5.0).Size > 0, "arena");
      R.Monitor.Send_Line ("CACO");
      delay 0.3;
      Expect_Own (False, "with the arena");
   end Own_Jpeg;

   procedure Changing_Size is
      --  In mid-stream, there and back
      R : Rig;

      procedure Expect_Size (Width, Height : Positive);

      procedure Expect_Size (Width, Height : Positive) is
         Facts : Images.Facts;
         Item  : Message;
      begin
         R.Monitor.Skip_To_Now;
         for Number in 1 .. 6 loop
            Item := R.Monitor.Next_Of ("CIMG", Within => 3.0);
         end loop;
         Check (Item.Number > 0, "no image");
         Facts := Images.Seen (R.Monitor.Last_Image);
         Check
           (Facts.Width = Width and then Facts.Height = Height,
            "image of" & Facts.Width'Image & " x" & Facts.Height'Image);
      end Expect_Size;

   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      Expect_Size (640, 480);
      R.Emulator.Tell ("camera size 320x180");
      Expect_Size (640, 360);
      R.Emulator.Tell ("camera size 1x1");
      Expect_Size (480, 480);
      R.Emulator.Tell ("camera size 1920x1080");
      Expect_Size (640, 360);
      R.Emulator.Tell ("camera size 640x480");
      Expect_Size (640, 480);
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
         R.Emulator.Tell ("camera garbage");
         delay 0.5;
         R.Emulator.Tell ("camera mend");
         R.Monitor.Skip_To_Now;
         Check
           (R.Monitor.Next_Of ("CIMG", Within => 3.0).Size > 1_000,
            "no image after damaged ones");
         Check
           (Images.Seen (R.Monitor.Last_Image).Width > 0,
            "an image that cannot be shown");
      end loop;
      Check (R.Monitor.Broken_Images = 0, "a broken image");
      R.Monitor.Expect ("CCLS", "AACK");
   end Damaged_Images;

   procedure Other_Image_Rate is
      R : Rig;
   begin
      Assemble (R, Camera => True, Supervisor_Options => "--fps 4");
      Open_Camera (R);
      Check_Period
        (R, "CIMG", Count => 8,
         Period => 0.25, Tolerance => 0.02, Longest => 0.5);
   end Other_Image_Rate;

   procedure Still_Image is
      --  A file as camera
      E    : Emulators.Emulator;
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/arena.jpg";
      Item : Message;
      Seen : Position;
      True_Pose : Emulators.Truth;
   begin
      E.Start (Camera => True, Options => "--pose 30,40,60 --marker-id 7");
      E.Save_Snapshot (Path);
      True_Pose := E.Pose;
      R.Supervisor.Start ("--camera " & Path);
      Connect (R);
      Open_Camera (R, Positions => True);
      Check_Period
        (R, "CIMG", Count => 20,
         Period => 0.1, Tolerance => 0.01, Longest => 0.3);
      Item := R.Monitor.Next_Of ("CPOS", Within => 2.0);
      Seen := Parsed (Item);
      Check
        (Seen.Id = 7 and then abs (Seen.Cx - True_Pose.Cx) <= 2.0
         and then abs (Seen.Cy - True_Pose.Cy) <= 2.0,
         "the robot of the file is seen at " & To_String (Item.Data));
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

   procedure Camera_Stalls is
      R    : Rig;
      Item : Message;
      Mark : Natural;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      Mark := R.Supervisor.Log_Length;
      R.Monitor.Skip_To_Now;
      R.Emulator.Tell ("camera stall");
      Item := R.Monitor.Next_Of ("MSSG", Within => 8.0);
      Note ("told: " & To_String (Item.Data));
      R.Monitor.Expect_Silence ("CIMG MSSG", For_Time => 0.7);
      Check
        (R.Supervisor.Log_Length > Mark, "nothing of it in the log");
      R.Monitor.Expect ("CPCO", "ANAK");
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Emulator.Tell ("camera on");
      Open_Camera (R, Positions => True);
      R.Monitor.Expect ("CCLS", "AACK");
   end Camera_Stalls;

   procedure Camera_Goes is
      --  Its stream is closed; a new one refused at first
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R, Positions => True);
      R.Monitor.Skip_To_Now;
      R.Emulator.Tell ("camera off");
      Item := R.Monitor.Next_Of ("MSSG", Within => 8.0);
      Check (Length (Item.Data) > 0, "told nothing");
      R.Monitor.Expect_Silence ("CIMG CPOS", For_Time => 0.5);
      R.Monitor.Expect ("COPN", "ANAK", Within => 10.0);
      R.Emulator.Tell ("camera on");
      Open_Camera (R);
   end Camera_Goes;

   procedure Arena_Confirmed is
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      R.Monitor.Skip_To_Now;
      R.Monitor.Send_Line ("CASA");
      --  One image may have been in transit; after it exactly one
      delay 1.5;
      declare
         Number : Natural := 0;
         Last   : Message;
      begin
         loop
            Item := R.Monitor.Next (Within => 0.0);
            exit when Item.Number = 0;
            Number := Number + 1;
            Last := Item;
         end loop;
         Check
           (Number in 1 .. 2,
            Number'Image & " messages between search and decision");
         Check (Last.Label = "CIMG", "search answered " & Last.Label);
         Check
           (Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn,
            "the arena is not drawn in the image of the search");
      end;
      R.Monitor.Expect_Silence ("CIMG CPOS AACK", For_Time => 0.5);
      R.Monitor.Send_Line ("CACO");
      for Number in 1 .. 5 loop
         Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      end loop;
      Check
        (Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn,
         "the confirmed arena is not drawn");

      --  and discarded with the camera
      R.Monitor.Expect ("CCLS", "AACK");
   end Arena_Confirmed;

   procedure Arena_Rejected is
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      Item := R.Monitor.Ask ("CASA", Within => 5.0);
      Check (Item.Label = "CIMG", "search answered " & Item.Label);
      delay 0.5;
      R.Monitor.Skip_To_Now;
      R.Monitor.Expect_Silence ("CIMG AACK", For_Time => 0.5);
      R.Monitor.Send_Line ("CAIN");
      for Number in 1 .. 5 loop
         Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      end loop;
      Check
        (Images.Seen (R.Monitor.Last_Image).Coloured < Images.Drawn,
         "the rejected arena is drawn");
   end Arena_Rejected;

   procedure Drawn_As_Asked is

      procedure Confirm (R : in out Rig);
      --  The arena, which is drawn when it is to be confirmed

      function Coloured (R : in out Rig) return Natural;
      --  Pixels of the image after the next, all of which has been made since

      procedure Confirm (R : in out Rig) is
         Item : constant Message := R.Monitor.Ask ("CASA", Within => 5.0);
      begin
         Check (Item.Label = "CIMG", "search answered " & Item.Label);
         Check
           (Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn,
            "the arena to be confirmed is not drawn");
         R.Monitor.Send_Line ("CACO");
      end Confirm;

      function Coloured (R : in out Rig) return Natural is
         Item : Message;
      begin
         R.Monitor.Skip_To_Now;
         for Number in 1 .. 2 loop
            Item := R.Monitor.Next_Of ("CPOS", Within => 2.0);
            Check (Parsed (Item).Id = 1, "seen " & To_String (Item.Data));
            Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
         end loop;
         return Images.Seen (R.Monitor.Last_Image).Coloured;
      end Coloured;

   begin
      for Choice in 1 .. 2 loop
         declare
            R      : Rig;
            Before : Natural;
            After  : Natural;
         begin
            Assemble
              (R, Camera => True,
               Supervisor_Options =>
                 (if Choice = 1 then "--draw arena" else "--draw none"));
            Open_Camera (R, Positions => True);
            Before := Coloured (R);
            Check (Before < Images.Drawn / 4, "the robot is drawn");
            Confirm (R);
            After := Coloured (R);
            Check
              ((if Choice = 1 then After >= Images.Drawn
                else After < Images.Drawn / 4),
               "confirmed, coloured are" & After'Image);
         end;
      end loop;
   end Drawn_As_Asked;

   procedure Arena_Searched_Again is
      --  After a confirmed one, and while one waits for the decision;
      --  positions stay true inside the arena
      R    : Rig;
      Item : Message;
      Seen : Position;
      True_Pose : Emulators.Truth;
   begin
      Assemble (R, Camera => True, Emulator_Options => "--pose 20,15,30");
      Open_Camera (R);
      for Attempt in 1 .. 3 loop
         R.Monitor.Send_Line ("CASA");
         delay 0.6;
         R.Monitor.Skip_To_Now;
         Item := R.Monitor.Ask ("CASA", Within => 5.0);
         Check (Item.Label = "CIMG", "search answered " & Item.Label);
         R.Monitor.Expect_Silence ("CIMG", For_Time => 0.4);
         R.Monitor.Send_Line ("CACO");
         Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      end loop;
      R.Monitor.Expect ("CPCO", "AACK");
      Item := R.Monitor.Next_Of ("CPOS", Within => 2.0);
      Seen := Parsed (Item);
      True_Pose := R.Emulator.Pose;
      Check
        (Seen.Id = 1 and then abs (Seen.Cx - True_Pose.Cx) <= 2.0
         and then abs (Seen.Cy - True_Pose.Cy) <= 2.0,
         "inside the arena the robot is seen at " & To_String (Item.Data));
   end Arena_Searched_Again;

   procedure Arena_Of_Stalled_Camera is
      --  The search is answered nevertheless: by the last image, or ANAK
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R);
      R.Emulator.Tell ("camera stall");
      delay 0.5;
      R.Monitor.Skip_To_Now;
      R.Monitor.Send_Line ("CASA");
      R.Monitor.Send_Line ("nope");
      Item := R.Monitor.Next_Answer (Within => 8.0, Command => "CASA");
      Check
        (Item.Label in "ANAK" | "CIMG", "CASA was answered " & Item.Label);
      Check (R.Monitor.Next_Answer.Label = "ACER", "no answer after it");
      R.Monitor.Send_Line ("CAIN");
      R.Emulator.Tell ("camera on");
      delay 3.0;
      R.Monitor.Expect ("CCLS", "AACK");
      Open_Camera (R);
   end Arena_Of_Stalled_Camera;

   procedure Arena_Not_Found is
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/empty.jpg";
      Item : Message;
   begin
      Images.Write_Empty (Path);
      R.Supervisor.Start ("--camera " & Path);
      Connect (R);
      Open_Camera (R);
      R.Monitor.Expect ("CASA", "ANAK", Within => 5.0);
      --  no decision: the images continue
      Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      Check (Item.Number > 0, "no image");
   end Arena_Not_Found;

   procedure Arena_Decision_Without_Search is
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Camera => True);
      R.Monitor.Send_Line ("CACO");
      R.Monitor.Send_Line ("CAIN");
      Open_Camera (R);
      R.Monitor.Send_Line ("CACO");
      R.Monitor.Send_Line ("CAIN");
      R.Monitor.Skip_To_Now;
      Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      Check
        (Item.Number > 0
         and then Images.Seen (R.Monitor.Last_Image).Coloured
                  < Images.Drawn,
         "an arena that was never found is drawn");
      R.Monitor.Expect ("what", "ACER");
   end Arena_Decision_Without_Search;

   procedure Positions_True is
      R : Rig;
      Worst_Distance : Float := 0.0;
      Worst_Angle    : Float := 0.0;

      procedure Try (X, Y : Integer; Heading : Integer);

      procedure Try (X, Y : Integer; Heading : Integer) is
         Truth : Emulators.Truth;
         Item  : Message;
         Seen  : Position;
         Off   : Float;
         Turn  : Float;

         function Image (Value : Integer) return String is
           (Trim (Integer'Image (Value), Both));
      begin
         R.Emulator.Tell
           ("pose " & Image (X) & " " & Image (Y) & " " & Image (Heading));
         Truth := R.Emulator.Pose;
         delay 0.3;
         R.Monitor.Skip_To_Now;
         Item := R.Monitor.Next_Of ("CPOS", Within => 2.0);
         Seen := Parsed (Item);
         Off := Float'Max
           (abs (Seen.Cx - Truth.Cx), abs (Seen.Cy - Truth.Cy));
         Off := Float'Max (Off, abs (Seen.Dx - Truth.Dx));
         Off := Float'Max (Off, abs (Seen.Dy - Truth.Dy));
         Turn := abs (Seen.Angle - Truth.Angle);
         if Turn > 180.0 then
            Turn := 360.0 - Turn;
         end if;
         Worst_Distance := Float'Max (Worst_Distance, Off);
         Worst_Angle := Float'Max (Worst_Angle, Turn);
         Check
           (Seen.Id = 42 and then Off <= 2.0 and then Turn <= 1.0
            and then Seen.Angle > -180.0 and then Seen.Angle <= 180.0,
            "seen " & To_String (Item.Data) & ", true are"
            & Truth.Angle'Image & Truth.Cx'Image & Truth.Cy'Image
            & Truth.Dx'Image & Truth.Dy'Image);
      end Try;

   begin
      Assemble
        (R, Camera => True,
         Emulator_Options => "--marker-id 42 --noise 3");
      Open_Camera (R, Positions => True);
      for Step in 0 .. 11 loop
         Try (X => 15 + (Step * 37) mod 50, Y => 12 + (Step * 23) mod 36,
              Heading => Step * 30);
      end loop;
      Try (40, 30, 45);
      Try (40, 30, 90);
      Try (40, 30, 180);
      Note ("worst: " & Worst_Distance'Image & " px,"
            & Worst_Angle'Image & " degrees");

      --  "an upright marker is at 90"
      R.Emulator.Tell ("pose 40 30 90");
      delay 0.3;
      R.Monitor.Skip_To_Now;
      declare
         Seen : constant Position :=
           Parsed (R.Monitor.Next_Of ("CPOS", Within => 2.0));
      begin
         Check
           (abs (Seen.Angle - 90.0) <= 1.0,
            "an upright marker is at" & Seen.Angle'Image);
      end;
   end Positions_True;

   procedure Positions_Every_Image is
      R    : Rig;
      Last : Natural;
   begin
      Assemble (R, Camera => True);
      Open_Camera (R, Positions => True);
      Check_Period
        (R, "CPOS", Count => 40,
         Period => 0.1, Tolerance => 0.004, Longest => 0.3);
      Last := R.Monitor.Count_Of ("CPOS");
      Check
        (abs (R.Monitor.Count_Of ("CIMG") - Last) <= 12,
         Last'Image & " positions,"
         & R.Monitor.Count_Of ("CIMG")'Image & " images");
      Check
        (Images.Seen (R.Monitor.Last_Image).Coloured >= Images.Drawn / 4,
         "the robot is not drawn");
   end Positions_Every_Image;

   procedure Position_Not_Found is
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/empty.jpg";
      Item : Message;
      Seen : Position;
   begin
      Images.Write_Empty (Path);
      R.Supervisor.Start ("--camera " & Path);
      Connect (R);
      Open_Camera (R, Positions => True);
      for Number in 1 .. 5 loop
         Item := R.Monitor.Next_Of ("CPOS", Within => 2.0);
         Seen := Parsed (Item);
         Check
           (Seen.Id = -1 and then Seen.Cx = -1.0 and then Seen.Cy = -1.0,
            "no robot is CPOS:" & To_String (Item.Data));
      end loop;
      Item := R.Monitor.Next_Of ("CIMG", Within => 2.0);
      Check (Item.Number > 0, "no image");
   end Position_Not_Found;

   procedure Position_Of_Late_Image is
      --  The camera is a second late: half of it, and another second, are the
      --  margins of a machine with other work
      R         : Rig;
      Here      : Emulators.Truth;
      There     : Emulators.Truth;
      Displaced : Float := 0.0;

      function Is_At (Place : Emulators.Truth) return Boolean;
      --  By the newest position

      function Is_At (Place : Emulators.Truth) return Boolean is
         Seen : constant Position :=
           Parsed (R.Monitor.Next_Of ("CPOS", Within => 2.0));
      begin
         Displaced := Float'Max (Displaced, abs (Seen.Cx - Place.Cx));
         return abs (Seen.Cx - Place.Cx) <= 12.0
           and then abs (Seen.Cy - Place.Cy) <= 12.0;
      end Is_At;

   begin
      Assemble
        (R, Camera => True,
         Emulator_Options =>
           "--pose 20,20,0 --camera-delay 1000 --position-noise 2");
      Open_Camera (R, Positions => True);
      Here := R.Emulator.Pose;
      for Number in 1 .. 20 loop
         Check (Is_At (Here), "it is not seen where it stands");
      end loop;
      Check (Displaced > 0.5, "positions without noise");
      R.Emulator.Tell ("pose 60 40 0");
      There := R.Emulator.Pose;
      delay 0.5;
      R.Monitor.Skip_To_Now;
      Check (Is_At (Here), "images are not late");
      delay 1.5;
      R.Monitor.Skip_To_Now;
      Check (Is_At (There), "images are later than a second");
   end Position_Of_Late_Image;

   procedure Position_Of_Triangle is
      R     : Rig;
      Truth : Emulators.Truth;
      Item  : Message;
      Seen  : Position;
      Turn  : Float;
   begin
      Assemble
        (R, Camera => True,
         Emulator_Options => "--marker triangle --pose 50,20,120",
         Supervisor_Options => "--marker triangle");
      Open_Camera (R, Positions => True);
      Truth := R.Emulator.Pose;
      Item := R.Monitor.Next_Of ("CPOS", Within => 2.0);
      Seen := Parsed (Item);
      Turn := abs (Seen.Angle - Truth.Angle);
      Check
        (Seen.Id = 0
         and then abs (Seen.Cx - Truth.Cx) <= 2.0
         and then abs (Seen.Cy - Truth.Cy) <= 2.0
         and then (Turn <= 1.0 or else Turn >= 359.0),
         "seen " & To_String (Item.Data) & ", true are"
         & Truth.Angle'Image & Truth.Cx'Image & Truth.Cy'Image);
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
         delay 0.1;
         R.Monitor.Skip_To_Now;
         Mark := R.Monitor.Count_Of ("CIMG");
         R.Monitor.Expect_Silence ("CPOS", For_Time => 0.6);
         Check
           (R.Monitor.Count_Of ("CIMG") - Mark >= 3,
            "the images do not go on");
         Check
           (Images.Seen (R.Monitor.Last_Image).Coloured < Images.Drawn,
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
      Before := Parsed (R.Monitor.Next_Of ("CPOS", Within => 2.0));
      R.Monitor.Expect ("RMOV:200", "AACK");
      R.Emulator.Await_Status ("moving", "0", Within => 10.0);
      delay 0.3;
      R.Monitor.Skip_To_Now;
      After := Parsed (R.Monitor.Next_Of ("CPOS", Within => 2.0));
      Note ("20 cm are" & Float'Image (After.Cx - Before.Cx) & " px");
      Check (After.Cx - Before.Cx > 60.0, "the robot has not moved");
      Check (abs (After.Cy - Before.Cy) < 3.0, "not straight on");
   end Loop_Closes;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "F14_F16_Open_And_Close", Open_And_Close'Access);
      Add (Suite, "F14_Open_Fails", Open_Fails'Access);
      Add
        (Suite, "F14_Library_Loaded_When_Opened", Loaded_When_Opened'Access);
      Add (Suite, "F14_Library_Missing", Library_Missing'Access);
      Add (Suite, "F14_Open_Takes_Long", Open_Takes_Long'Access);
      Add (Suite, "F14_Not_Open_Is_ANAK", Not_Open_Is_Anak'Access);
      Add (Suite, "F15_Image_Period", Image_Period'Access);
      Add (Suite, "F15_Image_Size_And_Quality", Image_Size'Access);
      Add (Suite, "F15_Own_JPEG_Of_The_Camera", Own_Jpeg'Access);
      Add (Suite, "F15_Image_Size_Changes", Changing_Size'Access);
      Add (Suite, "F15_Damaged_Images", Damaged_Images'Access);
      Add (Suite, "F15_Other_Image_Rate", Other_Image_Rate'Access);
      Add (Suite, "F14_Still_Image_As_Camera", Still_Image'Access);
      Add (Suite, "F16_No_Image_After_Close", No_Image_After_Close'Access);
      Add (Suite, "F15_Camera_Stops_Delivering", Camera_Stalls'Access);
      Add (Suite, "F15_Camera_Goes_Away", Camera_Goes'Access);
      Add (Suite, "F17_Arena_Confirmed", Arena_Confirmed'Access);
      Add (Suite, "F17_Arena_Rejected", Arena_Rejected'Access);
      Add (Suite, "F17_F18_Drawn_As_Asked", Drawn_As_Asked'Access);
      Add (Suite, "F17_Arena_Searched_Again", Arena_Searched_Again'Access);
      Add (Suite, "F17_Arena_Of_Stalled_Camera",
           Arena_Of_Stalled_Camera'Access);
      Add (Suite, "F17_Arena_Not_Found", Arena_Not_Found'Access);
      Add (Suite, "F17_Decision_Without_Search",
           Arena_Decision_Without_Search'Access);
      Add (Suite, "F18_Positions_True", Positions_True'Access);
      Add (Suite, "F18_Positions_In_Every_Image",
           Positions_Every_Image'Access);
      Add (Suite, "F18_Position_Not_Found", Position_Not_Found'Access);
      Add (Suite, "F18_Position_Of_Triangle", Position_Of_Triangle'Access);
      Add (Suite, "F18_Position_Of_Late_Image",
           Position_Of_Late_Image'Access);
      Add (Suite, "F19_Position_Stopped", Position_Stopped'Access);
      Add (Suite, "F12_F18_Loop_Closes", Loop_Closes'Access);
   end Add_To;

end Camera_Tests;
