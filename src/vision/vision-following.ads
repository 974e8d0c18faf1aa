--  SPDX-License-Identifier: GPL-3.0-or-later
--  Robots are searched near their last places, as long as all are found there,
--  and in the whole image from time to time (F18).

with Ada.Real_Time;
with Options;

package Vision.Following with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Following);  --  proved

   type Milliseconds is range 0 .. 10_000;

   Interval : constant Milliseconds := 3_000;
   --  Between two searches of the whole image. A new robot is noticed by the
   --  change in the image (vision_find_robots of vision_c); this is for a
   --  robot that was present but not recognised

   Longest_Gap : constant Milliseconds := 500;
   --  Longest time between two images for a search of areas only

   --  The following are in thousandths of a robot's length in the image: from
   --  the centre to the point in its direction, 3 cm for an ArUco marker of 6
   --  cm, 5.3 cm for the triangle

   type Thousandths is range 0 .. 10_000;

   Body_Reach : constant array (Options.Marker_Kind) of Thousandths :=
     (Options.Aruco => 2_200, Options.Triangle => 1_240);
   --  6.6 cm: the robot is 12.4 cm wide, in any orientation

   Speed : constant array (Options.Marker_Kind) of Thousandths :=
     (Options.Aruco => 10, Options.Triangle => 6);
   --  Per millisecond: 30 cm/s, the highest speed that is followed. A faster
   --  or moved robot is not found, and the whole image is searched

   Furthest : constant := 10 ** 12;

   subtype Distance is Micro_Pixels range 0 .. Furthest;

   function Length (Item : Robot) return Distance
   with Post => Length'Result = Furthest
     or else
       (Length'Result >= abs (Item.Direction.X - Item.Centre.X)
        and then Length'Result >= abs (Item.Direction.Y - Item.Centre.Y));
   --  Without a square root: up to an eighth too large, and too small only by
   --  the rounding

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
   --  How far from its last place any part of the robot can be after Gap

   type State is record
      Robots : Robot_Array;
      Count  : Robot_Count := 0;
      Age    : Milliseconds range 0 .. Interval := 0;
      --  time since the last search of the whole image
   end record;
   --  The places of Robots (1 .. Count) are known: initially none

   function May_Follow (S : State; Gap : Milliseconds) return Boolean is
     (S.Count > 0
      and then Gap <= Longest_Gap and then Gap <= Interval - S.Age);
   --  Whether an image that arrives Gap after the last one is searched in
   --  areas only

   function Has_All
     (S : State; Robots : Robot_Array; Found : Robot_Count) return Boolean
   is (Found >= S.Count
       and then
         (for all K in 1 .. S.Count =>
            (for some L in 1 .. Found => Robots (L).Id = S.Robots (K).Id)));
   --  Robots (1 .. Found) are the known ones, and perhaps more

   --  For each image: Plan, then Settle after a search of areas, or Begin_Anew
   --  after a search of the whole image

   procedure Plan
     (S      : State;
      Marker : Options.Marker_Kind;
      Gap    : Milliseconds;
      Areas  : out Area_Array;
      Number : out Robot_Count)
   with
     Post => Number = (if May_Follow (S, Gap) then S.Count else 0)
       and then
         (for all K in 1 .. Number =>
            Areas (K) = (S.Robots (K).Centre,
                         Reach (S.Robots (K), Marker, Gap)));
   --  Search in Areas (1 .. Number), or in the whole image if there are none

   procedure Settle
     (S      : in out State;
      Gap    : Milliseconds;
      Robots : Robot_Array;
      Found  : Robot_Count;
      Done   : out Boolean)
   with
     Pre  => May_Follow (S, Gap),
     Post => Done = Has_All (S'Old, Robots, Found)
       and then (if Done then S = (Robots, Found, S.Age'Old + Gap)
                 else S.Count = 0);
   --  The result of a search of areas. Not Done: a robot was not found

   procedure Begin_Anew
     (S : out State; Robots : Robot_Array; Found : Robot_Count);
   --  The result of a search of the whole image

   procedure Forget (S : out State);

   --  What a mission wants of a search: the robot, if there is exactly one

   type Sighting is record
      Number : Natural := 0;
      --  of images searched for robots since the camera was opened
      Came   : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  when the image came from the camera
      Seen   : Boolean := False;
      --  exactly one robot is in it: Robot
      Robot  : Vision.Robot;
   end record;

   function Next
     (S      : Sighting;
      Came   : Ada.Real_Time.Time;
      Robots : Robot_Array;
      Count  : Robot_Count) return Sighting
   is ((Number => (if S.Number = Natural'Last then 1 else S.Number + 1),
        Came   => Came,
        Seen   => Count = 1,
        Robot  => Robots (1)));
   --  The image that came at Came has been searched: it has Robots (1 ..
   --  Count)

end Vision.Following;
