--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one robot, shared by the tasks: its serial line sends it bytes, the
--  console injects faults into its line, the camera observes it. Also
--  records the exchanges.
--
--  The robot's state is that of its last event. A reader gets a copy that is
--  advanced in time.

with Answer_Faults;
with Instants;  use Instants;
with Journals;
with Radio_Links;
with Robot_Core;
with Robot_Motion;
with Robot_Pasts;
with Settings;

package Robot_Bench is

   Origin : constant Instant := Now;
   --  Time 0 of the robot

   function Robot_Time (Time : Instant) return Robot_Core.Time_Point
   is (if Time <= Origin then 0
       else Robot_Core.Time_Point (Instant'(Time - Origin) / 1_000));

   protected Bench is

      procedure Begin_Life (Boot : Robot_Core.Tick_Count; Stay_On : Boolean);
      --  Switches the robot on, whose start-up takes Boot; what was before
      --  has no past. Stay_On: somebody switches it on as soon as it is off

      procedure Switch_On;
      --  Power-cycles it

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

      procedure Set (Kind : Settings.Robot_Kind; Value : Integer);
      --  Value must be one that it can take; of the wheels: for the orders
      --  from now on

      procedure Mend;
      --  No fault of the line any more, and the chances of the radios as at
      --  first but for their retries

      function Chances return Radio_Links.Chances;
      --  Of the radios, if there are any

      procedure Starve;
      --  The robot's watchdog disables it
      procedure Place (Pose : Robot_Motion.Pose);

      procedure Clear_Journal;

      procedure Look (Robot : out Robot_Core.Robot; Time, Ago : Instant);
      --  As it is at Time, unless that is past, or was Ago before. Before the
      --  newest 512 events (the first of all is that it was switched on): as
      --  it was after the oldest of them.

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

end Robot_Bench;
