--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one robot, shared by the tasks: its serial line sends it bytes, the
--  console injects faults into its line, the camera observes it. Also
--  records the exchanges.
--
--  The robot's state is that of its last event. A reader takes a copy and
--  advances that in time, so that the serial line never waits.

with Answer_Faults;
with Instants;  use Instants;
with Journals;
with Radio_Links;
with Robot_Core;
with Robot_Motion;
with Robot_Pasts;

package Robot_Bench is

   Origin : constant Instant := Now;
   --  Time 0 of the robot

   function Robot_Time (Time : Instant) return Robot_Core.Time_Point
   is (if Time <= Origin then 0
       else Robot_Core.Time_Point (Instant'(Time - Origin) / 1_000));

   type Fault_Kind is
     (Lose, Lose_Every, Drop, Drop_Every, Corrupt, Garbage, Truncate,
      Radio_Losses, Radio_Bursts, Radio_Retries,
      Flip, Wrong, Pile, Silent, Endless,
      Kept_Bytes,   --  of Truncate
      Bit);         --  of Flip
   --  As in Answer_Faults.Plan and Radio_Links.Chances

   subtype Fault_Option is Fault_Kind range Lose .. Radio_Retries;
   subtype Fault_Command is Fault_Kind range Lose .. Endless;
   --  What the command line and the console know, by these names

   type Fault_Values is array (Fault_Option) of Natural;

   protected Bench is

      procedure Switch_On (Boot : Robot_Core.Tick_Count);
      --  Power-cycles the robot; Boot is the duration of its start-up

      procedure Switch_On;
      --  The same, with the last duration

      procedure Hear
        (Byte    : Robot_Core.Octet;
         Started : Instant;
         Ended   : Instant;
         Wire    : out Answer_Faults.Wire_Bytes;
         Late    : out Instant);
      --  A byte was on the line from Started to Ended. Wire is the reply, to
      --  be sent Late after Ended.

      procedure Miss (Byte : Robot_Core.Octet; Started, Ended : Instant);
      --  The same of one that is lost on its way

      procedure Miss_Answers;
      --  A packet with answers is lost on its way

      procedure Babble (Byte : out Robot_Core.Octet; Present : out Boolean);
      --  The next byte of an endless answer, if there is one

      procedure Let_Time_Pass;

      procedure Stay_On;
      --  From now on somebody switches it on as soon as it is off

      procedure Mend;
      --  Removes all of the following faults

      procedure Set (Kind : Fault_Kind; Value : Natural);
      --  Silent, Endless: 0 or 1. Value must be one that the plan, or the
      --  chances, can take
      procedure Set_Delay (Value : Instant);

      function Chances return Radio_Links.Chances;
      --  Of the radios, if there are any

      procedure Set_Battery (Voltage : Robot_Core.Centivolts);
      procedure Set_Charging (Plugged : Boolean);
      procedure Starve;
      --  The robot's watchdog disables it
      procedure Place (Pose : Robot_Motion.Pose);
      procedure Set_Wheels (Errors : Robot_Motion.Wheel_Errors);
      --  For the orders from now on
      function Wheels return Robot_Motion.Wheel_Errors;

      procedure Clear_Journal;

      procedure Look (Robot : out Robot_Core.Robot);
      --  Its state at its last event

      procedure Look_Back
        (Robot : out Robot_Core.Robot; Time : Robot_Core.Time_Point);
      --  As it was at Time. Before the newest 512 events (the first of all
      --  is that it was put down at the start): as it was after the oldest
      --  of them.

      function Spoilt return Natural;
      --  Number of commands lost, and of answers lost, changed or delayed

      procedure Next_Note
        (After : Journals.Note_Number;
         Note  : out Journals.Note;
         Found : out Journals.Note_Number);

   private
      The_Robot : Robot_Core.Robot;
      Past      : Robot_Pasts.Past;
      Boot_Time : Robot_Core.Tick_Count := Robot_Core.Boot_Ticks;
      Stays_On  : Boolean := False;
      Faults    : Answer_Faults.Plan;
      Held_Back : Instant := 0;
      Radios    : Radio_Links.Chances;
      Babbling  : Boolean := False;
      Spoilings : Natural := 0;
      Heard     : Journals.Journal;
      In_Frame  : Boolean := False;
      Losing    : Boolean := False;  --  this frame
      In_Missed : Boolean := False;  --  a lost frame
      Missed    : Instant := 0;      --  its start
      Nobody    : Robot_Core.Robot;
      --  Receives the lost frames: it is off, and only tells them apart
      First     : Instant := 0;   --  start of the frame
      Reloaded  : Instant := 0;   --  last reload, or start
   end Bench;

   procedure Look
     (Robot   : out Robot_Core.Robot;
      At_Time : Instant;
      Ago     : Instant := 0);
   --  A copy, advanced to that time unless it is in the past. Ago: as it was
   --  so long before.

end Robot_Bench;
