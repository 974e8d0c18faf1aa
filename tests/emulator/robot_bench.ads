--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one robot on the bench, shared by the tasks: its serial line feeds
--  it, the console spoils its answers, the camera looks at it. Also what
--  has been heard so far.
--
--  The robot lives in the past: it knows the time of the last thing that
--  happened to it. Who only looks takes a copy and lets time pass on that,
--  so that the serial line never waits for anybody.

with Answer_Faults;
with Instants;  use Instants;
with Journals;
with Robot_Core;
with Robot_Motion;

package Robot_Bench is

   Origin : constant Instant := Now;
   --  Time 0 of the robot

   function Robot_Time (Time : Instant) return Robot_Core.Time_Point
   is (if Time <= Origin then 0
       else Robot_Core.Time_Point (Instant'(Time - Origin) / 1_000));

   type Fault_Kind is (Drop, Corrupt, Garbage, Truncate, Flip, Wrong);

   protected Bench is

      procedure Switch_On (Boot : Robot_Core.Tick_Count);
      --  Power-cycles the robot; Boot is how long its start-up takes

      procedure Switch_On;
      --  The same, as long as the last time

      procedure Hear
        (Byte    : Robot_Core.Octet;
         Started : Instant;
         Ended   : Instant;
         Wire    : out Answer_Faults.Wire_Bytes;
         Late    : out Instant);
      --  A byte was on the line from Started to Ended. Wire is what goes
      --  back, Late how much later than Ended.

      procedure Babble
        (Byte : out Robot_Core.Octet; Present : out Boolean);
      --  The next byte of an answer without end, while there is one

      procedure Let_Time_Pass;

      procedure Mend;
      --  None of the following faults any more

      procedure Set_Silent (Value : Boolean);
      procedure Set_Endless (Value : Boolean);
      procedure Set_Fault
        (Kind : Fault_Kind; Value : Answer_Faults.Remaining);
      procedure Set_Pile (Value : Answer_Faults.Pile_Size);
      procedure Set_Kept_Bytes (Value : Robot_Core.Answer_Length);
      procedure Set_Bit (Value : Answer_Faults.Bit_Number);
      procedure Set_Delay (Value : Instant);
      procedure Set_Battery (Level : Robot_Core.Battery_Level);
      procedure Set_Charging (Plugged : Boolean);
      procedure Starve;
      --  The robot's watchdog disables it
      procedure Place (Pose : Robot_Motion.Pose);

      procedure Clear_Journal;

      procedure Look (Robot : out Robot_Core.Robot);
      --  As it was when something last happened

      function Spoilt return Natural;
      --  Answers that went out otherwise than the robot gave them, or late

      procedure Next_Note
        (After : Journals.Note_Number;
         Note  : out Journals.Note;
         Found : out Journals.Note_Number);

   private
      The_Robot : Robot_Core.Robot;
      Boot_Time : Robot_Core.Tick_Count := Robot_Core.Boot_Ticks;
      Faults    : Answer_Faults.Plan;
      Held_Back : Instant := 0;
      Babbling  : Boolean := False;
      Spoilings : Natural := 0;
      Heard     : Journals.Journal;
      In_Frame  : Boolean := False;
      First     : Instant := 0;   --  start of the frame
      Reloaded  : Instant := 0;   --  last reload, or start
   end Bench;

   procedure Look (Robot : out Robot_Core.Robot; At_Time : Instant);
   --  A copy of it as it is at that time, unless that is past already

end Robot_Bench;
