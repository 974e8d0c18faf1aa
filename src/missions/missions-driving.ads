--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's movements in the arena: what a mission learns from them, which
--  ones are permitted, and which one is next.

with Missions.Angles; use Missions.Angles;

package Missions.Driving with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Driving);  --  proved

   --  The guard: whether a drive stays inside the arena, also with the largest
   --  error of what is known of the robot

   Robot_Radius  : constant Micrometres := 62_000;
   Braking       : constant Micrometres := 8_000;
   --  How far the robot may be beyond the place where it is believed to be
   Margin        : constant Micrometres := Robot_Radius + Braking;
   Target_Margin : constant Micrometres := 80_000;
   --  Of its centre from the border

   subtype Drive_Length is Integer range -5_000 .. 5_000;
   --  Millimetres, negative backward

   subtype Gain is Integer range 6_000 .. 20_000;
   --  Ratio of the actual to the ordered movement, in ten thousandths

   subtype Pull is Integer range -40_000 .. 40_000;
   --  How much the robot turns while it drives: microdegrees to the left per
   --  millimetre forward

   type Doubts is record
      Longest : Gain         := Gain'Last;
      Likely  : Pull         := 0;
      Either  : Pull         := 30_000;
      --  the largest deviation from Likely, to either side
      Heading : Microdegrees range 0 .. 10_000_000 := 1_500_000;
      --  the largest error of the heading at the start
   end record;
   --  The uncertainty of a drive

   function Is_Target (Where : Place; Size : Arena_Size) return Boolean is
     (Where.X in Target_Margin
        .. Micrometres (Size.Width) * 10_000 - Target_Margin
      and then Where.Y in Target_Margin
        .. Micrometres (Size.Height) * 10_000 - Target_Margin);
   --  Inside the arena less its margin

   function Is_Permitted
     (From  : Pose;
      Move  : Drive_Length;
      Doubt : Doubts;
      Size  : Arena_Size) return Boolean;
   --  Everywhere on the drive, the robot is inside the arena less Margin, or
   --  not further out than before

   --  Lengths and turns of the actual movement

   function True_Length (Move : Drive_Length; By : Gain) return Micrometres
   is (Micrometres (Move * By / 10));

   subtype Some_Length is Micrometres range -10_000_000 .. 10_000_000;

   function Swing (Length : Some_Length; By : Pull) return Microdegrees
   is (Microdegrees (Wide (Length) * Wide (By) / 2_000))
   with Post => Swing'Result in -200_000_000 .. 200_000_000;
   --  By how much the chord of a drive is to the left of the heading at its
   --  beginning: half of what the robot turns

   --  What is learnt

   subtype Weight is Integer range 0 .. 1_000_000;
   --  Of a learnt value: the square of the degrees or millimetres that it was
   --  learnt from

   Distrusted : constant := 5;
   --  Number of turns that are checked by images after an unexpected result

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

   Upset_Way : constant := 15_000;
   --  Micrometres: a robot that turns stays within this, unless it is moved

   subtype Degrees is Integer range -400 .. 400;

   type Movements is record
      From   : Near_Pose;
      Turned : Degrees := 0;
      Driven : Drive_Length := 0;
   end record;
   --  What was ordered since the robot was last looked at: a turn, then a
   --  drive

   type Turn_Part is record
      Turned : Bearing := 0;
      --  in that image; 0: there is none
      Seen   : Microseconds := 0;
      Ended  : Microseconds := 0;
   end record;
   --  The first image in a turn that shows a good part of it. Seen, Ended:
   --  its time and the turn's end, after the order

   function Knows_Way (K : Knowledge) return Boolean is
     (K.Way_Weight >= 60 ** 2);
   --  At least one long drive has been learnt from

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
   --  How far a turn without a drive went beyond what was expected

   function Turn_Seen (K : Knowledge; M : Movements; Now : Near_Pose)
     return Microdegrees
   is (True_Turn (M.Turned, K.Turns) + Turn_Error (K, M, Now));

   type Movement_Kind is (Halt, Turn, Drive);

   procedure Compare
     (K        : Knowledge;
      M        : Movements;
      Now      : Near_Pose;
      Amiss    : out Movement_Kind;
      Measured : out Percent;
      Is_Above : out Boolean);
   --  What was ordered with what is seen now. Amiss: the kind of movement that
   --  no Gain explains, or Halt. Measured: the movement seen, of the ordered
   --  one, 0 for a robot at rest. Is_Above: it is larger than ordered

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

   procedure Learn
     (K : in out Knowledge; M : Movements; Now : Near_Pose);
   --  From what was ordered, and what is seen now

   procedure Learn_Lag
     (K : in out Knowledge; Part : Turn_Part; Turned : Microdegrees);
   --  Turned: the whole turn

   --  The place of a robot at rest

   Max_Images : constant := 8;
   subtype Image_Count is Natural range 0 .. Max_Images;

   type Resting is record
      Count     : Image_Count := 0;
      Mean      : Near_Pose;
      --  of Count images
      Expected  : Boolean := False;
      --  Count = 0: Mean is computed from the drive
      Confirmed : Boolean := False;
      --  the first image has shown the robot at the computed place
   end record;

   procedure Add_Place (R : in out Resting; Where : Near_Pose)
   with Post => R.Count > 0;
   --  The newest image, without its heading

   procedure Add_Image (R : in out Resting; Where : Near_Pose);
   --  The newest image of a robot at rest. If it shows another place, it is
   --  the first of a new mean

   function After_Drive
     (K : Knowledge; From : Near_Pose; Driven : Drive_Length)
      return Near_Pose;
   --  Where the robot should be

   --  The next movement

   subtype Turn_Count is Natural range 0 .. 2;
   --  Turns since the last drive; 2 stands for two or more

   procedure Choose
     (Here, Goal : Near_Pose;
      K          : Knowledge;
      Turned     : Degrees;
      Turns_Made : Turn_Count;
      Size       : Arena_Size;
      Movement   : out Movement_Kind;
      Amount     : out Drive_Length)
   with
     Post =>
       (if Movement = Drive then
           Is_Permitted
             (Pose_Of (Here), Amount, Doubts_Of (K, Turned), Size));
   --  A turn or a drive towards Goal, for a robot that rests Here and has
   --  Turned since it was last looked at. Halt: none is permitted

end Missions.Driving;
