--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the robot may be sent: the room that it needs at the border of the
--  arena, and whether a drive stays inside whatever is not known of it.

with Missions.Angles;

package Missions.Guards with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Guards);

   use type Missions.Angles.Wide;

   Robot_Radius  : constant Micrometres := 62_000;
   Braking       : constant Micrometres := 8_000;
   --  How far the robot may be beyond its believed place
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
   --  Wherever the robot comes, it is inside the arena less Margin, or not
   --  further out than it was

   --  Lengths and turns as they will be

   function True_Length (Move : Drive_Length; By : Gain) return Micrometres
   is (Micrometres (Move * By / 10));

   subtype Some_Length is Micrometres range -10_000_000 .. 10_000_000;

   function Swing (Length : Some_Length; By : Pull) return Microdegrees
   is (Microdegrees
         (Missions.Angles.Wide (Length) * Missions.Angles.Wide (By) / 2_000))
   with Post => Swing'Result in -200_000_000 .. 200_000_000;
   --  By how much the chord of a drive is to the left of the heading at its
   --  beginning: half of what the robot turns

end Missions.Guards;
