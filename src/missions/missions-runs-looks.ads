--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the images show of a mission's robot: where it rests, whether it gets
--  on, and whether it did what was ordered.

private package Missions.Runs.Looks with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Missions.Runs.Looks);

   procedure See (R : in out Run; What : Sighting)
   with Post => Is_Kept (R, R'Old);
   --  As Missions.Runs.See

   procedure Arrive (R : in out Run; Now : Microseconds)
   with Post => Is_Same (R, R'Old);
   --  The robot does not move any more

   procedure Compare (R : in out Run)
   with
     Pre  => not R.Ended,
     Post => R.Leg = R.Leg'Old
       and then R.Orders = R.Orders'Old
       and then R.Seen_At = R.Seen_At'Old;
   --  What was ordered since the last look with what is seen now: it ends the
   --  mission if no Gain explains them twice in a row, or at once if it was
   --  too much

end Missions.Runs.Looks;
