--  SPDX-License-Identifier: GPL-3.0-or-later
--  The Ada side: what it passes on, and how it rounds.

with Interfaces.C; use Interfaces.C;

with Bytes;          use Bytes;
with Options;
with Pictures;
with Scenes;
with Vision.C_Shapes; use Vision.C_Shapes;
with Vision.Library;  use Vision.Library;
with Vision; use Vision;
with Unit_Runs; use Unit_Runs;

procedure Vision_Tests is

   use type Bytes.Byte;

   function Is_Near
     (Value : Micro_Pixels; Truth : double) return Boolean
   is (abs (double (Value) / 1.0E6 - Truth) < 2.0);

   Sound : constant C_Robot :=
     (Id => 7, Centre => (1.5, -2.25), Direction => (3.0, 4.0),
      Angle => 180.0);

   Sound_In_Ada : constant Robot :=
     (Id => 7, Centre => (1_500_000, -2_250_000),
      Direction => (3_000_000, 4_000_000), Angle => 180_000_000);

   procedure Open_Scene (Scene : Scenes.Description) is
      --  Through a file, as a camera's images come
      Path   : constant String := Pictures.Temporary ("scene.jpg");
      Result : Status;
   begin
      Pictures.Save (Scene, Path);
      Open (Path, 640, 480, 10, Result);
      Pictures.Remove (Path);
      Assert (Result = Done, "open");
      Grab (2, Result);
      Assert (Result = Done, "grab");
      Close;
   end Open_Scene;

   procedure Test_Arena is
      Scene  : Scenes.Description := Scenes.Default;
      Truth  : Scenes.Corner_Coordinates;
      Found  : Arena_Corners;
      Result : Status;
   begin
      Scene.Turn := 5.0;
      Open_Scene (Scene);
      Find_Arena (2, Found, Result);
      Assert (Result = Done, "found");
      Assert (Scenes.Arena_Truth (Scene, Truth) = 0, "truth");
      for C in Corner loop
         Assert (Is_Near (Found (C).X, Truth (2 * Corner'Pos (C)))
                 and then
                 Is_Near (Found (C).Y, Truth (2 * Corner'Pos (C) + 1)),
                 C'Image);
      end loop;

      Scene.Arena := 0;
      Open_Scene (Scene);
      Find_Arena (2, Found, Result);
      Assert (Result = Not_Found and then Found = No_Arena, "none");
      Find_Arena (5, Found, Result);
      Assert (Result = Bad_Argument and then Found = No_Arena, "no image");
   end Test_Arena;

   procedure Test_Robots is
      Scene          : Scenes.Description;
      Field          : Arena_Corners;
      Robots         : Robot_Array;
      Count          : Robot_Count;
      Result         : Status;
      Cx, Cy, Dx, Dy : double;
   begin
      for Kind in Options.Marker_Kind loop
         Scene := Pictures.Scene_With
           (Options.Marker_Kind'Pos (Kind), 321, 33.0, 22.0, 60.0);
         Assert (Scenes.Robot_Truth (Scene, 0, Cx, Cy, Dx, Dy) = 0, "truth");
         Open_Scene (Scene);
         Find_Arena (2, Field, Result);
         Assert (Result = Done, "arena");
         for Bounded in Boolean loop
            Find_Robots (2, Kind, (if Bounded then Field else No_Arena),
                         Bounded, Robots, Count, Result);
            Assert (Result = Done and then Count = 1, "one");
            Assert (Is_Near (Robots (1).Centre.X, Cx)
                    and then Is_Near (Robots (1).Centre.Y, Cy), "centre");
            Assert (Is_Near (Robots (1).Direction.X, Dx)
                    and then Is_Near (Robots (1).Direction.Y, Dy),
                    "direction");
            Assert (Robots (1).Angle in 119_000_000 .. 121_000_000,
                    "angle" & Robots (1).Angle'Image);
            Assert (Robots (1).Id =
                      (case Kind is
                          when Options.Aruco    => 321,
                          when Options.Triangle => 0), "identifier");
         end loop;
         Find_Robots (2, Kind, No_Arena, True, Robots, Count, Result);
         Assert (Result = Not_Found and then Count = 0, "none in no arena");
      end loop;
      Open_Scene (Scenes.Default);
      Find_Robots (2, Options.Aruco, No_Arena, False, Robots, Count, Result);
      Assert (Result = Not_Found and then Count = 0, "none");
      Find_Robots (5, Options.Aruco, No_Arena, False, Robots, Count, Result);
      Assert (Result = Bad_Argument and then Count = 0, "no image");
   end Test_Robots;

   procedure Test_Draw is
      Field  : Arena_Corners;
      Result : Status;
   begin
      Open_Scene (Scenes.Default);
      Find_Arena (2, Field, Result);
      Draw_Arena (2, Field, Result);
      Assert (Result = Done, "arena");
      Draw_Arena (5, Field, Result);
      Assert (Result = Bad_Argument, "no image");
      Draw_Robot
        (2, (7, (100_000_000, 90_000_000), (120_500_000, 90_000_000), 0),
         Result);
      Assert (Result = Done, "robot");
      Draw_Robot
        (2, (7, (Micro_Pixels'First, 0), (Micro_Pixels'Last, 0), 0), Result);
      Assert (Result = Bad_Argument, "robot far away");
   end Test_Draw;

   procedure Test_Encode is
      Buffer : Byte_Array (1 .. 400_000) := (others => 16#A5#);
      Length : Natural;
      Result : Status;
   begin
      Open_Scene (Scenes.Default);
      Encode (2, 80, Buffer, Length, Result);
      Assert (Result = Done and then Length > 1_000, "encoded");
      Assert (Buffer (1) = 16#FF# and then Buffer (2) = 16#D8#
              and then Buffer (Length) = 16#D9#, "JPEG");
      Assert ((for all K in Length + 1 .. Buffer'Last =>
                 Buffer (K) = 16#A5#), "the rest as before");
      Encode (2, 80, Buffer (1 .. 100), Length, Result);
      Assert (Result = Too_Small and then Length = 0, "too small");
      Encode (2, 80, Buffer (1 .. 0), Length, Result);
      Assert (Result = Too_Small and then Length = 0, "no room at all");
      Encode (5, 80, Buffer, Length, Result);
      Assert (Result = Bad_Argument and then Length = 0, "no image");
   end Test_Encode;

   procedure Test_Texts is
      --  No password of a URL gets into a message
      Text   : Reason_Text;
      Last   : Natural;
      Result : Status;

      procedure Check (Source, Says : String) is
      begin
         Open (Source, 640, 480, 10, Result);
         Assert (Result = No_Camera, "opened: " & Source);
         Reason (Text, Last);
         Assert (Last >= Says'Length and then Text (1 .. Says'Length) = Says,
                 Text (1 .. Last));
         Assert ((for all C of Text (Last + 1 .. Text'Last) => C = ' '),
                 "blank behind");
      end Check;

   begin
      Check ("http://me:se@cret@[::1]:1/a?key=b", "http://...@[::1]:1/a?...");
      Check ("http://me:se/cret@[::1]:1/", "http://...@[::1]:1/");
      Check ("http://me@[::1]:1/", "http://...@[::1]:1/:");
      Check ("http://[::1]:1/a?key=b", "http://[::1]:1/a?...:");
      Check ("no location=http://a:b@c/?d ! ""http://e:f@g"" ! none",
             "no location=http://...@c/?... ! ""http://...@g"" ! none");
      Check ("/no/such/file", "/no/such/file");
      Check ((1 .. Max_Source => '/'), (1 .. 9 => '/'));
      Assert (Last = Text'Last, "a long reason is cut");
      Open ("", 640, 480, 10, Result);
      Assert (Result = Bad_Argument, "empty");
      Grab (0, Result);
      Assert (Result = No_Camera, "not open");
   end Test_Texts;

   procedure Test_Ranges is
      Least : constant C_Robot :=
        (0, (-1.0E7, -1.0E7), (-1.0E7, -1.0E7), -180.0);
      Most  : constant C_Robot := (999, (1.0E7, 1.0E7), (1.0E7, 1.0E7), 180.0);
   begin
      Assert (Is_Sound (Sound) and then To_Ada (Sound) = Sound_In_Ada,
              "in between");
      Assert (To_C (Sound_In_Ada) = Sound, "and back");
      Assert (Is_Sound (Least) and then To_Ada (Least) =
                (0, (-10 ** 13, -10 ** 13), (-10 ** 13, -10 ** 13),
                 -180_000_000), "least");
      Assert (Is_Sound (Most) and then To_Ada (Most) =
                (999, (10 ** 13, 10 ** 13), (10 ** 13, 10 ** 13),
                 180_000_000), "most");
      Assert (To_Ada (C_Point'(0.000_000_6, -0.000_000_4)) = (1, 0),
              "rounded");
      Assert (To_C (Area'((1_000_000, 2_000_000), 500_000)) =
                ((1.0, 2.0), 0.5), "area");
   end Test_Ranges;

   procedure Test_Unsound_Robots is
      Good   : constant C_Point := Sound.Centre;
      Wrong  : constant array (Positive range <>) of C_Robot :=
        ((-1, Good, Good, 0.0), (1_000, Good, Good, 0.0),
         (int'First, Good, Good, 0.0), (7, (1.000_000_1E7, 0.0), Good, 0.0),
         (7, (0.0, double'Last), Good, 0.0),
         (7, Good, (double'First, 0.0), 0.0),
         (7, Good, (0.0, -1.000_000_1E7), 0.0), (7, Good, Good, 180.000_1),
         (7, Good, Good, double'First));
      Robots : Robot_Array;
      Count  : Robot_Count;

      procedure Expect (Found : C_Robots; Total, Sound_Ones : Robot_Count) is
      begin
         Take_Robots (Found, Total, Robots, Count);
         Assert (Count = Sound_Ones
                 and then (for all K in 1 .. Count =>
                             Robots (K) = Sound_In_Ada),
                 Count'Image & " of" & Total'Image);
      end Expect;

   begin
      for W of Wrong loop
         Expect ((W, Sound, W, Sound), 4, 2);
         Expect ((W, W, Sound, Sound), 2, 0);
      end loop;
      Expect ((others => Sound), 4, 4);
      Expect ((others => Sound), 0, 0);
   end Test_Unsound_Robots;

begin
   Run_Test ("arena", Test_Arena'Access);
   Run_Test ("robots", Test_Robots'Access);
   Run_Test ("drawing", Test_Draw'Access);
   Run_Test ("encoding", Test_Encode'Access);
   Run_Test ("reasons, without the secrets of a URL", Test_Texts'Access);
   Run_Test ("numbers within their ranges", Test_Ranges'Access);
   Run_Test ("robots out of range are left out", Test_Unsound_Robots'Access);
end Vision_Tests;
