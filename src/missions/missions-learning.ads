--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a mission learns of its robot: what it does of what is ordered.

with Missions.Angles; use Missions.Angles;
with Missions.Guards; use Missions.Guards;

package Missions.Learning with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Learning);

   subtype Weight is Integer range 0 .. 1_000_000;
   --  Of what is known: the square of the degrees or millimetres that it was
   --  learnt from

   Distrusted : constant := 5;
   --  Turns that are checked after a surprise

   type Knowledge is record
      Turns       : Gain   := 12_000;
      Turn_Weight : Weight := 10;
      Drives      : Gain   := 13_500;
      Way_Weight  : Weight := 25;
      Way_Doubt   : Natural range 0 .. 50 := 0;
      --  percent: the deviation of drives from the learnt gain
      Pulled      : Pull   := 0;
      Pull_Weight : Weight := 1_600;
      Distrust    : Natural range 0 .. Distrusted := 1;
      --  number of turns whose result is still to be checked
      Lag         : Microseconds := 0;
      --  camera latency: from what an image shows to its arrival
   end record;

   subtype Degrees is Integer range -400 .. 400;

   type Movements is record
      From   : Near_Pose;
      Turned : Degrees := 0;
      Driven : Drive_Length := 0;
   end record;
   --  What was ordered since the robot was looked at: a turn, then a drive

   type Turn_Part is record
      Turned : Bearing := 0;
      --  0: no image has shown a part
      Seen   : Microseconds := 0;
      Ended  : Microseconds := 0;
   end record;
   --  The first image in a turn that shows a good part of it: how much, when
   --  after the order; and when the turn had ended

   function Knows_Way (K : Knowledge) return Boolean is
     (K.Way_Weight >= 60 ** 2);
   --  Drives have been learnt from

   function Knows_Turn (K : Knowledge) return Boolean is
     (K.Turn_Weight >= 25 ** 2);
   --  The same of turns

   subtype Some_Turn is Microdegrees range -9_000_000_000 .. 9_000_000_000;

   function True_Turn (Ordered : Drive_Length; By : Gain) return Some_Turn is
     (Microdegrees
        (Within
           (Wide (Ordered) * Wide (By) * 100,
            Wide (Some_Turn'First), Wide (Some_Turn'Last))));

   function Turn_Error (K : Knowledge; M : Movements; Now : Near_Pose)
     return Bearing
   is (Normal
         (Now.Heading - M.From.Heading
          - Normal (True_Turn (M.Turned, K.Turns))));
   --  What was turned, without a drive, beyond what was expected

   function Turn_Seen (K : Knowledge; M : Movements; Now : Near_Pose)
     return Microdegrees
   is (True_Turn (M.Turned, K.Turns) + Turn_Error (K, M, Now));

   function Doubts_Of (K : Knowledge; Turned : Degrees) return Doubts is
     ((Longest =>
         (if not Knows_Way (K) then Gain'Last
          else Integer'Min
            (Gain'Last,
             K.Drives
             + K.Drives
               * Integer'Max
                   (K.Way_Doubt,
                    (if K.Way_Weight < 80 ** 2 then 18
                     elsif K.Way_Weight < 120 ** 2 then 14
                     elsif K.Way_Weight < 200 ** 2 then 9
                     elsif K.Way_Weight < 350 ** 2 then 5
                     else 3)) / 100)),
       Likely  => K.Pulled,
       Either  =>
         (if K.Pull_Weight < 60 ** 2 then 30_000
          elsif K.Pull_Weight < 150 ** 2 then 15_000
          elsif K.Pull_Weight < 300 ** 2 then 8_000
          else 4_000),
       Heading =>
         (if Turned = 0 or else Turned ** 2 <= K.Turn_Weight
          then 1_500_000
          elsif Turned ** 2 <= 4 * K.Turn_Weight then 2_500_000
          else 4_000_000)));
   --  Of a drive after that turn

   Surprise : constant := 4_000_000;
   --  Microdegrees: deviation of the heading after a drive, in addition to
   --  what 5 mm sideways at its end amount to

   procedure Learn
     (K : in out Knowledge; M : Movements; Now : Near_Pose);
   --  From what was ordered, and what is seen now

   procedure Learn_Lag
     (K : in out Knowledge; Part : Turn_Part; Turned : Microdegrees);
   --  Turned: the whole turn

end Missions.Learning;
