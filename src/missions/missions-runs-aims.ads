--  SPDX-License-Identifier: GPL-3.0-or-later
--  The next order of a mission: a turn or a drive towards its target, after a
--  look at what has come of the last ones.

private package Missions.Runs.Aims with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Missions.Runs.Aims);

   function Is_Good_Order (R, Before : Run; Next : Action) return Boolean is
     (Next.Kind = Order
      and then Is_Permitted (R, Next.Request)
      and then not R.Ended
      and then Orders_Left (R) < Orders_Left (Before)
      and then R.Seen_At = Before.Seen_At)
   with Ghost;

   procedure Give
     (R        : in out Run;
      Movement : Movement_Kind;
      Amount   : Drive_Length;
      Next     : out Action)
   with
     Pre  => not R.Ended
       and then R.Orders > 0
       and then
         (if Movement = Drive then
             Missions.Guards.Is_Permitted
               (Position (R), Amount, Doubts (R), R.Size)),
     Post => Is_Good_Order (R, R'Old, Next)
       and then (if Movement = Halt then Next.Request.Kind = Commands.Stop)
       and then R.Leg_End = R.Leg_End'Old;

   procedure Decide (R : in out Run; Now : Microseconds; Next : out Action)
   with
     Pre  => not R.Ended
       and then Now < R.Leg_End
       and then R.Orders > 0
       and then R.Seen_At <= Now
       and then Now - R.Seen_At <= Max_Age,
     Post => Is_Kept (R, R'Old)
       and then R.Seen_At = R.Seen_At'Old
       and then
         (if Next.Kind /= Nothing then
             Is_Good_Order (R, R'Old, Next) and then Now < R.Leg_End);
   --  The robot rests where it is believed to be: gives an order, waits for
   --  more images, or ends the mission

end Missions.Runs.Aims;
