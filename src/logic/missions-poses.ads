--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's poses where it can be seen, and what lies between two.

with Missions.Angles; use Missions.Angles;

package Missions.Poses with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Poses);

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

end Missions.Poses;
