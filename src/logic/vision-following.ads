--  SPDX-License-Identifier: GPL-3.0-or-later
--  Robots are looked for where they can be by now, as long as all of them
--  are found there, and everywhere from time to time (F18).

with Options;
with Vision.Shapes; use Vision.Shapes;

package Vision.Following with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Following);
   --  A claim that GNATprove checks: every subprogram ends

   type Milliseconds is range 0 .. 10_000;

   Interval : constant Milliseconds := 3_000;
   --  Between two searches everywhere. A robot that comes changes the image
   --  where nothing is searched, which is noticed
   --  (Vision.Library.Follow_Robots); this is for one that was there and could
   --  not be recognised

   Longest_Gap : constant Milliseconds := 500;
   --  Between two images, for the second to be searched in parts

   --  What follows is in thousandths of a robot's length in the image: from
   --  its centre to the point that it looks at, 3 cm of an ArUco marker of
   --  6 cm, 5.3 cm of the triangle

   type Thousandths is range 0 .. 10_000;

   Body_Reach : constant array (Options.Marker_Kind) of Thousandths :=
     (Options.Aruco => 2_200, Options.Triangle => 1_240);
   --  6.6 cm: the robot, 12.4 cm wide, whichever way it looks

   Speed : constant array (Options.Marker_Kind) of Thousandths :=
     (Options.Aruco => 10, Options.Triangle => 6);
   --  In a millisecond: 30 cm/s, the largest that is followed. A faster
   --  robot, or one put elsewhere, is not found and looked for everywhere

   Furthest : constant := 10 ** 12;

   subtype Distance is Micro_Pixels range 0 .. Furthest;

   function Length (Item : Robot) return Distance
   with Post => Length'Result = Furthest
     or else
       (Length'Result >= abs (Item.Direction.X - Item.Centre.X)
        and then Length'Result >= abs (Item.Direction.Y - Item.Centre.Y));
   --  Without a root: up to an eighth more than it is, and never less but
   --  for the rounding

   function Reach
     (Item : Robot; Marker : Options.Marker_Kind; Gap : Milliseconds)
      return Distance
   is (Distance'Min
         (Furthest,
          Length (Item)
          * Micro_Pixels'Base
              (Body_Reach (Marker) + Speed (Marker) * Thousandths'Base (Gap))
          / 1_000))
   with Pre => Gap <= Longest_Gap;
   --  How far from where it was a part of the robot can be, Gap later

   type State is private;
   --  Initially nothing is known

   function Count (S : State) return Robot_Count;
   --  Robots whose places are known

   function Place (S : State; K : Positive) return Robot
   with Pre => K <= Count (S);

   function Age (S : State) return Milliseconds;
   --  Since the last search everywhere

   function May_Follow (S : State; Gap : Milliseconds) return Boolean is
     (Count (S) > 0
      and then Gap <= Longest_Gap and then Gap <= Interval - Age (S));
   --  Whether an image that comes Gap after the last one is searched in
   --  parts only

   function Has_All
     (S : State; Robots : Robot_Array; Found : Robot_Count) return Boolean
   is (Found >= Count (S)
       and then
         (for all K in 1 .. Count (S) =>
            (for some L in 1 .. Found => Robots (L).Id = Place (S, K).Id)));
   --  Robots (1 .. Found) are those known, and perhaps more

   --  For each image: Plan, then Settle where the areas have been searched,
   --  and Begin_Anew where everything has

   procedure Plan
     (S      : State;
      Marker : Options.Marker_Kind;
      Gap    : Milliseconds;
      Areas  : out Area_Array;
      Number : out Robot_Count)
   with
     Post => Number = (if May_Follow (S, Gap) then Count (S) else 0)
       and then
         (for all K in 1 .. Number =>
            Areas (K) = (Place (S, K).Centre,
                         Reach (Place (S, K), Marker, Gap)));
   --  Where to look: in Areas (1 .. Number), or everywhere if there are none

   procedure Settle
     (S      : in out State;
      Gap    : Milliseconds;
      Robots : Robot_Array;
      Found  : Robot_Count;
      Done   : out Boolean)
   with
     Pre  => May_Follow (S, Gap),
     Post => Done = Has_All (S'Old, Robots, Found)
       and then
         (if Done then
             Age (S) = Age (S'Old) + Gap
             and then Count (S) = Found
             and then (for all K in 1 .. Found => Place (S, K) = Robots (K))
          else Count (S) = 0);
   --  What has been found in the areas. Unless Done one is missing

   procedure Begin_Anew
     (S : out State; Robots : Robot_Array; Found : Robot_Count)
   with
     Post => Age (S) = 0
       and then Count (S) = Found
       and then (for all K in 1 .. Found => Place (S, K) = Robots (K));
   --  What has been found everywhere

   procedure Forget (S : out State)
   with Post => Count (S) = 0;

private

   type State is record
      Robots : Robot_Array;
      Number : Robot_Count := 0;
      Age    : Milliseconds range 0 .. Interval := 0;
   end record;

   function Count (S : State) return Robot_Count is (S.Number);

   function Place (S : State; K : Positive) return Robot is (S.Robots (K));

   function Age (S : State) return Milliseconds is (S.Age);

end Vision.Following;
