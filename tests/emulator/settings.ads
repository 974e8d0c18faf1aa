--  SPDX-License-Identifier: GPL-3.0-or-later
--  What can be chosen of the robot, its line and its camera: on the command
--  line ("--speed 92", "--silent") for the beginning, and on the console
--  ("speed 92", "silent on") from then on.

with Robot_Core;

package Settings is

   type Kind is
     (Silent, Endless,   --  0 or 1, as in Answer_Faults.Plan
      Lose, Lose_Every, Drop, Drop_Every, Garbage, Truncate, Corrupt, Flip,
      Wrong, Pile,
      Kept_Bytes,        --  of Truncate
      Bit,               --  of Flip
      Answer_Delay,      --  milliseconds
      Radio_Losses, Radio_Bursts, Radio_Retries,
      --  as in Radio_Links.Chances
      Battery,           --  hundredths of a volt
      Charge,            --  0 or 1
      Speed, Turn_Speed, Overshoot, Pull,
      --  as in Robot_Motion.Wheel_Errors
      Camera_Fps,        --  images a second
      Camera_Opening,    --  milliseconds from a request to its reply
      Camera_Delay,
      --  Images show where the robot was so many milliseconds ago, or where
      --  it was put down at the start
      Position_Noise,
      --  Pixels, standard deviation: of the robot in each image, in x and in
      --  y, not beyond the arena's edge. The n-th image has the same in each
      --  run.
      Noise,             --  grey levels, standard deviation
      Marker,            --  0: ArUco, 1: a triangle
      Marker_Id,
      Frame_Width, Frame_Height,
      --  Pixels
      Camera_Mode);      --  as in Arena_Camera.Mode_Kind

   subtype Robot_Kind is Kind range Silent .. Pull;
   subtype Camera_Kind is Kind range Camera_Fps .. Camera_Mode;
   subtype Switch is Kind
     with Static_Predicate => Switch in Silent | Endless | Charge;

   type Values is array (Kind range <>) of Integer;

   Usual : constant Values (Kind) :=
     (Radio_Retries      => 2,
      Battery            => Robot_Core.Typical (Robot_Core.Full),
      Speed | Turn_Speed => 100,
      Camera_Fps         => 25,
      Noise              => 3,
      Marker_Id          => 1,
      Frame_Width        => 640,
      Frame_Height       => 480,
      others             => 0);

   Bad_Value : exception;
   --  The message says what was expected

   procedure Set (Name, Text : String; Known : out Boolean);
   --  Sets what has that name on the command line and on the console, from
   --  now on; Known is False where nothing has. "" as Text switches on.
   --  Raises Bad_Value.

   function Names (Before : String) return String;
   --  Lines of help, Before in front of each name, each with its end

   function Whole (Text : String; Low, High : Integer) return Integer;
   --  A decimal number in Low .. High. Raises Bad_Value.

end Settings;
