--  SPDX-License-Identifier: GPL-3.0-or-later
--  The search for the arena: under every disturbance, and where is none. What
--  depends on the width of its border, its contrast and its size, the rows of
--  tests/vision show.

with Ada.Numerics.Long_Elementary_Functions;
use Ada.Numerics.Long_Elementary_Functions;

with Interfaces.C; use Interfaces.C;

with Pictures; use Pictures;
with Scenes;
with Vision_C; use Vision_C;
with Unit_Runs; use Unit_Runs;

procedure Vision_Arena_Tests is

   Tolerance : constant := 2.0;
   --  Pixels, of every corner

   type Ratios is array (Positive range <>) of double;

   procedure Check_Found
     (Scene    : Scenes.Description;
      What     : String;
      Quarters : Natural  := 0;
      Seed     : unsigned := Scenes.Default.Seed)
   is
      --  The arena is found, each corner where it is; Quarters turns clockwise
      --  the field's own top left corner comes before that of the image
      Seeded : Scenes.Description := Scene;
      Found  : aliased Arena;
      Truth  : Scenes.Corner_Coordinates;
      Place  : Natural;
      Off    : Long_Float;
   begin
      Seeded.Seed := Seed;
      Pictures.Show (Seeded);
      Assert (Scenes.Arena_Truth (Seeded, Truth) = 0, "truth");
      Assert (Find_Arena (0, Found'Access) = Ok, What & ": found");
      for K in Found.Corner'Range loop
         Place := 2 * ((K + Quarters) mod 4);
         Off := Sqrt
           (Long_Float ((Found.Corner (K).X - Truth (Place)) ** 2
                        + (Found.Corner (K).Y - Truth (Place + 1)) ** 2));
         Assert (Off < Tolerance,
                 What & ": corner" & K'Image & " is off by" & Off'Image);
      end loop;
   end Check_Found;

   procedure Check_None (What : String) is
      --  There is no arena in slot 0
      Found : aliased Arena;
   begin
      Assert (Find_Arena (0, Found'Access) = Not_Found, What & ": none");
   end Check_None;

   procedure Test_Disturbed is
   begin
      Check_Found (Scenes.Default, "plain");
      for K in 1 .. 10 loop
         Check_Found (Disturbed (Noise => 15.0), "noise" & K'Image,
                      Seed => unsigned (K));
      end loop;
      for K in 1 .. 3 loop
         Check_Found (Disturbed (Blur => double (K)), "blur" & K'Image);
      end loop;
      for K in 1 .. 6 loop
         Check_Found (Disturbed (Uneven => double (K) / 10.0),
                      "light lost" & K'Image);
      end loop;
      for K in -10 .. 10 loop
         Check_Found (Disturbed (Turn => double (K)), "turned by" & K'Image);
         if K mod 2 = 0 then
            Check_Found (Disturbed (double (K), 15.0, 2.0, 0.5),
                         "all at once, turned by" & K'Image,
                         Seed => unsigned (10 + K / 2));
         end if;
      end loop;
   end Test_Disturbed;

   procedure Test_Upright is
      Scene : Scenes.Description := Scenes.Default;
   begin
      Scene.Fill := 0.6;
      for Quarter in -1 .. 1 loop
         for Step in -3 .. 3 loop
            Scene.Turn := double (90 * Quarter + 10 * Step);
            Check_Found (Scene, "turned by" & Scene.Turn'Image,
                         Quarters => (-Quarter) mod 4);
         end loop;
      end loop;
   end Test_Upright;

   procedure Test_Resolutions is
      Scene : Scenes.Description :=
        Disturbed (Turn => 4.0, Noise => 5.0, Blur => 1.0, Uneven => 0.3);
      type Pair is array (1 .. 2) of int;
      type Pairs is array (Positive range <>) of Pair;
   begin
      for P of Pairs'((320, 240), (800, 600), (1_280, 720), (1_920, 1_080),
                      (480, 640))
      loop
         Scene.Width := P (1);
         Scene.Height := P (2);
         Check_Found (Scene, P (1)'Image & " x" & P (2)'Image);
      end loop;
   end Test_Resolutions;

   procedure Test_Robots_Inside is
      Scene : Scenes.Description := Disturbed (Noise => 4.0);
   begin
      for Count in int range 1 .. 4 loop
         Scene.Robots := Count;
         for Marker in int range 0 .. 1 loop
            Scene.Robot :=
              ((Marker, 3, 20.0, 20.0, 40.0), (Marker, 4, 60.0, 40.0, 200.0),
               (Marker, 5, 40.0, 30.0, 0.0), (Marker, 6, 65.0, 12.0, 90.0));
            Check_Found (Scene, Count'Image & " robots");
         end loop;
      end loop;
   end Test_Robots_Inside;

   procedure Test_Robots_At_Border is
      Scene : Scenes.Description;
      Along : double;
   begin
      for Hard in Boolean loop
         Scene := (if Hard then Disturbed (8.0, 15.0, 2.0, 0.5)
                   else Disturbed (Noise => 4.0));
         Scene.Robots := 2;
         for Marker in int range 0 .. 1 loop
            for Step in 0 .. 8 loop
               Along := 10.0 * double (Step);
               Scene.Robot (0) := (Marker, 3, Along, 0.0, 15.0);
               Scene.Robot (1) := (Marker, 4, 80.0 - Along, 60.0, 100.0);
               Check_Found (Scene, "bottom and top" & Step'Image);
               Along := 7.5 * double (Step);
               Scene.Robot (0) := (Marker, 3, 0.0, Along, 0.0);
               Scene.Robot (1) := (Marker, 4, 80.0, 60.0 - Along, 45.0);
               Check_Found (Scene, "left and right" & Step'Image);
            end loop;
         end loop;
      end loop;
   end Test_Robots_At_Border;

   procedure Test_Floor is
   begin
      for Noise in 0 .. 6 loop
         Pictures.Show (Disturbed (Noise  => 5.0 * double (Noise),
                                   Uneven => 0.4,
                                   Arena  => 0));
         Check_None ("floor, noise" & Noise'Image);
      end loop;
      for Level in 0 .. 2 loop
         Pictures.Show_Plain (640, 480, Pictures.Grey (127 * Level));
         Check_None ("one level");
      end loop;
   end Test_Floor;

   procedure Test_Noise_Alone is
      Scene : Scenes.Description := Disturbed (Noise => 30.0, Arena => 0);
   begin
      for Seed in unsigned range 1 .. 5 loop
         Scene.Seed := Seed;
         Pictures.Show_Frame (Scene, 900.0, 900.0, 0.0, 120);
         Check_None ("plain");
         Pictures.Show (Scene);
         Check_None ("noise");
      end loop;
   end Test_Noise_Alone;

   procedure Test_Paper is
      procedure Check
        (Width, Height, Turn : double; Level : Pictures.Grey; What : String) is
      begin
         Pictures.Show_Frame (Disturbed (Noise => 4.0, Arena => 0),
                              Width, Height, Turn, Level);
         Check_None (What & Level'Image);
      end Check;
   begin
      for Turn in -2 .. 2 loop
         Check (420.0, 297.0, 5.0 * double (Turn), 235, "a sheet of paper");
         Check (480.0, 360.0, 5.0 * double (Turn), 235, "4:3, no border");
         Check (480.0, 360.0, 5.0 * double (Turn), 120, "4:3, no border");
      end loop;
      for Ratio of Ratios'(1.0, 1.15, 1.5, 1.78) loop
         for Turn in -1 .. 1 loop
            Pictures.Show_Frame (Disturbed (Noise => 2.0, Arena => 0),
                                 300.0 * Ratio, 300.0,
                                 6.0 * double (Turn), 120, 12.0, 235);
            Check_None ("a frame of" & Ratio'Image & " to 1");
         end loop;
      end loop;
   end Test_Paper;

   procedure Test_Robots_Alone is
      Scene : Scenes.Description := Disturbed (Noise => 4.0, Arena => 0);
   begin
      for Marker in int range 0 .. 1 loop
         for Count in int range 1 .. 4 loop
            Scene.Robots := Count;
            Scene.Robot :=
              ((Marker, 3, 20.0, 20.0, 0.0), (Marker, 4, 60.0, 40.0, 0.0),
               (Marker, 5, 60.0, 20.0, 0.0), (Marker, 6, 20.0, 40.0, 0.0));
            Pictures.Show (Scene);
            Check_None (Count'Image & " robots");
         end loop;
      end loop;
   end Test_Robots_Alone;

begin
   Run_Test ("turned, noise, blur, uneven light", Test_Disturbed'Access);
   Run_Test ("upright, rolled", Test_Upright'Access);
   Run_Test ("resolutions", Test_Resolutions'Access);
   Run_Test ("robots inside", Test_Robots_Inside'Access);
   Run_Test ("robots on the border", Test_Robots_At_Border'Access);
   Run_Test ("none: the floor, one level", Test_Floor'Access);
   Run_Test ("none: noise", Test_Noise_Alone'Access);
   Run_Test ("none: sheets, other frames", Test_Paper'Access);
   Run_Test ("none: robots alone", Test_Robots_Alone'Access);
end Vision_Arena_Tests;
