--  SPDX-License-Identifier: GPL-3.0-or-later
--  vision_c itself: arguments, slots, unusual sizes, drawing, encoding.

with GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;
with System;       use System;

with Pictures;
with Scenes;
with Vision_C; use Vision_C;
with Unit_Runs; use Unit_Runs;

procedure Vision_C_Tests is

   subtype Octet is unsigned_char;

   type Octets is array (int range <>) of aliased Octet;

   type Coordinates is array (Positive range <>) of int;

   Empty_Slot : constant int := 5;
   --  No test puts an image there

   Buffer : Octets (0 .. 999_999);
   Room   : Robot_Array (0 .. 7);

   function Encoded (Slot, Quality, Capacity : int) return int is
      --  Encodes into Buffer, with success; returns the length
      Length : aliased int := -1;
   begin
      Assert (Encode (Slot, Quality, Buffer'Address, Capacity, Length'Access)
              = Ok, "encode");
      return Length;
   end Encoded;

   type Statuses is array (Positive range <>) of Status;

   procedure Expect_Bad (Got : Statuses; What : String) is
   begin
      for K in Got'Range loop
         Assert (Got (K) = Bad_Argument,
                 What & "," & K'Image & " gives " & Got (K)'Image);
      end loop;
   end Expect_Bad;

   procedure Test_Arguments is
      Count : aliased int := 99;
      Found : aliased Arena;
      Robot : aliased constant Vision_C.Robot := (others => <>);
      Far   : aliased constant Arena :=
        (Corner => (others => (1.0E300, -1.0E300)));
   begin
      for Bad of Coordinates'(6, 7, 255, -6, -7, -255) loop
         Expect_Bad
           ((Grab (Bad),
             Find_Arena (Bad, Found'Access),
             Find_Robots (Bad, Aruco, null, Room'Address, 8, Count'Access),
             Draw_Arena (Bad, Found'Access),
             Draw_Robot (Bad, Robot'Access),
             Encode (Bad, 80, Buffer'Address, 100, Count'Access)),
            "slot" & Bad'Image);
      end loop;

      Count := 99;
      Expect_Bad ((Find_Arena (Empty_Slot, Found'Access),
                   Draw_Arena (Empty_Slot, Found'Access),
                   Find_Robots (Empty_Slot, Triangle, null, Room'Address, 8,
                                Count'Access)), "a slot without image");
      Assert (Count = 0, "no robots counted");
      Expect_Bad
        ((1 => Encode (Empty_Slot, 80, Buffer'Address, 100, Count'Access)),
         "a slot without image, encoded");

      Pictures.Show (Scenes.Default);
      Count := 99;
      Expect_Bad ((Find_Arena (0, null),
                   Find_Robots (0, Aruco, null, Null_Address, 8, Count'Access),
                   Find_Robots (0, Aruco, null, Room'Address, 8, null),
                   Draw_Arena (0, null),
                   Draw_Robot (0, null),
                   Encode (0, 80, Buffer'Address, 100, null),
                   Open_At (Null_Address, 640, 480, 10)), "null");
      Assert (Count = 0, "no place for robots");
      Expect_Bad
        ((Encode (0, 80, Null_Address, 100, Count'Access),
          Find_Robots (0, Aruco, null, Room'Address, 0, Count'Access),
          Find_Robots (0, Aruco, null, Room'Address, -1, Count'Access),
          Find_Robots (0, Aruco, Far'Access, Room'Address, 8, Count'Access),
          Find_Robots (0, No_Such_Marker, null, Room'Address, 8,
                       Count'Access),
          Encode (0, 0, Buffer'Address, 1_000_000, Count'Access),
          Encode (0, 101, Buffer'Address, 1_000_000, Count'Access),
          Encode (0, 80, Buffer'Address, -1, Count'Access),
          Open (To_C (""), 640, 480, 10),
          Open (To_C ("0"), 0, 480, 10),
          Open (To_C ("0"), 8_193, 480, 10),
          Open (To_C ("0"), 640, -1, 10),
          Open (To_C ("0"), 640, 480, 0)), "out of range");
   end Test_Arguments;

   procedure Test_Sizes is

      type Pair is array (1 .. 2) of int;
      type Pairs is array (Positive range <>) of Pair;

      Scene : Scenes.Description :=
        Pictures.Scene_With (0, 9, 30.0, 20.0, 10.0);
      Count : aliased int;
      Found : aliased Arena;
      Robot : aliased constant Vision_C.Robot :=
        (7, (3.0, 3.0), (9.0, 9.0), 0.0);
   begin
      for P of Pairs'((1, 1), (1, 500), (500, 1), (2, 2), (15, 15), (16, 16),
                      (17, 33), (4_096, 16), (16, 2_160), (4_096, 2_160))
      loop
         Pictures.Show_Plain (P (1), P (2), 90);
         Assert (Find_Arena (0, Found'Access) = Not_Found, "no arena");
         for Kind in Marker loop
            Assert (Find_Robots (0, Kind, null, Room'Address, 8,
                                 Count'Access) = Not_Found, "no robot");
            Found.Corner := ((0.0, 0.0), (double (P (1)), 0.0),
                             (double (P (1)), double (P (2))),
                             (0.0, double (P (2))));
            Assert (Find_Robots (0, Kind, Found'Access, Room'Address, 8,
                                 Count'Access) = Not_Found,
                    "no robot in an arena");
         end loop;
         Assert (Draw_Arena (0, Found'Access) = Ok, "draw arena");
         Assert (Draw_Robot (0, Robot'Access) = Ok, "draw robot");
         Assert (Encoded (0, 50, Buffer'Length) > 100, "encode");
      end loop;

      --  A size that changes from image to image

      for Round in int range 1 .. 6 loop
         Scene.Width  := (if Round mod 2 = 0 then 640 else 320 * Round);
         Scene.Height := Scene.Width * 3 / 4;
         Pictures.Show (Scene);
         Assert (Find_Arena (0, Found'Access) = Ok, "arena");
         Assert (Find_Robots (0, Aruco, Found'Access, Room'Address, 8,
                              Count'Access) = Ok and then Count = 1, "robot");
      end loop;
   end Test_Sizes;

   procedure Test_Memory_Apart is

      --  A hole in the heap that the image would fit into, as OpenCV's
      --  outlines leave them; and how much of the heap is in use then
      type Heap_Facts is array (1 .. 10) of size_t with Convention => C;
      In_Use : constant := 8;

      type Heap_Account is record
         Fact : Heap_Facts;
      end record
      with Convention => C;

      function Account return Heap_Account
      with Import, Convention => C, External_Name => "mallinfo2";

      function Allocate (Bytes : size_t) return System.Address
      with Import, Convention => C, External_Name => "malloc";

      procedure Free (Block : System.Address)
      with Import, Convention => C, External_Name => "free";

      Image : constant size_t := 640 * 480 * 3;
      Piece : constant size_t := 64 * 1_024;
      Block : array (1 .. 3 * Image / Piece) of System.Address;
      Rim   : System.Address;
      Used  : size_t;
   begin
      Assert (Open (To_C ("no such file"), 640, 480, 10) = No_Camera, "open");
      Pictures.Show_Plain (16, 16, 90);
      for Next of Block loop
         Next := Allocate (Piece);
      end loop;
      Rim := Allocate (Piece);
      for Next of Block loop
         Free (Next);
      end loop;
      Used := Account.Fact (In_Use);
      Pictures.Show_Plain (640, 480, 90);
      Assert (Account.Fact (In_Use) < Used + Piece, "an image in the heap");
      Free (Rim);
   end Test_Memory_Apart;

   procedure Test_Draw is
      Plain, With_Arena : int;
      Found             : aliased constant Arena :=
        (Corner => ((20.0, 20.0), (300.5, 20.0), (300.0, 200.0),
                    (20.0, 200.0)));
      Robot             : aliased constant Vision_C.Robot :=
        (999, (150.0, 100.0), (170.0, 110.0), 0.0);
      Around            : aliased Arena :=
        (Corner => ((-9.0E5, -9.0E5), (9.0E5, -9.0E5), (9.0E5, 9.0E5),
                    (-9.0E5, 9.0E5)));
      Beside            : aliased Vision_C.Robot :=
        (0, (-5.0E5, 3.0), (-5.0E5, 30.0), 0.0);
   begin
      Pictures.Show_Plain (320, 240, 90);
      Plain := Encoded (0, 90, Buffer'Length);
      Assert (Draw_Arena (0, Found'Access) = Ok, "draw arena");
      With_Arena := Encoded (0, 90, Buffer'Length);
      Assert (With_Arena > Plain, "the arena shows");
      Assert (Draw_Robot (0, Robot'Access) = Ok, "draw robot");
      Assert (Encoded (0, 90, Buffer'Length) > With_Arena, "the robot shows");

      --  Out of sight, and absurd ones

      Assert (Draw_Arena (0, Around'Access) = Ok, "arena around the image");
      Assert (Draw_Robot (0, Beside'Access) = Ok, "robot beside it");
      Around.Corner (2).Y := 1.0E7;
      Beside.Centre.X := 1.0E300;
      Expect_Bad
        ((Draw_Arena (0, Around'Access), Draw_Robot (0, Beside'Access)),
         "absurd arena, absurd centre");
      Beside := (0, (3.0, 3.0), (3.0, -1.0E300), 0.0);
      Expect_Bad ((1 => Draw_Robot (0, Beside'Access)), "absurd direction");
   end Test_Draw;

   procedure Test_Label is

      Levels : constant Octets := (0, 60, 128, 200, 255);
      Reach  : constant := 14;
      --  from the marker's middle to its sides

      procedure Check_At (Width, Height, X, Y, Id : int; Count : out Natural)
      is
         --  Letters are what is light over every background, their plate what
         --  is dark. Count: pixels of the letters
         type Picture is array (0 .. Height - 1, 0 .. Width - 1) of Octet
         with Convention => C;
         type Marks is array (0 .. Height - 1, 0 .. Width - 1) of Boolean
         with Pack;

         Where  : constant String :=
           Width'Image & " x" & Height'Image & ":" & Id'Image & " at"
           & X'Image & Y'Image;
         Robot  : aliased constant Vision_C.Robot :=
           (Id, (double (X), double (Y)),
            (double (X), double (Y - Reach)), 0.0);
         Strip  : constant int := Reach - 3;
         --  to both sides of the arrow, which shows upwards
         Shown  : Picture;
         Light  : Marks := (others => (others => True));
         Dark   : Marks := (others => (others => True));
         Left   : int := Width;
         Right  : int := -1;
         Top    : int := Height;
         Bottom : int := -1;
      begin
         for Level of Levels loop
            Pictures.Show_Plain (Width, Height, Level);
            Assert (Draw_Robot (0, Robot'Access) = Ok, "draw robot");
            Assert
              (Scenes.Decode_Grey
                 (Buffer'Address, Encoded (0, 80, Buffer'Length),
                  Width, Height, Shown'Address) = 0, "decode");
            for Row in Shown'Range (1) loop
               for Column in Shown'Range (2) loop
                  Light (Row, Column) := Light (Row, Column)
                    and then Shown (Row, Column) > 150;
                  Dark (Row, Column) := Dark (Row, Column)
                    and then Shown (Row, Column) < 60;
               end loop;
            end loop;
         end loop;
         Count := 0;
         for Row in Shown'Range (1) loop
            for Column in Shown'Range (2) loop
               if Light (Row, Column) and then abs (Column - X) > Strip then
                  Count := Count + 1;
                  Left := int'Min (Left, Column);
                  Right := int'Max (Right, Column);
                  Top := int'Min (Top, Row);
                  Bottom := int'Max (Bottom, Row);
               end if;
            end loop;
         end loop;
         Assert (Bottom - Top + 1 >= 11, "too small, " & Where);
         Assert (Bottom - Top < Height / 8, "too large, " & Where);
         Assert (int (Count) * 15 > (Bottom - Top + 1) * (Right - Left + 1),
                 "too thin, " & Where);
         Assert (Left >= 2 and then Right < Width - 2 and then Top >= 2
                 and then Bottom < Height - 2, "cut by the rim, " & Where);
         Assert ((for all Row in Top - 2 .. Bottom + 2 =>
                    Dark (Row, Left - 2) and then Dark (Row, Right + 2)),
                 "no plate to the sides, " & Where);
         Assert ((for all Column in Left - 2 .. Right + 2 =>
                    Dark (Top - 2, Column)
                    and then Dark (Bottom + 2, Column)),
                 "no plate above and below, " & Where);
         Assert (Left > X + Reach or else Right < X - Reach
                 or else Top > Y + Reach or else Bottom < Y - Reach,
                 "over the marker, " & Where);
      end Check_At;

      procedure Check_Size (Width, Height : int) is
         One, Three : Natural;
      begin
         for X of Coordinates'(3, Width / 2, Width - 4) loop
            for Y of Coordinates'(3, Height / 2, Height - 4) loop
               Check_At (Width, Height, X, Y, 7, One);
               Check_At (Width, Height, X, Y, 888, Three);
               Assert (Three > 3 * One, "888 looks like 7");
            end loop;
         end loop;
      end Check_Size;
   begin
      Check_Size (320, 240);
      Check_Size (640, 480);
      Check_Size (1_920, 1_080);
   end Test_Label;

   procedure Test_Encode is
      Low, High : int;
      Length    : aliased int := 77;
   begin
      Pictures.Show (Scenes.Default);
      Low := Encoded (0, 1, Buffer'Length);
      Buffer := (others => 16#A5#);
      High := Encoded (0, 100, Buffer'Length);
      Assert (Low < High, "quality counts");
      Assert (Buffer (0) = 16#FF# and then Buffer (1) = 16#D8#, "begins");
      Assert (Buffer (High - 2) = 16#FF# and then Buffer (High - 1) = 16#D9#,
              "ends");
      Assert ((for all K in High .. Buffer'Last => Buffer (K) = 16#A5#),
              "nothing written behind the end");
      Assert (Encoded (0, 100, High) = High, "fits exactly");
      Buffer := (others => 16#A5#);
      for Capacity of Coordinates'(0, 1, 100, High - 1) loop
         Assert (Encode (0, 100, Buffer'Address, Capacity, Length'Access)
                 = Too_Small and then Length = 0,
                 "too small:" & Capacity'Image);
      end loop;
      Assert ((for all K in High - 1 .. Buffer'Last => Buffer (K) = 16#A5#),
              "nothing written outside");
   end Test_Encode;

   procedure Test_Page is
      --  Each identifier of the dictionary is read on the page printed for it
      Path   : constant String := Pictures.Temporary ("page.svg");
      Robots : Robot_Array (0 .. 63);
      Count  : aliased int;

      function Print (First, Side : int) return Status is
         File   : constant GNAT.OS_Lib.File_Descriptor :=
           GNAT.OS_Lib.Create_File (Path, GNAT.OS_Lib.Binary);
         Result : constant Status := Print_Markers (int (File), First, Side);
      begin
         GNAT.OS_Lib.Close (File);
         return Result;
      end Print;

      procedure Expect_Page (First, Side, Most, Scale : int) is
         Expected : constant int := int'Min (Most, 1_000 - First);
      begin
         Assert (Print (First, Side) = Ok, "the page");
         Pictures.Show_Page (Path, Scale);
         Assert (Find_Robots (0, Aruco, null, Robots'Address, Robots'Length,
                              Count'Access) = Ok
                   and then Count = Expected,
                 "found" & Count'Image & " of" & Expected'Image & " from"
                 & First'Image);
         for K in 0 .. Count - 1 loop
            Assert (Robots (K).Id = First + K, "not" & int'Image (First + K));
            Assert (abs (Robots (K).Angle - 90.0) < 0.5, "not upright");
         end loop;
      end Expect_Page;
   begin
      for Page in int range 0 .. 20 loop
         Expect_Page (Page * 48, 20, 48, 5);
      end loop;
      Expect_Page (0, 60, 6, 3);
      Expect_Page (995, 60, 6, 3);
      Expect_Page (7, 140, 1, 3);
      Pictures.Remove (Path);
      Assert (Print_Markers (-1, 0, 60) = Failed, "no file");
      Expect_Bad ((Print_Markers (-1, 1_000, 60), Print_Markers (-1, 0, 141)),
                  "identifier, size");
   end Test_Page;

   procedure Test_Texts is

      function Length (Item : System.Address) return size_t
      with Import, Convention => C, External_Name => "strlen";
   begin
      Assert (Open (To_C ("/no/such/file"), 64, 48, 10) = No_Camera, "open");
      Assert (Reason /= Null_Address and then Length (Reason) > 10, "reason");
      Assert (Open (To_C ("/no/such/" & String'(1 .. 900 => 'x')), 64, 48, 10)
              = No_Camera and then Length (Reason) < 160,
              "a long reason is cut");
   end Test_Texts;

begin
   Run_Test ("bad arguments", Test_Arguments'Access);
   Run_Test ("unusual sizes, and a size that changes", Test_Sizes'Access);
   Run_Test ("an image is not in the heap", Test_Memory_Apart'Access);
   Run_Test ("drawings show, or are out of sight", Test_Draw'Access);
   Run_Test ("an identifier can be read over anything", Test_Label'Access);
   Run_Test ("JPEG, its quality, a buffer too small", Test_Encode'Access);
   Run_Test ("markers are read on the page that is printed", Test_Page'Access);
   Run_Test ("the reason", Test_Texts'Access);
end Vision_C_Tests;
