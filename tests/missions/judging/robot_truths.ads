--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the emulated robot was at every time: what its journal has, carried
--  out again on its core.

with Emulators;    use Emulators;
with Instants;     use Instants;
with Robot_Motion;

package Robot_Truths is

   procedure Replay
     (Notes    : Emulators.Notes;
      Start    : Robot_Motion.Pose;
      Wheels   : Robot_Motion.Wheel_Errors;
      From, To : Instant;
      See      : not null access procedure
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean));
   --  It rested at Start until the first of Notes. See is called each
   --  millisecond from From to To. Of the commands, movements and resets are
   --  carried out: nothing else may have stopped the robot

   function Movements (Notes : Emulators.Notes) return Natural;
   --  Orders other than a stop that the robot has accepted

end Robot_Truths;
