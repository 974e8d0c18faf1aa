--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long each stage of an image's way takes, from the camera's bytes to
--  those on the socket, and each kind of search; beside the floors.

with Ada.Real_Time;    use Ada.Real_Time;

with Interfaces.C;     use Interfaces.C;
with System;

with Base64;
with Expectations;     use Expectations;
with Image_Buffers;    use Image_Buffers;
with Option_Readers;
with Options;
with Plain_Numbers;    use Plain_Numbers;
with Programs;
with Reports;
with Samples;
with Scenes;
with Vision.Following;
with Vision.Library;   use Vision.Library;
with Vision; use Vision;

procedure Image_Times is

   function C_Load
     (Slot : int; Bgr : System.Address; Width, Height : int) return int
   with Import, Convention => C, External_Name => "vision_load";

   function C_Load_Jpeg
     (Slot : int; Jpeg : System.Address; Length, Width, Height : int)
      return int
   with Import, Convention => C, External_Name => "vision_load_jpeg";

   function Decode (Slot : int) return int
   with Import, Convention => C, External_Name => "image_decode";

   function Floor_Encode (Slot, Quality : int) return int
   with Import, Convention => C, External_Name => "image_floor_encode";

   function Connect return int
   with Import, Convention => C, External_Name => "image_connect";

   procedure Send (Socket : int; Data : System.Address; Length : int)
   with Import, Convention => C, External_Name => "image_send";

   Number : Positive := 200;
   --  of images
   Most : constant := 100_000;

   procedure Report
     (Name   : String;
      Item   : in out Samples.Set;
      Floor  : in out Samples.Set;
      Wanted : Reports.Goals := Reports.No_Goals)
   is
      --  Floor may be empty; both are afterwards
   begin
      if Floor.Count > 0 then
         Reports.Compare (Name, Item, Floor, Wanted);
      else
         Reports.Put (Name, Item, Wanted);
      end if;
      Item.Clear;
      Floor.Clear;
   end Report;

   Began : Time;

   procedure Start is
   begin
      Began := Clock;
   end Start;

   procedure Stop (S : in out Samples.Set) is
      --  The time since Start is one more figure; Start again
      Now : constant Time := Clock;
   begin
      S.Add (To_Duration (Now - Began));
      Began := Clock;
   end Stop;

   --  The images

   Taken : Natural;
   --  Bytes of the camera's image

   Quality : constant := 80;
   --  The supervisor's own default, and the camera's

   Markers : constant array (1 .. 4) of Scenes.Robot :=
     ((0, 17, 30.3, 28.1, 33.0), (0, 29, 61.0, 44.2, 120.0),
      (0, 3, 15.7, 50.0, 200.0), (0, 500, 66.1, 12.4, 290.0));

   function Scene (Width, Height : Positive; Robots : Natural; K : Natural)
     return Scenes.Description is
      --  The robots have moved on a little from image to image, 10 cm/s
   begin
      return Item : Scenes.Description := Scenes.Default do
         Item.Width := int (Width);
         Item.Height := int (Height);
         Item.Noise := 3.0;
         Item.Seed := unsigned (K + 1);
         Item.Robots := int (Robots);
         for R in 1 .. Robots loop
            Item.Robot (R - 1) := Markers (R);
            Item.Robot (R - 1).X := Markers (R).X
              + double (if K mod 14 < 7 then K mod 14 else 14 - K mod 14);
            Item.Robot (R - 1).Heading :=
              Markers (R).Heading + 5.0 * double (K);
         end loop;
      end return;
   end Scene;

   procedure Draw (Item : Scenes.Description) is
      --  Onto the canvas
   begin
      Check (Scenes.Draw (Item, Canvas'Address) = 0, "drawing");
   end Draw;

   procedure Show (Width, Height : Positive) is
      --  The canvas in slot 0
   begin
      Check (C_Load (0, Canvas'Address, int (Width), int (Height)) = 0,
             "loading");
   end Show;

   --  The stages

   Wire : constant int := Connect;

   type Stage is (Passing, Arena_Search, Encoding, To_Text, Sending, Whole);

   Times, Floors : array (Stage) of Samples.Set;

   procedure Measure_Stages (Width, Height : Positive) is
      Size   : constant String := Image (Width) & "x" & Image (Height);
      Arena  : Arena_Corners;
      Result : Status;
      Length : Natural;
      Last   : Natural;

      procedure Encode_Floor is
      begin
         Check (Floor_Encode (0, Quality) > 0, "encoding");
         Start;
         Check (Floor_Encode (0, Quality) > 0, "encoding");
         Stop (Floors (Whole));
      end Encode_Floor;

   begin
      for K in 1 .. Number loop
         Taken := Natural
           (Scenes.Jpeg (Scene (Width, Height, 1, K mod 20), Quality,
                         Source'Address, Source'Length));

         --  The camera's bytes, checked, kept and passed on
         Start;
         Check (C_Load_Jpeg (0, Source'Address, int (Taken), int (Width),
                             int (Height)) = 0, "the camera's JPEG");
         Encode (0, Quality, Jpeg, Length, Result);
         Stop (Times (Passing));
         Check (Result = Done and then Length = Taken, "passed on");

         Check (Decode (0) = 0, "decoding");
         Start;
         Find_Arena (0, Arena, Result);
         Stop (Times (Arena_Search));
         Check (Result = Done, "arena");
         Draw_Arena (0, Arena, Result);
         --  from now on the camera's bytes are another image's

         --  Encoded and sent, the floor first or second in turn
         if K mod 2 = 0 then
            Encode_Floor;
         end if;
         Start;
         Encode (0, Quality, Jpeg, Length, Result);
         Stop (Times (Encoding));
         Check (Result = Done, "encoding");
         Base64.Encode (Jpeg, Length, Text, 6, Last);
         Stop (Times (To_Text));
         Send (Wire, Text'Address, int (Last));
         Stop (Times (Sending));
         Times (Whole).Add
           (Times (Encoding).Last + Times (To_Text).Last
            + Times (Sending).Last);
         if K mod 2 = 1 then
            Encode_Floor;
         end if;
      end loop;

      Report (Size & " camera's JPEG passed through",
              Times (Passing), Floors (Passing),
              (1 => (Reports.Median, 100.0, False)));
      Report (Size & " arena", Times (Arena_Search), Floors (Arena_Search));
      Report (Size & " encode", Times (Encoding), Floors (Encoding));
      Report (Size & " base64", Times (To_Text), Floors (To_Text));
      Report (Size & " send", Times (Sending), Floors (Sending));
      Report (Size & " encode + base64 + send", Times (Whole), Floors (Whole),
              (1 => (Reports.Median_Ratio, 1.15, False)));
   end Measure_Stages;

   procedure Measure_Searches
     (Width, Height : Positive; Robots : Natural; Prefix : String)
   is
      Name    : constant String :=
        Image (Width) & "x" & Image (Height) & " " & Prefix;
      Full    : Samples.Set renames Times (Whole);
      Inside  : Samples.Set renames Times (Passing);
      Follow  : Samples.Set renames Times (Encoding);
      Plain   : Samples.Set renames Floors (Whole);
      Copy    : Samples.Set renames Floors (Passing);
      Arena   : Arena_Corners;
      Found   : Robot_Array;
      Count   : Robot_Count;
      Areas   : Area_Array;
      Parts   : Robot_Count;
      Known   : Vision.Following.State;
      Settled : Boolean;
      Result  : Status;

      --  Each search has some images in a row, as the supervisor would make
      --  it: the caches hold what it needs, not what another one left
      Row : constant := 10;
      type Search is (In_Arena, By_Following, In_Whole);

      procedure Everywhere (Where : Search) is
      begin
         Start;
         Find_Robots (0, Options.Aruco, Arena, Where = In_Arena, Found,
                      Count, Result);
         case Where is
            when In_Arena     => Stop (Inside);
            when By_Following => null;  --  none is followed yet
            when In_Whole     => Stop (Full);
         end case;
         Check (Count = Robots, "robots");
      end Everywhere;

      procedure Follow_On is
      begin
         Vision.Following.Plan (Known, Options.Aruco, 100, Areas, Parts);
         Settled := False;
         if Parts > 0 then
            Start;
            Find_Robots (0, Options.Aruco, No_Arena, False, Found, Count,
           Result, Areas, Parts);
            Stop (Follow);
            Check (Result in Done | Not_Found, "following");
            Vision.Following.Settle (Known, 100, Found, Count, Settled);
            if not Settled then
               Follow.Delete_Last;
            end if;
         end if;
         if not Settled then
            Everywhere (By_Following);
            Vision.Following.Begin_Anew (Known, Found, Count);
         end if;
      end Follow_On;

   begin
      Draw (Scene (Width, Height, Robots, 0));
      Show (Width, Height);
      Find_Arena (0, Arena, Result);
      Check (Result = Done, "arena");
      for First in 0 .. (Number - 1) / Row loop
         for Where in Search loop
            for K in First * Row + 1
              .. Positive'Min (Number, (First + 1) * Row)
            loop
               Draw (Scene (Width, Height, Robots, K));
               Show (Width, Height);
               if Where = By_Following then
                  Follow_On;
               else
                  Everywhere (Where);
               end if;
            end loop;
         end loop;
      end loop;
      Plain := Full;
      Copy := Full;
      Report (Name & "in the arena", Inside, Copy);
      if Follow.Count > 0 then
         Report (Name & "following", Follow, Plain,
                 (if Prefix = "search: "
                  then (1 => (Reports.Median_Ratio, 0.2, False))
                  else Reports.No_Goals));
      end if;
      Plain.Clear;
      Report (Name & "whole image", Full, Plain);
   end Measure_Searches;

   Widths  : constant array (1 .. 4) of Positive := (320, 640, 1_280, 1_920);
   Heights : constant array (1 .. 4) of Positive := (240, 480, 720, 1_080);
   Usage   : constant String :=
     "usage: image_times images|search --out FOLDER [--samples N]";
   Search  : Boolean := False;

begin
   while Option_Readers.Next loop
      if Option_Readers.Name = "--samples" then
         Number := Option_Readers.Number (10, Most);
      elsif Option_Readers.Name = "--out" then
         Reports.Open (Option_Readers.Value);
      elsif Option_Readers.Name in "images" | "search" then
         Search := Option_Readers.Name = "search";
      else
         Programs.Read_Option (Usage);
      end if;
   end loop;

   if Search then
      Reports.Begin_Section ("search", "robots and arena in an image");
      for Size in Widths'Range loop
         Measure_Searches (Widths (Size), Heights (Size), 1, "search: ");
      end loop;
      for Robots in 0 .. 4 loop
         Measure_Searches (640, 480, Robots, Image (Robots) & " in view: ");
      end loop;
      Reports.Put_Note ("floor: the whole image");
   else
      Reports.Begin_Section
        ("images", "an image's way, from the camera to the socket");
      for Size in Widths'Range loop
         Measure_Stages (Widths (Size), Heights (Size));
      end loop;
      Reports.Put_Note ("floor of the sum: libjpeg-turbo alone");
   end if;
   Reports.End_Section;

exception
   when Problem : others =>
      Programs.Give_Up (Problem);
end Image_Times;
