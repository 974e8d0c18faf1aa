--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the robot was a while ago, for a camera whose images come late.

with Robot_Core;   use Robot_Core;
with Robot_Motion; use type Robot_Motion.Micro;

package Robot_Pasts with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Robot_Pasts);
   --  A claim that GNATprove checks: every subprogram ends

   Capacity : constant := 512;
   --  Events: the shortest commands at 9600 baud for more than a second

   type Past is private;
   --  The robot after each of the newest events; at first one that is off
   --  in the middle of the arena

   procedure Add (P : in out Past; R : Robot);
   --  After an event, which is not before those that were added

   function Robot_At (P : Past; Time : Robot_Core.Time_Point) return Robot
     with Post => Clock (Robot_At'Result) >= Time;
   --  As it was at Time. Before the oldest event that is known: as it was
   --  after that.

private

   subtype Place is Positive range 1 .. Capacity;
   type Robots is array (Place) of Robot;

   type Past is record
      Item   : Robots;
      Length : Natural range 0 .. Capacity := 0;
      Last   : Place := Capacity;  --  the newest
   end record;

end Robot_Pasts;
