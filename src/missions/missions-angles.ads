--  SPDX-License-Identifier: GPL-3.0-or-later
--  Angles, vectors and the robot's poses, in integers.

package Missions.Angles with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Angles);  --  proved

   Million : constant := 1_000_000;

   type Wide is range -2 ** 63 .. 2 ** 63 - 1;
   --  For products

   function Within (Number, Low, High : Wide) return Wide is
     (Wide'Max (Low, Wide'Min (High, Number)))
   with
     Pre  => Low <= High,
     Post => Within'Result in Low .. High;

   subtype Part is Wide range -Million .. Million;
   --  Millionths

   function Normal (Angle : Microdegrees) return Bearing is
     ((Angle + Half_Turn) mod Full_Turn - Half_Turn)
   with Pre => Angle <= Microdegrees'Last - Half_Turn;

   function Sine (Angle : Bearing) return Part;
   --  Wrong by at most 4

   function Cosine (Angle : Bearing) return Part;

   function Direction (X, Y : Micrometres) return Bearing;
   --  Of the vector, within a thousandth of a degree of the angle with that
   --  sine and cosine; 0 of no vector

   function Along (X, Y : Micrometres; Towards : Bearing) return Micrometres;
   --  The vector's component in that direction; in its own direction, its
   --  length. Limited to the range of the result

   --  Poses where the robot can be seen, and what lies between two

   subtype Near is Micrometres range -20_000_000 .. 20_000_000;

   type Near_Pose is record
      X, Y    : Near    := 0;
      Heading : Bearing := 0;
   end record;

   function Near_Of (Where : Micrometres) return Near is
     (Micrometres'Max (Near'First, Micrometres'Min (Near'Last, Where)));

   function Pose_Of (P : Near_Pose) return Pose is
     ((At_Place => (P.X, P.Y), Heading => P.Heading));

   function Difference (From, To : Bearing) return Bearing is
     (Normal (To - From));

   function Way (From, To : Near_Pose) return Micrometres is
     (Along (To.X - From.X, To.Y - From.Y,
             Direction (To.X - From.X, To.Y - From.Y)));
   --  The distance

end Missions.Angles;
