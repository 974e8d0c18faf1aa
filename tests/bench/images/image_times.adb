--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long each kind of search takes, of robots beside that in the whole
--  image. The argument is the number of images of each kind.

with Ada.Command_Line;
with Ada.Real_Time;    use Ada.Real_Time;

with Interfaces.C;     use Interfaces.C;
with System;

with Expectations;     use Expectations;
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

   procedure Slot_Load (Slot : int; Bgr : System.Address; Width, Height : int)
   with Import, Convention => C, External_Name => "slot_load";

   Number : constant Positive :=
     Positive'Value (Ada.Command_Line.Argument (1));
   --  of images

   Began : Time;
   --  of what is measured

   procedure Stop (S : in out Samples.Set) is
      --  The time since Began is one more figure
   begin
      S.Add (To_Duration (Clock - Began));
   end Stop;

   type Pixels is array (1 .. 1_920 * 1_080 * 3) of unsigned_char;
   type Pixels_Access is access Pixels;
   Canvas : constant Pixels_Access := new Pixels;

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

   procedure Show (Item : Scenes.Description) is
      --  In slot 0
   begin
      Check (Scenes.Draw (Item, Canvas.all'Address) = 0, "drawing");
      Slot_Load (0, Canvas.all'Address, Item.Width, Item.Height);
   end Show;

   procedure Measure_Searches
     (Width, Height : Positive; Robots : Natural; Prefix : String)
   is
      Size    : constant String := Image (Width) & "x" & Image (Height);
      Name    : constant String := Size & " " & Prefix;
      Full    : Samples.Set;
      Inside  : Samples.Set;
      Follow  : Samples.Set;
      Around  : Samples.Set;
      Arena   : Arena_Corners;
      Found   : Robot_Array;
      Count   : Robot_Count;
      Areas   : Area_Array;
      Parts   : Robot_Count;
      Known   : Vision.Following.State;
      Settled : Boolean;
      Taken   : Duration;
      Result  : Status;

      --  Each search has some images in a row, as the supervisor would make
      --  it: the caches hold what it needs, not what another one left
      Row : constant := 10;
      type Search is (In_Arena, By_Following, In_Whole);

      procedure Everywhere (Where : Search) is
      begin
         Began := Clock;
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
            Began := Clock;
            Find_Robots (0, Options.Aruco, No_Arena, False, Found, Count,
                         Result, Areas, Parts);
            Taken := To_Duration (Clock - Began);
            Check (Result in Done | Not_Found, "following");
            Vision.Following.Settle (Known, 100, Found, Count, Settled);
            if Settled then
               Follow.Add (Taken);
            end if;
         end if;
         if not Settled then
            Everywhere (By_Following);
            Vision.Following.Begin_Anew (Known, Found, Count);
         end if;
      end Follow_On;

   begin
      for K in 1 .. Number loop
         Show (Scene (Width, Height, Robots, K mod 20));
         Began := Clock;
         Find_Arena (0, Arena, Result);
         Stop (Around);
         Check (Result = Done, "arena");
      end loop;
      for First in 0 .. (Number - 1) / Row loop
         for Where in Search loop
            for K in First * Row + 1
              .. Positive'Min (Number, (First + 1) * Row)
            loop
               Show (Scene (Width, Height, Robots, K));
               if Where = By_Following then
                  Follow_On;
               else
                  Everywhere (Where);
               end if;
            end loop;
         end loop;
      end loop;
      if Prefix = "search: " then
         Reports.Put (Name & "in the arena", Inside, Full);
      end if;
      Reports.Put (Name & "following", Follow, Full);
      Reports.Put (Name & "whole image", Full);
      if Prefix = "search: " then
         Reports.Put (Size & " arena", Around);
      end if;
   end Measure_Searches;

   Widths  : constant array (1 .. 4) of Positive := (320, 640, 1_280, 1_920);
   Heights : constant array (1 .. 4) of Positive := (240, 480, 720, 1_080);

begin
   Reports.Begin_Section ("search", "robots and arena in an image");
   for Size in Widths'Range loop
      Measure_Searches (Widths (Size), Heights (Size), 1, "search: ");
   end loop;
   for Robots in 1 .. 4 loop
      Measure_Searches (640, 480, Robots, Image (Robots) & " in view: ");
   end loop;
   Reports.Put_Note ("floor: the whole image");

exception
   when Problem : others =>
      Programs.Give_Up (Problem);
end Image_Times;
