--  SPDX-License-Identifier: GPL-3.0-or-later
--  The sources of images: files, what cannot be opened, pace, scaling.

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces.C;  use Interfaces.C;

with AUnit.Assertions; use AUnit.Assertions;

with Pictures;
with Scenes;
with Vision_C; use Vision_C;

package body Vision_Source_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   procedure Check_Size (Slot, Width, Height : int; What : String);

   procedure Check_Pace (Images : Positive; Rate : Positive; What : String);
   --  So many images of the open source take as long as Rate a second says:
   --  never less, and not more, at one time at least

   procedure Check_Refused (Source : String);
   --  Cannot be opened, and that is found out soon

   procedure Test_Still (T : in out Any_Test);
   procedure Test_Still_After_Delay (T : in out Any_Test);
   procedure Test_Video (T : in out Any_Test);
   procedure Test_Video_Of_One_Image (T : in out Any_Test);
   procedure Test_Scaling (T : in out Any_Test);
   procedure Test_Not_Open (T : in out Any_Test);
   procedure Test_Close (T : in out Any_Test);
   procedure Test_Reopen (T : in out Any_Test);
   procedure Test_Refused_Names (T : in out Any_Test);
   procedure Test_Refused_Files (T : in out Any_Test);
   procedure Test_Refused_Cameras (T : in out Any_Test);
   procedure Test_Refused_Streams (T : in out Any_Test);

   procedure Check_Size (Slot, Width, Height : int; What : String) is
      W, H : aliased int := 0;
   begin
      Assert (Size (Slot, W'Access, H'Access) = Ok
              and then W = Width and then H = Height,
              What & ": is" & W'Image & " x" & H'Image);
   end Check_Size;

   procedure Check_Pace (Images : Positive; Rate : Positive; What : String)
   is
      Attempts : constant := 10;
      --  the machine may have other work
      Start    : Time;
      Taken    : Duration;
      Due      : constant Duration := Duration (Images) / Rate;
   begin
      for Attempt in 1 .. Attempts loop
         Start := Clock;
         for K in 1 .. Images loop
            Assert (Grab (0) = Ok, What & ": grab" & K'Image);
         end loop;
         Taken := To_Duration (Clock - Start);
         Assert (Taken >= Due - 1.5 / Duration (Rate),
                 What & ": took" & Taken'Image);
         exit when Taken <= Due + 0.5;
      end loop;
      Assert (Taken <= Due + 0.5, What & ": took" & Taken'Image);
   end Check_Pace;

   procedure Check_Refused (Source : String) is
      Limit : constant Duration := 10.0;
      --  a third of OpenCV's own, with room for a machine that has other work
      Start : constant Time := Clock;
   begin
      Assert (Open (To_C (Source), 640, 480, 10) = No_Camera,
              Source & ": refused");
      Assert (To_Duration (Clock - Start) < Limit, Source & ": in time");
      Assert (Grab (0) = No_Camera, Source & ": not open");
   end Check_Refused;

   procedure Test_Still (T : in out Any_Test) is
      pragma Unreferenced (T);
      Path  : constant String := Pictures.Temporary ("still.jpg");
      Found : aliased Arena;
   begin
      Pictures.Save (Scenes.Default, Path);
      Assert (Open (To_C (Path), 640, 480, 10) = Ok, "open");
      Pictures.Remove (Path);
      Check_Pace (10, 25, "still image");
      Check_Size (0, 640, 480, "still image");
      Assert (Find_Arena (0, Found'Access) = Ok, "the image of the file");
      Assert (Grab (3) = Ok and then Find_Arena (3, Found'Access) = Ok,
              "into another slot");
      Assert (Draw_Arena (3, Found'Access) = Ok, "draw");
      Assert (Grab (3) = Ok and then Find_Arena (3, Found'Access) = Ok,
              "a drawing does not stay");
      Assert (Close = Ok, "close");
   end Test_Still;

   procedure Test_Still_After_Delay (T : in out Any_Test) is
      pragma Unreferenced (T);
      Path : constant String := Pictures.Temporary ("still.ppm");
   begin
      Pictures.Save_Plain (64, 48, Path);
      Assert (Open (To_C (Path), 64, 48, 10) = Ok, "open");
      Pictures.Remove (Path);
      delay 0.4;
      Check_Pace (10, 25, "what was missed is not made up for");
      Assert (Close = Ok, "close");
   end Test_Still_After_Delay;

   procedure Test_Video (T : in out Any_Test) is
      pragma Unreferenced (T);
      Path    : constant String := Pictures.Temporary ("loop.avi");
      Last    : Time;
      Longest : Duration;
      Gap     : Duration := Duration'Last;
   begin
      Pictures.Save_Video (Scenes.Default, 5, 20, Path);
      Assert (Open (To_C (Path), 640, 480, 10) = Ok, "open");
      Check_Pace (18, 20, "three times round and a half");
      Check_Size (0, 640, 480, "video");

      --  five images later it begins again: as if it went on, in one of four
      --  times at least, whatever else the machine does
      for Round in 1 .. 4 loop
         Longest := 0.0;
         for Image in 1 .. 5 loop
            Last := Clock;
            Assert (Grab (0) = Ok, "grab");
            Longest := Duration'Max (Longest, To_Duration (Clock - Last));
         end loop;
         Gap := Duration'Min (Gap, Longest);
      end loop;
      Assert (Gap < 0.06, "a gap of" & Gap'Image & " s at the end");
      Assert (Close = Ok, "close");
      Pictures.Remove (Path);
   end Test_Video;

   procedure Test_Video_Of_One_Image (T : in out Any_Test) is
      pragma Unreferenced (T);
      Path : constant String := Pictures.Temporary ("one.avi");
   begin
      Pictures.Save_Video (Scenes.Default, 1, 25, Path);
      Assert (Open (To_C (Path), 320, 480, 10) = Ok, "open");
      Check_Pace (5, 25, "one image");
      Check_Size (0, 320, 240, "scaled");
      Pictures.Remove (Path);
      Assert (Grab (0) = No_Image, "the file is gone");
      Assert (Close = Ok, "close");
   end Test_Video_Of_One_Image;

   procedure Test_Scaling (T : in out Any_Test) is
      pragma Unreferenced (T);

      procedure Check (From_W, From_H : Positive; To_W, To_H : int);
      --  Fitted into 640 x 480

      procedure Check (From_W, From_H : Positive; To_W, To_H : int) is
         Path : constant String := Pictures.Temporary ("size.ppm");
      begin
         Pictures.Save_Plain (From_W, From_H, Path);
         Assert (Open (To_C (Path), 640, 480, 10) = Ok, "open");
         Pictures.Remove (Path);
         Assert (Grab (0) = Ok, "grab");
         Check_Size (0, To_W, To_H, From_W'Image & " x" & From_H'Image);
      end Check;
   begin
      Check (640, 480, 640, 480);
      Check (320, 240, 640, 480);
      Check (1_280, 960, 640, 480);
      Check (1_280, 720, 640, 360);
      Check (480, 640, 360, 480);
      Check (1, 1, 480, 480);
      Check (3_000, 2, 640, 1);
      Check (2, 3_000, 1, 480);
      Assert (Close = Ok, "close");
   end Test_Scaling;

   procedure Test_Not_Open (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Assert (Close = Ok, "close");
      Assert (Grab (0) = No_Camera, "grab");
   end Test_Not_Open;

   procedure Test_Close (T : in out Any_Test) is
      pragma Unreferenced (T);
      Path : constant String := Pictures.Temporary ("close.ppm");
   begin
      Pictures.Save_Plain (64, 48, Path);
      for Round in 1 .. 20 loop
         Assert (Open (To_C (Path), 64, 48, 10) = Ok, "open" & Round'Image);
         Assert (Grab (0) = Ok, "grab");
         Assert (Close = Ok, "close");
         Assert (Grab (0) = No_Camera, "closed");
         Assert (Close = Ok, "close what is closed");
      end loop;
      Check_Size (0, 64, 48, "the last image stays");
      Pictures.Remove (Path);
   end Test_Close;

   procedure Test_Reopen (T : in out Any_Test) is
      pragma Unreferenced (T);
      One : constant String := Pictures.Temporary ("one.ppm");
      Two : constant String := Pictures.Temporary ("two.ppm");
   begin
      Pictures.Save_Plain (64, 48, One);
      Pictures.Save_Plain (48, 64, Two);
      Assert (Open (To_C (One), 64, 64, 10) = Ok, "the first");
      Assert (Open (To_C (Two), 64, 64, 10) = Ok, "the second");
      Assert (Grab (0) = Ok, "grab");
      Check_Size (0, 48, 64, "the second");
      Assert (Open (To_C ("/no/such/file"), 64, 64, 10) = No_Camera,
              "the third is refused");
      Assert (Grab (0) = No_Camera, "and the second closed");
      Pictures.Remove (One);
      Pictures.Remove (Two);
   end Test_Reopen;

   procedure Test_Refused_Names (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Check_Refused ("/no/such/file.jpg");
      Check_Refused ("/tmp");
      Check_Refused ("nonsense");
      Check_Refused (" ");
      Check_Refused ("-1");
      Check_Refused ("99999999999999999999");
      Check_Refused ("/dev/null");
      Check_Refused ("%s%s%n");
      Check_Refused (String'(1 .. 1_024 => 'x'));
      Assert (Open (To_C (""), 640, 480, 10) = Bad_Argument, "empty");
   end Test_Refused_Names;

   procedure Test_Refused_Files (T : in out Any_Test) is
      pragma Unreferenced (T);
      Path : constant String := Pictures.Temporary ("broken.jpg");
   begin
      Pictures.Save_Text ("", Path);
      Check_Refused (Path);
      Pictures.Save_Text ("not an image at all", Path);
      Check_Refused (Path);
      Pictures.Save_Text
        (Character'Val (16#FF#) & Character'Val (16#D8#)
         & Character'Val (16#FF#) & Character'Val (16#E0#) & "cut", Path);
      Check_Refused (Path);
      Pictures.Save_Text ("P6 60000 60000 255 short", Path);
      Assert (Open (To_C (Path), 640, 480, 10) in No_Camera | Failed,
              "a huge image that is not there");
      Assert (Grab (0) = No_Camera, "not open");
      Pictures.Remove (Path);
   end Test_Refused_Files;

   procedure Test_Refused_Cameras (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Check_Refused ("97");
      Check_Refused ("9999");
      Check_Refused ("/dev/zero");
   end Test_Refused_Cameras;

   procedure Test_Refused_Streams (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Check_Refused ("http://127.0.0.1:9/stream.mjpg");
      Check_Refused ("rtsp://127.0.0.1:9/stream");
      Check_Refused ("nonsense://127.0.0.1/");
      Check_Refused ("http://");
      Check_Refused ("! ! !");
   end Test_Refused_Streams;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("sources"));

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Still'Access, "a still image");
      Register_Routine (T, Test_Still_After_Delay'Access,
                        "the pace after a delay");
      Register_Routine (T, Test_Video'Access, "a video, looped and paced");
      Register_Routine (T, Test_Video_Of_One_Image'Access,
                        "a video of one image, and its loss");
      Register_Routine (T, Test_Scaling'Access, "scaling");
      Register_Routine (T, Test_Not_Open'Access, "nothing open");
      Register_Routine (T, Test_Close'Access, "closing");
      Register_Routine (T, Test_Reopen'Access, "opening what is open");
      Register_Routine (T, Test_Refused_Names'Access, "names of nothing");
      Register_Routine (T, Test_Refused_Files'Access, "broken files");
      Register_Routine (T, Test_Refused_Cameras'Access, "absent cameras");
      Register_Routine (T, Test_Refused_Streams'Access, "absent streams");
   end Register_Tests;

end Vision_Source_Tests;
