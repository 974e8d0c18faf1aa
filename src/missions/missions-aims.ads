--  SPDX-License-Identifier: GPL-3.0-or-later
--  The next order of a mission: a turn or a drive towards its target.

with Missions.Angles;   use Missions.Angles;
with Missions.Guards;   use Missions.Guards;
with Missions.Learning; use Missions.Learning;

package Missions.Aims with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Missions.Aims);

   type Movement_Kind is (Halt, Turn, Drive);

   subtype Turn_Count is Natural range 0 .. 2;
   --  Turns since the last drive; 2: or more

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
   --  Of a robot that rests Here and has Turned since it was looked at. Halt:
   --  no order that leads to Goal is permitted

end Missions.Aims;
