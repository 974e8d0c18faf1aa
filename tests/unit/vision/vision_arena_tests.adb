--  SPDX-License-Identifier: GPL-3.0-or-later
--  The search for the arena: under every disturbance, and where is none.

with Ada.Numerics.Long_Elementary_Functions;

with Interfaces.C; use Interfaces.C;

with AUnit.Assertions; use AUnit.Assertions;

with Pictures;
with Scenes;
with Vision_C; use Vision_C;

package body Vision_Arena_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Tolerance : constant := 2.0;
   --  Pixels, of every corner

   procedure Check_Found
     (Scene : Scenes.Description; What : String; Quarters : Natural := 0);
   --  The arena is found, each corner where it is; Quarters turns clockwise
   --  the field's own top left corner comes before that of the image

   procedure Check_Frame
     (Width : double; Border : double; Turn : double; What : String;
      Level : Pictures.Grey := 120; Border_Level : Pictures.Grey := 235);
   --  The same of a field that Show_Frame draws

   procedure Check_None (What : String);
   --  There is no arena in slot 0

   function Disturbed
     (Turn, Noise, Blur, Uneven : double := 0.0) return Scenes.Description;

   procedure Test_Plain (T : in out Any_Test);
   procedure Test_Turned (T : in out Any_Test);
   procedure Test_Upright (T : in out Any_Test);
   procedure Test_Borders (T : in out Any_Test);
   procedure Test_Light_Fields (T : in out Any_Test);
   procedure Test_Noise (T : in out Any_Test);
   procedure Test_Blur (T : in out Any_Test);
   procedure Test_Uneven_Light (T : in out Any_Test);
   procedure Test_All_At_Once (T : in out Any_Test);
   procedure Test_Fill (T : in out Any_Test);
   procedure Test_Resolutions (T : in out Any_Test);
   procedure Test_Robots_Inside (T : in out Any_Test);
   procedure Test_Robots_At_Border (T : in out Any_Test);
   procedure Test_Floor (T : in out Any_Test);
   procedure Test_Plain_Image (T : in out Any_Test);
   procedure Test_Noise_Alone (T : in out Any_Test);
   procedure Test_Paper (T : in out Any_Test);
   procedure Test_Robots_Alone (T : in out Any_Test);
   procedure Test_Frames (T : in out Any_Test);

   procedure Check_Found
     (Scene : Scenes.Description; What : String; Quarters : Natural := 0)
   is
      use Ada.Numerics.Long_Elementary_Functions;
      Drawn    : aliased constant Scenes.Description := Scene;
      Found    : aliased Arena;
      Truth    : Scenes.Corner_Coordinates;
      Distance : Long_Float;
   begin
      Pictures.Show (Scene);
      Assert (Scenes.Arena_Truth (Drawn'Access, Truth) = 0, "truth");
      Assert (Find_Arena (0, Found'Access) = Ok, What & ": found");
      for K in 0 .. 3 loop
         declare
            Place : constant Natural := 2 * ((K + Quarters) mod 4);
         begin
            Distance := Sqrt
              (Long_Float ((Found.Corner (K).X - Truth (Place)) ** 2
               + (Found.Corner (K).Y - Truth (Place + 1)) ** 2));
         end;
         Assert (Distance < Tolerance,
                 What & ": corner" & K'Image & " is off by"
                 & Distance'Image);
      end loop;
   end Check_Found;

   procedure Check_Frame
     (Width : double; Border : double; Turn : double; What : String;
      Level : Pictures.Grey := 120; Border_Level : Pictures.Grey := 235)
   is
      use Ada.Numerics.Long_Elementary_Functions;
      Floor : Scenes.Description := Disturbed (Noise => 2.0);
      Found : aliased Arena;
      Side  : constant array (0 .. 3) of double := (-0.5, 0.5, 0.5, -0.5);
      Down  : constant array (0 .. 3) of double := (-0.5, -0.5, 0.5, 0.5);
      Cosine : constant double := double (Cos (Long_Float (Turn), 360.0));
      Sine   : constant double := double (Sin (Long_Float (Turn), 360.0));
      Height : constant double := 0.75 * Width;
      X, Y   : double;
   begin
      Floor.Arena := 0;
      Pictures.Show_Frame
        (Floor, Width, Height, Turn, Level, Border, Border_Level);
      Assert (Find_Arena (0, Found'Access) = Ok, What & ": found");
      for K in 0 .. 3 loop
         X := 320.0 + Side (K) * Width * Cosine - Down (K) * Height * Sine;
         Y := 240.0 + Side (K) * Width * Sine + Down (K) * Height * Cosine;
         Assert (abs (Found.Corner (K).X - X) < Tolerance
                   and then abs (Found.Corner (K).Y - Y) < Tolerance,
                 What & ": corner" & K'Image);
      end loop;
   end Check_Frame;

   procedure Check_None (What : String) is
      Found : aliased Arena;
   begin
      Assert (Find_Arena (0, Found'Access) = Not_Found, What & ": none");
   end Check_None;

   function Disturbed
     (Turn, Noise, Blur, Uneven : double := 0.0) return Scenes.Description
   is
   begin
      return Scene : Scenes.Description := Scenes.Default do
         Scene.Turn := Turn;
         Scene.Noise := Noise;
         Scene.Blur := Blur;
         Scene.Uneven := Uneven;
      end return;
   end Disturbed;

   procedure Test_Plain (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Check_Found (Scenes.Default, "plain");
   end Test_Plain;

   procedure Test_Turned (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Turn in -10 .. 10 loop
         Check_Found (Disturbed (Turn => double (Turn)),
                      "turned by" & Turn'Image);
      end loop;
   end Test_Turned;

   procedure Test_Upright (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description := Scenes.Default;
   begin
      Scene.Fill := 0.6;
      for Step in -3 .. 3 loop
         Scene.Turn := 10.0 * double (Step);
         Check_Found (Scene, "turned by" & Integer'Image (10 * Step));
         Scene.Turn := 90.0 + 10.0 * double (Step);
         Check_Found (Scene, "turned by" & Integer'Image (90 + 10 * Step),
                      Quarters => 3);
         Scene.Turn := -90.0 + 10.0 * double (Step);
         Check_Found (Scene, "turned by" & Integer'Image (-90 + 10 * Step),
                      Quarters => 1);
      end loop;
   end Test_Upright;

   procedure Test_Borders (T : in out Any_Test) is
      pragma Unreferenced (T);
      type Shares is array (Positive range <>) of double;
   begin
      for Share of Shares'(0.005, 0.01, 0.02, 0.03, 0.05, 0.075, 0.1) loop
         for Turn in -1 .. 1 loop
            Check_Frame (480.0, 480.0 * Share, 7.0 * double (Turn),
                         "a border of" & Share'Image & " of the field");
         end loop;
      end loop;
   end Test_Borders;

   procedure Test_Light_Fields (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Level in Pictures.Grey range 16 .. 20 loop
         Check_Frame (400.0, 12.0, 3.0, "level" & Level'Image & "0",
                      Level => 10 * Level, Border_Level => 10 * Level + 20);
      end loop;
   end Test_Light_Fields;

   procedure Test_Noise (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description := Disturbed (Noise => 15.0);
   begin
      for Seed in unsigned range 1 .. 10 loop
         Scene.Seed := Seed;
         Check_Found (Scene, "noise" & Seed'Image);
      end loop;
   end Test_Noise;

   procedure Test_Blur (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Blur in 1 .. 3 loop
         Check_Found (Disturbed (Blur => double (Blur)),
                      "blur" & Blur'Image);
      end loop;
   end Test_Blur;

   procedure Test_Uneven_Light (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Tenths in 1 .. 6 loop
         Check_Found (Disturbed (Uneven => double (Tenths) / 10.0),
                      "light lost" & Tenths'Image);
      end loop;
   end Test_Uneven_Light;

   procedure Test_All_At_Once (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description;
   begin
      for Turn in -5 .. 5 loop
         Scene := Disturbed
           (Turn   => 2.0 * double (Turn), Noise => 15.0, Blur => 2.0,
            Uneven => 0.5);
         Scene.Seed := unsigned (10 + Turn);
         Check_Found (Scene, "turned by" & Integer'Image (2 * Turn));
      end loop;
   end Test_All_At_Once;

   procedure Test_Fill (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description := Disturbed (Noise => 5.0, Blur => 1.0);
   begin
      for Percent in 3 .. 9 loop
         Scene.Fill := double (10 * Percent + 5) / 100.0;
         Check_Found (Scene, "fill" & Percent'Image & "5 %");
      end loop;
   end Test_Fill;

   procedure Test_Resolutions (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Robots_Inside (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Robots_At_Border (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description;
   begin
      for Hard in Boolean loop
         Scene := (if Hard
                   then Disturbed (Turn => 8.0, Noise => 15.0, Blur => 2.0,
                                   Uneven => 0.5)
                   else Disturbed (Noise => 4.0));
         Scene.Robots := 2;
         for Marker in int range 0 .. 1 loop
            for Step in 0 .. 8 loop
               Scene.Robot (0) :=
                 (Marker, 3, double (Step) * 10.0, 0.0, 15.0);
               Scene.Robot (1) :=
                 (Marker, 4, 80.0 - double (Step) * 10.0, 60.0, 100.0);
               Check_Found (Scene, "bottom and top" & Step'Image);
               Scene.Robot (0) := (Marker, 3, 0.0, double (Step) * 7.5, 0.0);
               Scene.Robot (1) :=
                 (Marker, 4, 80.0, 60.0 - double (Step) * 7.5, 45.0);
               Check_Found (Scene, "left and right" & Step'Image);
            end loop;
         end loop;
      end loop;
   end Test_Robots_At_Border;

   procedure Test_Floor (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description;
   begin
      for Noise in 0 .. 6 loop
         Scene := Disturbed (Noise => 5.0 * double (Noise), Uneven => 0.4);
         Scene.Arena := 0;
         Pictures.Show (Scene);
         Check_None ("floor, noise" & Noise'Image);
      end loop;
   end Test_Floor;

   procedure Test_Plain_Image (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Level of char_array'(1 => char'Val (0), 2 => char'Val (120),
                               3 => char'Val (255))
      loop
         Pictures.Show_Plain
           (640, 480, Pictures.Grey (char'Pos (Level)));
         Check_None ("one level");
      end loop;
   end Test_Plain_Image;

   procedure Test_Noise_Alone (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description := Disturbed (Noise => 30.0);
   begin
      Scene.Arena := 0;
      for Seed in unsigned range 1 .. 5 loop
         Scene.Seed := Seed;
         Pictures.Show_Sheet (Scene, 900.0, 900.0, 0.0, 120);
         Check_None ("plain");
         Pictures.Show (Scene);
         Check_None ("noise");
      end loop;
   end Test_Noise_Alone;

   procedure Test_Paper (T : in out Any_Test) is
      pragma Unreferenced (T);
      Floor : Scenes.Description := Disturbed (Noise => 4.0);
   begin
      Floor.Arena := 0;
      for Turn in -2 .. 2 loop
         Pictures.Show_Sheet
           (Floor, 420.0, 297.0, 5.0 * double (Turn), 235);
         Check_None ("a sheet of paper");
         Pictures.Show_Sheet
           (Floor, 480.0, 360.0, 5.0 * double (Turn), 235);
         Check_None ("a white 4:3 rectangle");
         Pictures.Show_Sheet
           (Floor, 480.0, 360.0, 5.0 * double (Turn), 120);
         Check_None ("a grey 4:3 rectangle without border");
      end loop;
   end Test_Paper;

   procedure Test_Robots_Alone (T : in out Any_Test) is
      pragma Unreferenced (T);
      Scene : Scenes.Description := Disturbed (Noise => 4.0);
   begin
      Scene.Arena := 0;
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

   procedure Test_Frames (T : in out Any_Test) is
      pragma Unreferenced (T);
      Floor : Scenes.Description := Disturbed (Noise => 2.0);
      type Ratios is array (Positive range <>) of double;
   begin
      Floor.Arena := 0;
      for Ratio of Ratios'(1.0, 1.15, 1.5, 1.78) loop
         for Turn in -1 .. 1 loop
            Pictures.Show_Frame (Floor, 300.0 * Ratio, 300.0,
                                 6.0 * double (Turn), 120, 12.0, 235);
            Check_None ("a frame of" & Ratio'Image & " to 1");
         end loop;
      end loop;
   end Test_Frames;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("arena"));

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Plain'Access, "a plain scene");
      Register_Routine (T, Test_Turned'Access, "camera turned");
      Register_Routine (T, Test_Upright'Access, "upright, rolled");
      Register_Routine (T, Test_Borders'Access, "borders of any width");
      Register_Routine (T, Test_Light_Fields'Access, "light fields");
      Register_Routine (T, Test_Noise'Access, "noise");
      Register_Routine (T, Test_Blur'Access, "blur");
      Register_Routine (T, Test_Uneven_Light'Access, "uneven light");
      Register_Routine (T, Test_All_At_Once'Access, "all at once");
      Register_Routine (T, Test_Fill'Access, "near and far");
      Register_Routine (T, Test_Resolutions'Access, "resolutions");
      Register_Routine (T, Test_Robots_Inside'Access, "robots inside");
      Register_Routine (T, Test_Robots_At_Border'Access,
                        "robots on the border");
      Register_Routine (T, Test_Floor'Access, "none: the floor");
      Register_Routine (T, Test_Plain_Image'Access, "none: one level");
      Register_Routine (T, Test_Noise_Alone'Access, "none: noise");
      Register_Routine (T, Test_Paper'Access, "none: sheets");
      Register_Routine (T, Test_Robots_Alone'Access, "none: robots alone");
      Register_Routine (T, Test_Frames'Access, "none: other frames");
   end Register_Tests;

end Vision_Arena_Tests;
