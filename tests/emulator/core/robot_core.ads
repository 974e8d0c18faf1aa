--  SPDX-License-Identifier: GPL-3.0-or-later
--  The emulated robot's firmware, version 3.5, without any I/O: bytes and
--  the passing of time go in, answers come out.
--
--  Time is what Advance_To says it is. The firmware's 100 ms ticks start
--  when the robot is switched on and run on, whatever arrives meanwhile.
--
--  What docs/wire.md leaves open is decided here:
--
--  *  Low battery: a critically empty battery stops the motors and turns
--     the watchdog off. Nothing is answered any more, and 4 s later the robot
--     switches itself off, charger or not. Levels 0 to 2 are only reported;
--     a level of 0 is not yet critical.
--  *  In charge ends, when the charger is unplugged, in idle.
--  *  `t` and `a`, letters of the firmware's own tests, are pings.
--  *  Half a frame stays in the receiver until its carriage return comes,
--     even if the line was hung up meanwhile: the robot's radio cannot know.
--  *  A robot that is off still has its frames told apart (the emulator's
--     journal shows them), but neither obeys nor answers.
--  *  The missed count grows at once with a refused reload; the third miss
--     disables the watchdog at the tick that follows, as in the firmware.

with Interfaces;
with Robot_Motion;

package Robot_Core with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Robot_Core);
   --  A claim that GNATprove checks: every subprogram ends

   use type Interfaces.Unsigned_8;
   use type Robot_Motion.Micro;
   use type Robot_Motion.Wheel_Errors;

   subtype Octet is Interfaces.Unsigned_8;

   subtype Time_Point is Robot_Motion.Time_Point;
   --  Microseconds since the emulator started

   Tick : constant := 100_000;
   --  Of the firmware's timer, microseconds

   subtype Tick_Count is Natural range 0 .. 1_000_000;

   Boot_Ticks : constant Tick_Count := 16;
   --  Start-up takes 1.6 s: the 3 s of the documentation, by a counter that
   --  grows twice a tick

   Watchdog_First   : constant := 9;
   Watchdog_Last    : constant := 11;
   --  Ticks since the last reload at which the next one is accepted
   Misses_Allowed   : constant := 2;
   Inactivity_Ticks : constant := 1_200;
   --  2 minutes without a valid command switch the robot off
   Low_Battery_Ticks : constant := 40;
   --  As long as it stays on with a critically empty battery

   Max_Frame : constant := 50;
   --  Where the receiver's buffer wraps: the 50th byte of a frame throws
   --  away all 50

   type State_Kind is
     (Off, Start_Up, Idle, Run, Movement, In_Charge, Watchdog_Disabled,
      Low_Battery);

   type Battery_Level is (Critical, Empty, Low, Full);
   --  Reported as 0, 0, 1 and 2

   subtype Centivolts is Natural range 0 .. 500;
   --  Of the battery

   function Level_Of (Voltage : Centivolts; Charging : Boolean)
     return Battery_Level
   is (if Charging then
         (if Voltage <= 344 then Empty elsif Voltage < 390 then Low else Full)
       elsif Voltage <= 310 then Critical
       elsif Voltage <= 330 then Empty
       elsif Voltage < 360 then Low
       else Full);
   --  The firmware's thresholds

   Typical : constant array (Battery_Level) of Centivolts :=
     (Critical => 300, Empty => 320, Low => 350, Full => 400);
   --  Of this level, with the charger as well, which makes a critically empty
   --  battery an empty one

   type Command_Kind is
     (Bad_Checksum, Unknown, Ping, Reset, Start, Start_With_Watchdog,
      Reload, Move, Turn, Get_Battery, Get_Busy, Get_Version, Power_Off);

   subtype Valid_Command is Command_Kind range Ping .. Power_Off;

   type Octets is array (Positive range <>) of Octet;

   subtype Frame_Length is Natural range 0 .. Max_Frame - 1;

   type Frame is record
      Length : Frame_Length := 0;
      Data   : Octets (1 .. Max_Frame - 1) := (others => 0);
   end record;
   --  What stood before a carriage return

   subtype Answer_Length is Natural range 0 .. 8;

   type Answer is record
      Length : Answer_Length := 0;
      Data   : Octets (1 .. Answer_Length'Last) := (others => 0);
   end record;
   --  Ready for the wire: text, checksum, carriage return. Empty: none.

   type Exchange is record
      Command : Frame;
      --  As received, checksum included
      Kind    : Command_Kind := Unknown;
      Amount  : Robot_Motion.Amount := 0;
      --  Of Move and Turn, clamped
      Before  : State_Kind := Off;
      After   : State_Kind := Off;
      Ticks   : Tick_Count := 0;
      --  Of Reload with the watchdog on: ticks since the last one
      Reply   : Answer;
   end record;
   --  One frame and what became of it

   type Robot is private;
   --  Off, in the middle of the arena, its battery full

   --  What it is

   function State (R : Robot) return State_Kind;
   function Clock (R : Robot) return Time_Point;
   function Pose (R : Robot) return Robot_Motion.Pose;
   function Voltage (R : Robot) return Centivolts;
   function Charging (R : Robot) return Boolean;
   function Battery (R : Robot) return Battery_Level is
     (Level_Of (Voltage (R), Charging (R)));

   function Wheels (R : Robot) return Robot_Motion.Wheel_Errors;

   function Watchdog_On (R : Robot) return Boolean;

   function Missed (R : Robot) return Natural;
   --  Reloads in a row that were missed or refused

   --  Counters since the emulator started

   function Missed_Total (R : Robot) return Natural;
   function Disabled_Count (R : Robot) return Natural;
   --  How often the watchdog has disabled the robot
   function Commands (R : Robot) return Natural;
   --  Frames received, good or bad
   function Stops (R : Robot) return Natural;
   --  Good frames among them that ask for a movement by 0

   --  What happens to it

   procedure Switch_On (R : in out Robot; Boot : Tick_Count := Boot_Ticks)
     with Pre  => Boot > 0,
          Post => State (R) in Start_Up | In_Charge | Low_Battery
                  and then not Watchdog_On (R)
                  and then Clock (R) = Clock (R'Old);
   --  Power-cycles the robot: pose, battery, charger, wheels and counters
   --  stay

   procedure Advance_To (R : in out Robot; Now : Time_Point)
     with Post => Clock (R) = Time_Point'Max (Now, Clock (R'Old));
   --  Lets time pass up to Now; nothing where Now is past already

   procedure Receive
     (R        : in out Robot;
      Byte     : Octet;
      Complete : out Boolean;
      Result   : out Exchange)
   with
     Post =>
       (if Complete
        then Result.Before = State (R'Old)
             and then Result.After = State (R)
             and then (Result.Reply.Length = 0) =
               (Result.Before in Off | Low_Battery)
        else State (R) = State (R'Old));
   --  A byte has arrived. Complete: it ended a frame, Result tells the rest.

   procedure Starve (R : in out Robot)
     with Post => State (R) =
                    (if Watchdog_On (R'Old) then Watchdog_Disabled
                     else State (R'Old))
                  and then Clock (R) = Clock (R'Old);
   --  Its watchdog has missed as many reloads as disable it, whether they
   --  came or not. Nothing where it is off.

   procedure Set_Battery (R : in out Robot; Voltage : Centivolts)
     with Post => Robot_Core.Voltage (R) = Voltage;

   procedure Set_Charging (R : in out Robot; Plugged : Boolean)
     with Post => Charging (R) = Plugged;

   procedure Set_Wheels
     (R : in out Robot; Errors : Robot_Motion.Wheel_Errors)
   with Post => Wheels (R) = Errors and then State (R) = State (R'Old);
   --  For the orders from now on

   procedure Place (R : in out Robot; At_Pose : Robot_Motion.Pose)
     with Post => State (R) = State (R'Old);
   --  Puts it down somewhere else. An order under way goes on from there
   --  no longer: the wheels are at rest, and a movement is over at the next
   --  Advance_To.

   --  The wire's rule for both directions

   function Checksum (Text : Octets) return Octet;
   --  Exclusive or of the bytes, 0x0E where that is a carriage return

private

   subtype Count is Natural;

   type Robot is record
      State         : State_Kind := Off;
      Now           : Time_Point := 0;
      Next_Tick     : Robot_Motion.Micro := Tick;
      Motion        : Robot_Motion.Motion;
      Errors        : Robot_Motion.Wheel_Errors;
      Voltage       : Centivolts := Typical (Full);
      Plugged       : Boolean := False;

      Boot_Left     : Tick_Count := 0;
      Inactive      : Tick_Count := 0;
      Low_Left      : Tick_Count := 0;
      Guarded       : Boolean := False;     --  watchdog on
      Since_Reload  : Tick_Count := 0;
      Misses        : Count := 0;

      Input         : Frame;

      Missed_Sum    : Count := 0;
      Disabled_Sum  : Count := 0;
      Frames_Sum    : Count := 0;
      Stops_Sum     : Count := 0;
   end record;

   function State (R : Robot) return State_Kind is (R.State);
   function Clock (R : Robot) return Time_Point is (R.Now);
   function Pose (R : Robot) return Robot_Motion.Pose is
     (Robot_Motion.Pose_Of (R.Motion));
   function Voltage (R : Robot) return Centivolts is (R.Voltage);
   function Charging (R : Robot) return Boolean is (R.Plugged);
   function Wheels (R : Robot) return Robot_Motion.Wheel_Errors is
     (R.Errors);
   function Watchdog_On (R : Robot) return Boolean is (R.Guarded);
   function Missed (R : Robot) return Natural is (R.Misses);
   function Missed_Total (R : Robot) return Natural is (R.Missed_Sum);
   function Disabled_Count (R : Robot) return Natural is (R.Disabled_Sum);
   function Commands (R : Robot) return Natural is (R.Frames_Sum);
   function Stops (R : Robot) return Natural is (R.Stops_Sum);

end Robot_Core;
