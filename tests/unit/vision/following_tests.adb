--  SPDX-License-Identifier: GPL-3.0-or-later
--  Robots that are followed: the same answers as a search everywhere gives.

with Interfaces.C; use Interfaces.C;

with AUnit.Assertions; use AUnit.Assertions;

with Options;        use Options;
with Pictures;
with Scenes;
with Vision.Following;
with Vision.Library; use Vision.Library;
with Vision.Shapes;  use Vision.Shapes;

package body Following_Tests is

   use type Vision.Following.Milliseconds;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Tolerance : constant Micro_Pixels := 20_000;
   --  Between the two: 0.02 pixels, of the 2 that are demanded

   Gap : constant Vision.Following.Milliseconds := 100;

   type Answer is record
      Robots : Robot_Array;
      Count  : Robot_Count := 0;
   end record;

   type Answers is array (Natural range <>) of Answer;

   type Drawing is access procedure (K : Natural);
   --  Shows image K of a sequence in slot 0

   procedure Compare
     (Draw     : Drawing;
      Images   : Positive;
      Followed : Natural;
      Marker   : Marker_Kind   := Aruco;
      Arena    : Arena_Corners := No_Arena);
   --  Each image's answer is the same, robot by robot, and at least so many
   --  come from a search in areas. Inside Arena, where it is one

   procedure Follow
     (Known  : in out Vision.Following.State;
      Marker : Marker_Kind;
      Arena  : Arena_Corners;
      Item   : out Answer;
      Done   : out Boolean);
   --  As the supervisor's task does it; Done: in the areas

   procedure Test_Still (T : in out Any_Test);
   procedure Test_Moving (T : in out Any_Test);
   procedure Test_Turning (T : in out Any_Test);
   procedure Test_Noise (T : in out Any_Test);
   procedure Test_Blur (T : in out Any_Test);
   procedure Test_Triangle (T : in out Any_Test);
   procedure Test_Hidden (T : in out Any_Test);
   procedure Test_Leaving (T : in out Any_Test);
   procedure Test_Jump (T : in out Any_Test);
   procedure Test_Newcomer (T : in out Any_Test);
   procedure Test_Four (T : in out Any_Test);
   procedure Test_Arena (T : in out Any_Test);
   procedure Test_Sizes (T : in out Any_Test);
   procedure Test_Interval (T : in out Any_Test);
   procedure Test_Plan (T : in out Any_Test);
   procedure Test_Settle (T : in out Any_Test);
   procedure Test_Far_Away (T : in out Any_Test);

   procedure Follow
     (Known  : in out Vision.Following.State;
      Marker : Marker_Kind;
      Arena  : Arena_Corners;
      Item   : out Answer;
      Done   : out Boolean)
   is
      Areas  : Area_Array;
      Number : Robot_Count;
      Result : Status;
   begin
      Item := (others => <>);
      Done := False;
      Vision.Following.Plan (Known, Marker, Gap, Areas, Number);
      if Number > 0 then
         Follow_Robots
           (0, Marker, Arena, Arena /= No_Arena, Areas, Number,
            Item.Robots, Item.Count, Result);
         Vision.Following.Settle (Known, Gap, Item.Robots, Item.Count, Done);
      end if;
      if not Done then
         Find_Robots
           (0, Marker, Arena, Arena /= No_Arena, Item.Robots, Item.Count,
            Result);
         Vision.Following.Begin_Anew (Known, Item.Robots, Item.Count);
      end if;
   end Follow;

   procedure Compare
     (Draw     : Drawing;
      Images   : Positive;
      Followed : Natural;
      Marker   : Marker_Kind   := Aruco;
      Arena    : Arena_Corners := No_Arena)
   is
      Expected : Answers (1 .. Images);
      Known    : Vision.Following.State;
      Item     : Answer;
      Done     : Boolean;
      Number   : Natural := 0;
      Result   : Status;

      function Is_Near (A, B : Point) return Boolean is
        (abs (A.X - B.X) <= Tolerance and then abs (A.Y - B.Y) <= Tolerance);

   begin
      --  These first: each search remembers what it has seen
      for K in Expected'Range loop
         Draw (K);
         Find_Robots
           (0, Marker, Arena, Arena /= No_Arena,
            Expected (K).Robots, Expected (K).Count, Result);
      end loop;

      for K in Expected'Range loop
         Draw (K);
         Follow (Known, Marker, Arena, Item, Done);
         Number := Number + Boolean'Pos (Done);
         Assert (Item.Count = Expected (K).Count,
                 "image" & K'Image & ":" & Item.Count'Image
                 & " robots instead of" & Expected (K).Count'Image);
         for L in 1 .. Item.Count loop
            Assert
              (Item.Robots (L).Id = Expected (K).Robots (L).Id
               and then Is_Near (Item.Robots (L).Centre,
                                 Expected (K).Robots (L).Centre)
               and then Is_Near (Item.Robots (L).Direction,
                                 Expected (K).Robots (L).Direction),
               "image" & K'Image & ": robot" & L'Image & " at"
               & Item.Robots (L).Centre.X'Image
               & Item.Robots (L).Centre.Y'Image & " instead of"
               & Expected (K).Robots (L).Centre.X'Image
               & Expected (K).Robots (L).Centre.Y'Image);
         end loop;
      end loop;
      Assert (Number >= Followed,
              "only" & Number'Image & " images searched in part");
   end Compare;

   --  The sequences. A robot at its largest speed, 30 cm/s, comes 3 cm
   --  further from image to image.

   procedure Draw_Still (K : Natural);
   procedure Draw_Moving (K : Natural);
   procedure Draw_Turning (K : Natural);
   procedure Draw_Noise (K : Natural);
   procedure Draw_Blur (K : Natural);
   procedure Draw_Triangle (K : Natural);
   procedure Draw_Hidden (K : Natural);
   procedure Draw_Leaving (K : Natural);
   procedure Draw_Jump (K : Natural);
   procedure Draw_Newcomer (K : Natural);
   procedure Draw_Four (K : Natural);
   procedure Draw_Small (K : Natural);
   procedure Draw_Large (K : Natural);

   function Round_Trip (K : Natural; Marker : int := 0)
     return Scenes.Description;
   --  From wall to wall and back at the largest speed, turning

   function Round_Trip (K : Natural; Marker : int := 0)
     return Scenes.Description
   is
      Way : constant Natural := 3 * K mod 140;
   begin
      return Scene : Scenes.Description := Pictures.Scene_With
        (Marker, 17,
         5.0 + double (if Way < 70 then Way else 140 - Way), 28.0,
         7.0 * double (K))
      do
         Scene.Noise := 3.0;
         Scene.Seed := unsigned (K);
      end return;
   end Round_Trip;

   procedure Draw_Still (K : Natural) is
      Scene : Scenes.Description :=
        Pictures.Scene_With (0, 3, 22.3, 41.0, 200.0);
   begin
      Scene.Noise := 5.0;
      Scene.Seed := unsigned (K);
      Pictures.Show (Scene);
   end Draw_Still;

   procedure Draw_Moving (K : Natural) is
   begin
      Pictures.Show (Round_Trip (K));
   end Draw_Moving;

   procedure Draw_Turning (K : Natural) is
      Scene : Scenes.Description :=
        Pictures.Scene_With (0, 850, 60.2, 20.0, 31.0 * double (K));
   begin
      Scene.Seed := unsigned (K);
      Scene.Noise := 4.0;
      Pictures.Show (Scene);
   end Draw_Turning;

   procedure Draw_Noise (K : Natural) is
      Scene : Scenes.Description := Round_Trip (K);
   begin
      Scene.Noise := (if K mod 10 = 9 then 30.0 else 15.0);
      Pictures.Show (Scene);
   end Draw_Noise;

   procedure Draw_Blur (K : Natural) is
      Scene : Scenes.Description := Round_Trip (K);
   begin
      Scene.Blur := 2.0;
      Scene.Uneven := 0.5;
      Scene.Turn := 5.0;
      Pictures.Show (Scene);
   end Draw_Blur;

   procedure Draw_Triangle (K : Natural) is
   begin
      Pictures.Show (Round_Trip (K, Marker => 1));
   end Draw_Triangle;

   procedure Draw_Hidden (K : Natural) is
   begin
      --  Something stands in the middle, under which the robot goes
      Pictures.Show_Sheet (Round_Trip (K), 25.0, 200.0, 20.0, 200);
   end Draw_Hidden;

   procedure Draw_Leaving (K : Natural) is
      Scene : Scenes.Description := Round_Trip (K);
   begin
      if K mod 9 in 5 .. 6 then
         Scene.Robots := 0;
      end if;
      Pictures.Show (Scene);
   end Draw_Leaving;

   procedure Draw_Jump (K : Natural) is
      Scene : Scenes.Description := Round_Trip (K);
   begin
      if K mod 14 >= 7 then
         Scene.Robot (0).Y := 50.0;
         Scene.Robot (0).X := 80.0 - Scene.Robot (0).X;
      end if;
      Pictures.Show (Scene);
   end Draw_Jump;

   procedure Draw_Newcomer (K : Natural) is
      Scene : Scenes.Description :=
        Pictures.Scene_With (0, 500, 15.0, 15.0, 77.0);
   begin
      --  One of a lower identifier comes and goes far from the first, once
      --  as slowly as one can hardly see
      Scene.Noise := 3.0;
      Scene.Seed := unsigned (K);
      if K in 6 .. 17 or else K in 23 .. 39 then
         Scene.Robots := 2;
         Scene.Robot (1) :=
           (0, 4, 60.0 + (if K < 20 then 0.05 else 1.0) * double (K mod 20),
            45.0, double (K));
      end if;
      Pictures.Show (Scene);
   end Draw_Newcomer;

   procedure Draw_Four (K : Natural) is
      Scene : Scenes.Description := Round_Trip (K);
   begin
      Scene.Robots := 4;
      Scene.Robot (1) := (0, 9, 70.0 - double (K), 10.0, 90.0);
      Scene.Robot (2) := (0, 900, 12.0, 52.0, 5.0 * double (K));
      Scene.Robot (3) := (0, 44, 40.0, 44.0 + 2.5 * double (K mod 2), 0.0);
      Pictures.Show (Scene);
   end Draw_Four;

   procedure Draw_Small (K : Natural) is
      Scene : Scenes.Description := Round_Trip (K);
   begin
      Scene.Width := 320;
      Scene.Height := 240;
      Pictures.Show (Scene);
   end Draw_Small;

   procedure Draw_Large (K : Natural) is
      Scene : Scenes.Description := Round_Trip (5 * K);
   begin
      Scene.Width := 1_280;
      Scene.Height := 720;
      Scene.Robot (0).X := 20.0 + 3.0 * double (K);
      Pictures.Show (Scene);
   end Draw_Large;

   procedure Test_Still (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Still'Access, 40, Followed => 37);
   end Test_Still;

   procedure Test_Moving (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Moving'Access, 60, Followed => 56);
   end Test_Moving;

   procedure Test_Turning (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Turning'Access, 40, Followed => 37);
   end Test_Turning;

   procedure Test_Noise (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Noise'Access, 40, Followed => 20);
   end Test_Noise;

   procedure Test_Blur (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Blur'Access, 40, Followed => 37);
   end Test_Blur;

   procedure Test_Triangle (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Triangle'Access, 40, Followed => 37, Marker => Triangle);
   end Test_Triangle;

   procedure Test_Hidden (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Hidden'Access, 60, Followed => 30);
   end Test_Hidden;

   procedure Test_Leaving (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Leaving'Access, 40, Followed => 20);
   end Test_Leaving;

   procedure Test_Jump (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Jump'Access, 40, Followed => 30);
   end Test_Jump;

   procedure Test_Newcomer (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Newcomer'Access, 50, Followed => 40);
   end Test_Newcomer;

   procedure Test_Four (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Four'Access, 40, Followed => 30);
   end Test_Four;

   procedure Test_Arena (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      --  The robot crosses its border
      Compare
        (Draw_Moving'Access, 60, Followed => 20,
         Arena =>
           ((67_000_000, 50_000_000), (320_000_000, 50_000_000),
            (320_000_000, 430_000_000), (67_000_000, 430_000_000)));
   end Test_Arena;

   procedure Test_Sizes (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Compare (Draw_Small'Access, 30, Followed => 28);
      Compare (Draw_Large'Access, 15, Followed => 14);
   end Test_Sizes;

   procedure Test_Interval (T : in out Any_Test) is
      pragma Unreferenced (T);
      Known : Vision.Following.State;
      Item  : Answer;
      Done  : Boolean;
   begin
      for K in 0 .. 93 loop
         Draw_Still (1);
         Follow (Known, Aruco, No_Arena, Item, Done);
         Assert (Item.Count = 1, "found");
         Assert (Done = (K mod 31 /= 0), "everywhere, or not:" & K'Image);
      end loop;
   end Test_Interval;

   function Robot_At (Id : Identifier; X, Y : Micro_Pixels) return Robot is
     (Id, (X, Y), (X + 3_000_000, Y + 4_000_000), 0);

   procedure Test_Plan (T : in out Any_Test) is
      pragma Unreferenced (T);
      Known  : Vision.Following.State;
      Areas  : Area_Array;
      Number : Robot_Count;
      Near   : Robot_Count;
   begin
      Vision.Following.Plan (Known, Aruco, 0, Areas, Number);
      Assert (Number = 0, "nothing is known");
      Vision.Following.Begin_Anew
        (Known, (Robot_At (5, 100, 200), Robot_At (7, -9, 8), others => <>),
         2);
      for Kind in Marker_Kind loop
         Vision.Following.Plan (Known, Kind, 0, Areas, Number);
         Assert (Number = 2 and then Areas (1).Centre = (100, 200)
                 and then Areas (2).Centre = (-9, 8), "there");
         --  5 pixels long, which is 5.5 here
         Assert (Areas (1).Reach =
                   (if Kind = Aruco then 12_100_000 else 6_820_000),
                 "its body" & Areas (1).Reach'Image);
         Vision.Following.Plan (Known, Kind, 500, Areas, Number);
         Assert (Areas (1).Reach =
                   (if Kind = Aruco then 39_600_000 else 23_320_000),
                 "its way" & Areas (1).Reach'Image);
      end loop;
      Vision.Following.Plan (Known, Aruco, 501, Areas, Near);
      Assert (Near = 0, "too long ago");
   end Test_Plan;

   procedure Test_Settle (T : in out Any_Test) is
      pragma Unreferenced (T);
      Two   : constant Robot_Array :=
        (Robot_At (5, 100, 200), Robot_At (7, -9, 8), others => <>);
      Known : Vision.Following.State;
      Done  : Boolean;
   begin
      Vision.Following.Begin_Anew (Known, Two, 2);
      Vision.Following.Settle (Known, 100, Two, 2, Done);
      Assert (Done and then Vision.Following.Count (Known) = 2
              and then Vision.Following.Age (Known) = 100, "both");
      Vision.Following.Settle
        (Known, 100, (Two (1), Robot_At (6, 0, 0), Two (2), others => <>),
         3, Done);
      Assert (Done and then Vision.Following.Count (Known) = 3, "one more");
      Vision.Following.Settle (Known, 100, Two, 2, Done);
      Assert
        (not Done and then Vision.Following.Count (Known) = 0, "one less");
      Vision.Following.Begin_Anew (Known, Two, 2);
      Vision.Following.Settle
        (Known, 100, (Two (1), Robot_At (6, 0, 0), others => <>), 2, Done);
      Assert (not Done and then Vision.Following.Count (Known) = 0,
              "another instead");
      Vision.Following.Begin_Anew (Known, Two, 2);
      Vision.Following.Settle (Known, 0, (others => <>), 0, Done);
      Assert (not Done and then Vision.Following.Count (Known) = 0, "none");
      Vision.Following.Begin_Anew (Known, Two, 2);
      Assert (Vision.Following.Count (Known) = 2, "known again");
      Vision.Following.Forget (Known);
      Assert (Vision.Following.Count (Known) = 0, "forgotten");
   end Test_Settle;

   procedure Test_Far_Away (T : in out Any_Test) is
      pragma Unreferenced (T);
      Known  : Vision.Following.State;
      Areas  : Area_Array;
      Number : Robot_Count;
      Item   : Answer;
      Result : Status;
   begin
      --  Numbers that no image gives rise to
      Vision.Following.Begin_Anew
        (Known,
         (1      => (5, (Micro_Pixels'First, 0), (Micro_Pixels'Last, 0), 0),
          others => <>), 1);
      Vision.Following.Plan (Known, Aruco, 500, Areas, Number);
      Assert (Number = 1 and then Areas (1).Reach = Vision.Following.Furthest,
              "a limit");
      Draw_Still (1);
      Follow_Robots (0, Aruco, No_Arena, False, Areas, Number,
                     Item.Robots, Item.Count, Result);
      Assert (Result = Bad_Argument and then Item.Count = 0, "refused");
      Find_Robots (0, Aruco, No_Arena, False, Item.Robots, Item.Count,
                   Result);
      Areas (1) := ((22_000_000, 40_000_000), -1);
      Follow_Robots (0, Aruco, No_Arena, False, Areas, 1,
                     Item.Robots, Item.Count, Result);
      Assert (Result = Bad_Argument, "less than nothing");
      Areas (1) := ((-900_000_000, 40_000_000), 5_000_000);
      Follow_Robots (0, Aruco, No_Arena, False, Areas, 1,
                     Item.Robots, Item.Count, Result);
      Assert (Result = Not_Found, "beside the image");
      Follow_Robots (0, Aruco, No_Arena, False, Areas, 0,
                     Item.Robots, Item.Count, Result);
      Assert (Result = Bad_Argument, "no area");
   end Test_Far_Away;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("following"));

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Still'Access, "a robot that stands");
      Register_Routine (T, Test_Moving'Access, "one at its largest speed");
      Register_Routine (T, Test_Turning'Access, "one that turns");
      Register_Routine (T, Test_Noise'Access, "noise");
      Register_Routine (T, Test_Blur'Access, "blur, uneven light");
      Register_Routine (T, Test_Triangle'Access, "a triangle");
      Register_Routine (T, Test_Hidden'Access, "partly hidden");
      Register_Routine (T, Test_Leaving'Access, "leaving and coming back");
      Register_Routine (T, Test_Jump'Access, "put elsewhere");
      Register_Routine (T, Test_Newcomer'Access, "another one comes");
      Register_Routine (T, Test_Four'Access, "four, two near each other");
      Register_Routine (T, Test_Arena'Access, "across the arena's border");
      Register_Routine (T, Test_Sizes'Access, "other sizes");
      Register_Routine (T, Test_Interval'Access,
                        "everywhere every three seconds");
      Register_Routine (T, Test_Plan'Access, "where to look");
      Register_Routine (T, Test_Settle'Access, "what has been found");
      Register_Routine (T, Test_Far_Away'Access, "absurd places");
   end Register_Tests;

end Following_Tests;
