--  SPDX-License-Identifier: GPL-3.0-or-later
--  Robots that are followed: the same answers as a search everywhere gives.

with Interfaces.C; use Interfaces.C;

with Options;        use Options;
with Pictures;
with Scenes;
with Vision.Following;
with Vision.Library; use Vision.Library;
with Vision; use Vision;
with Unit_Runs; use Unit_Runs;

procedure Following_Tests is

   Tolerance : constant Micro_Pixels := 20_000;
   --  Between the two: 0.02 pixels, of the 2 that are demanded

   Gap : constant Vision.Following.Milliseconds := 100;

   type Answer is record
      Robots : Robot_Array;
      Count  : Robot_Count := 0;
   end record;

   type Answers is array (Natural range <>) of Answer;

   type Sequence is
     (Still, Moving, Turning, Noise, Blur, With_Triangle, Partly_Hidden,
      Leaving_And_Back, Put_Elsewhere, Another_Comes, Four_Robots, Small,
      Large, Crossing_The_Arena);

   procedure Follow
     (Known  : in out Vision.Following.State;
      Marker : Marker_Kind;
      Arena  : Arena_Corners;
      Item   : out Answer;
      Done   : out Boolean)
   is
      --  As the supervisor's task does it; Done: in the areas
      Areas  : Area_Array;
      Number : Robot_Count;
      Result : Status;
   begin
      Item := (others => <>);
      Done := False;
      Vision.Following.Plan (Known, Marker, Gap, Areas, Number);
      if Number > 0 then
         Find_Robots
           (0, Marker, Arena, Arena /= No_Arena, Item.Robots, Item.Count,
            Result, Areas, Number);
         Vision.Following.Settle (Known, Gap, Item.Robots, Item.Count, Done);
      end if;
      if not Done then
         Find_Robots
           (0, Marker, Arena, Arena /= No_Arena, Item.Robots, Item.Count,
            Result);
         Vision.Following.Begin_Anew (Known, Item.Robots, Item.Count);
      end if;
   end Follow;

   function Round_Trip (K : Natural; Marker : int := 0)
     return Scenes.Description
   is
      --  From wall to wall and back at the largest speed, 3 cm from image to
      --  image, turning
      Way : constant Natural := 3 * K mod 140;
   begin
      return Pictures.Scene_With
        (Marker, 17,
         5.0 + double (if Way < 70 then Way else 140 - Way), 28.0,
         7.0 * double (K));
   end Round_Trip;

   procedure Draw (What : Sequence; K : Natural) is
      --  Shows its image K in slot 0
      Scene : Scenes.Description :=
        (case What is
            when Still         =>
               Pictures.Scene_With (0, 3, 22.3, 41.0, 200.0),
            when Turning       =>
               Pictures.Scene_With (0, 850, 60.2, 20.0, 31.0 * double (K)),
            when Another_Comes =>
               Pictures.Scene_With (0, 500, 15.0, 15.0, 77.0),
            when With_Triangle => Round_Trip (K, Marker => 1),
            when Large         => Round_Trip (5 * K),
            when others        => Round_Trip (K));
   begin
      Scene.Noise :=
        (case What is
            when Still  => 5.0,
            when Noise  => (if K mod 10 = 9 then 30.0 else 15.0),
            when others => 3.0);
      Scene.Seed := unsigned (K);
      case What is
         when Blur =>
            Scene.Blur := 2.0;
            Scene.Uneven := 0.5;
            Scene.Turn := 5.0;
         when Partly_Hidden =>
            --  Something stands in the middle, under which the robot goes
            Pictures.Show_Frame (Scene, 25.0, 200.0, 20.0, 200);
            return;
         when Leaving_And_Back =>
            if K mod 9 in 5 .. 6 then
               Scene.Robots := 0;
            end if;
         when Put_Elsewhere =>
            if K mod 14 >= 7 then
               Scene.Robot (0).Y := 50.0;
               Scene.Robot (0).X := 80.0 - Scene.Robot (0).X;
            end if;
         when Another_Comes =>
            --  One of a lower identifier comes and goes far from the first,
            --  once as slowly as one can hardly see
            if K in 6 .. 17 or else K in 23 .. 39 then
               Scene.Robots := 2;
               Scene.Robot (1) :=
                 (0, 4,
                  60.0 + (if K < 20 then 0.05 else 1.0) * double (K mod 20),
                  45.0, double (K));
            end if;
         when Four_Robots =>
            Scene.Robots := 4;
            Scene.Robot (1) := (0, 9, 70.0 - double (K), 10.0, 90.0);
            Scene.Robot (2) := (0, 900, 12.0, 52.0, 5.0 * double (K));
            Scene.Robot (3) :=
              (0, 44, 40.0, 44.0 + 2.5 * double (K mod 2), 0.0);
         when Small =>
            Scene.Width := 320;
            Scene.Height := 240;
         when Large =>
            Scene.Width := 1_280;
            Scene.Height := 720;
            Scene.Robot (0).X := 20.0 + 3.0 * double (K);
         when Still | Moving | Turning | Noise | With_Triangle
            | Crossing_The_Arena
         =>
            null;
      end case;
      Pictures.Show (Scene);
   end Draw;

   procedure Compare (What : Sequence; Images : Positive; Followed : Natural)
   is
      --  Each image's answer is the same, robot by robot, and at least so many
      --  come from a search in areas
      Marker   : constant Marker_Kind :=
        (if What = With_Triangle then Triangle else Aruco);
      Arena    : constant Arena_Corners :=
        (if What = Crossing_The_Arena
         then ((67_000_000, 50_000_000), (320_000_000, 50_000_000),
               (320_000_000, 430_000_000), (67_000_000, 430_000_000))
         else No_Arena);
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
         Draw (What, K);
         Find_Robots (0, Marker, Arena, Arena /= No_Arena,
                      Expected (K).Robots, Expected (K).Count, Result);
      end loop;

      for K in Expected'Range loop
         Draw (What, K);
         Follow (Known, Marker, Arena, Item, Done);
         Number := Number + Boolean'Pos (Done);
         Assert (Item.Count = Expected (K).Count,
                 What'Image & K'Image & ":" & Item.Count'Image
                 & " robots instead of" & Expected (K).Count'Image);
         for L in 1 .. Item.Count loop
            Assert (Item.Robots (L).Id = Expected (K).Robots (L).Id
                    and then Is_Near (Item.Robots (L).Centre,
                                      Expected (K).Robots (L).Centre)
                    and then Is_Near (Item.Robots (L).Direction,
                                      Expected (K).Robots (L).Direction),
                    What'Image & K'Image & ": robot" & L'Image & " at"
                    & Item.Robots (L).Centre.X'Image
                    & Item.Robots (L).Centre.Y'Image & " instead of"
                    & Expected (K).Robots (L).Centre.X'Image
                    & Expected (K).Robots (L).Centre.Y'Image);
         end loop;
      end loop;
      Assert (Number >= Followed, What'Image & ": only" & Number'Image
              & " images searched in part");
   end Compare;

   procedure Test_Sequences is
   begin
      Compare (Still, 40, Followed => 37);
      Compare (Moving, 60, Followed => 56);
      Compare (Turning, 40, Followed => 37);
      Compare (Noise, 40, Followed => 20);
      Compare (Blur, 40, Followed => 37);
      Compare (With_Triangle, 40, Followed => 37);
      Compare (Partly_Hidden, 60, Followed => 30);
      Compare (Leaving_And_Back, 40, Followed => 20);
      Compare (Put_Elsewhere, 40, Followed => 30);
      Compare (Another_Comes, 50, Followed => 40);
      Compare (Four_Robots, 40, Followed => 30);
      Compare (Crossing_The_Arena, 60, Followed => 20);
      Compare (Small, 30, Followed => 28);
      Compare (Large, 15, Followed => 14);
   end Test_Sequences;

   procedure Test_Interval is
      Known : Vision.Following.State;
      Item  : Answer;
      Done  : Boolean;
   begin
      for K in 0 .. 93 loop
         Draw (Still, 1);
         Follow (Known, Aruco, No_Arena, Item, Done);
         Assert (Item.Count = 1, "found");
         Assert (Done = (K mod 31 /= 0), "everywhere, or not:" & K'Image);
      end loop;
   end Test_Interval;

   procedure Test_Reach is
      --  What the contract leaves open: the length is at most an eighth too
      --  large
      There : constant Robot := (5, (100, 200), (3_000_100, 4_000_200), 0);
   begin
      Assert (Vision.Following.Length (There) <= 5_625_000,
              "as long as" & Vision.Following.Length (There)'Image);
   end Test_Reach;

   procedure Test_Far_Away is
      Known  : Vision.Following.State;
      Areas  : Area_Array;
      Number : Robot_Count;
      Item   : Answer;
      Result : Status;

      procedure Expect (Wanted : Status; What : String) is
      begin
         Find_Robots (0, Aruco, No_Arena, False, Item.Robots, Item.Count,
                      Result, Areas, 1);
         Assert (Result = Wanted and then Item.Count = 0, What);
      end Expect;

   begin
      --  Numbers that no image gives rise to
      Vision.Following.Begin_Anew
        (Known,
         (1      => (5, (Micro_Pixels'First, 0), (Micro_Pixels'Last, 0), 0),
          others => <>), 1);
      Vision.Following.Plan (Known, Aruco, 500, Areas, Number);
      Assert (Number = 1 and then Areas (1).Reach = Vision.Following.Furthest,
              "a limit");
      Draw (Still, 1);
      Expect (Bad_Argument, "refused");
      Find_Robots (0, Aruco, No_Arena, False, Item.Robots, Item.Count, Result);
      Areas (1) := ((22_000_000, 40_000_000), -1);
      Expect (Bad_Argument, "less than nothing");
      Areas (1) := ((-900_000_000, 40_000_000), 5_000_000);
      Expect (Not_Found, "beside the image");
   end Test_Far_Away;

begin
   Run_Test ("as a search everywhere", Test_Sequences'Access);
   Run_Test ("everywhere every three seconds", Test_Interval'Access);
   Run_Test ("how long a robot is in the image", Test_Reach'Access);
   Run_Test ("absurd places", Test_Far_Away'Access);
end Following_Tests;
