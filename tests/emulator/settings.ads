--  SPDX-License-Identifier: GPL-3.0-or-later
--  The options of the emulator.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Arena_Camera;
with Robot_Bench;
with Robot_Core;
with Robot_Motion;
with Serial_Side;

package Settings is

   Largest_Delay : constant := 60_000;
   --  Of an answer, milliseconds

   type Values is record
      Link        : Unbounded_String;  --  "": none
      Socket      : Boolean := False;  --  at Link, no pseudo-terminal
      Baud        : Serial_Side.Baud_Rate := 9_600;
      Boot        : Robot_Core.Tick_Count := Robot_Core.Boot_Ticks;
      Battery     : Robot_Core.Centivolts :=
        Robot_Core.Typical (Robot_Core.Full);
      Charging    : Boolean := False;
      Pose        : Robot_Motion.Pose;
      Wheels      : Robot_Motion.Wheel_Errors;

      Silent      : Boolean := False;
      Stay_On     : Boolean := False;
      Faults      : Robot_Bench.Fault_Values :=
        (Robot_Bench.Radio_Retries => 2, others => 0);
      Late        : Natural := 0;      --  milliseconds

      Radio       : Boolean := False;
      Seed        : Natural := 1;      --  of the radios

      With_Camera : Boolean := False;
      Camera_Port : Natural := 0;      --  0: any free one
      Camera      : Arena_Camera.Settings;
   end record;

   type Wish is (Work, Show_Help, Show_Version, Bad_Usage);

   procedure Read_Command_Line
     (V : out Values; W : out Wish; Reason : out Unbounded_String);
   --  Reason: of Bad_Usage

   Usage : constant String;
   --  Lines, the last one without its end

private

   NL : constant Character := ASCII.LF;

   Usage : constant String :=
     "Usage: destijl_emulator [OPTION]..." & NL & NL
     & "The robot, on a pseudo-terminal whose path is the first line"
     & " printed." & NL
     & "Commands are read from standard input; 'help' lists them." & NL & NL
     & "  --link PATH          a symbolic link to the pseudo-terminal" & NL
     & "  --socket PATH        instead of it a socket, for tests" & NL
     & "  --baud N             pace of the bytes (9600; 0: no pacing)" & NL
     & "  --boot-ms N          start-up time of the robot (1600)" & NL
     & "  --battery LEVEL      0, 1, 2 (2), critical, or its volts" & NL
     & "  --charging           with its charger plugged in" & NL
     & "  --pose X,Y,HEADING   where it stands (40,30,0): cm, degrees" & NL
     & NL
     & "Wheels that are not ideal (an order takes its usual time):" & NL
     & "  --speed N            percent straight on, 3 to 200 (100)" & NL
     & "  --turn-speed N       percent of turns, 3 to 200 (100)" & NL
     & "  --overshoot N        turns go on by N percent, and take longer by"
     & " as" & NL
     & "                       much, 0 to 20 (0)" & NL
     & "  --pull N             degrees to the left per metre, -30 to 30 (0)"
     & NL
     & NL
     & "A pair of radios between the line and the robot (XBee, transparent):"
     & NL
     & "  --radio              a wire, packets in the air, a second wire;"
     & NL
     & "                       so with each of these:" & NL
     & "  --radio-retries N    percent of attempts repeated, 30 ms each (2)"
     & NL
     & "  --radio-bursts N     percent of packets that begin a burst: in 8"
     & NL
     & "                       packets half of the attempts are repeated (0)"
     & NL
     & "  --radio-losses N     percent of packets lost, each direction (0)"
     & NL
     & "  --radio-seed N       of their random numbers (1)" & NL & NL
     & "The arena camera, if there is to be one:" & NL
     & "  --camera-port N      serves it on 127.0.0.1 (0: a free port)" & NL
     & "  --camera-fps N       images a second (25)" & NL
     & "  --frame-size WxH     (640x480)" & NL
     & "  --noise N            grey levels, standard deviation (3)" & NL
     & "  --camera-delay MS    images show the robot so long ago, 0 to 1000"
     & " (0)" & NL
     & "  --position-noise PX  displaces the robot in each image, 0 to 10"
     & " (0)" & NL
     & "  --marker KIND        aruco (default) or triangle" & NL
     & "  --marker-id N        of an ArUco marker, 0 to 999 (1)" & NL & NL
     & "Faults from the start:" & NL
     & "  --silent             answers nothing" & NL
     & "  --stay-on            is switched on again whenever it is off" & NL
     & "  --lose N             does not receive the first N commands" & NL
     & "  --lose-every N       nor every Nth: 0 (none), or 2 to 1000" & NL
     & "  --drop N             loses the first N answers" & NL
     & "  --drop-every N       loses every Nth: 0 (none), or 2 to 1000" & NL
     & "  --corrupt N          spoils the checksum of the first N" & NL
     & "  --garbage N          sends random bytes instead" & NL
     & "  --truncate N         leaves out their carriage return" & NL
     & "  --delay MS           answers late" & NL & NL
     & "  --help               this text" & NL
     & "  --version";

end Settings;
