--  SPDX-License-Identifier: GPL-3.0-or-later
--  The events of a trace, and its text: Chrome's JSON trace format, which
--  ui.perfetto.dev opens.

with Interfaces; use Interfaces;
with Schedule;
with Texts;

package Trace_Json with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Trace_Json);

   use type Schedule.Task_Name;

   type Event_Kind is
     (Release,    --  the task has become ready
      Due,        --  the same by the clock, at the time that was set
      Start,      --  of a job
      Take_Up,    --  both at once: released by the kernel just now
      Start_Due,  --  of a job whose release was at the time Number
      Done,       --  end of a job; no effect without one
      Wait,       --  the job waits, Label is the reason
      Resume,     --  the wait ends
      Idle,       --  the task found nothing to do
      Received,   --  a message of the monitor, Label is its own
      Sent,       --  a message to the monitor
      Ordered);   --  a command to the robot, Label is its letter

   subtype Label_Text is String (1 .. 6);
   --  Letters and digits, padded with blanks

   type Event is record
      At_Time : Unsigned_64 := 0;   --  in nanoseconds
      Number  : Unsigned_64 := 0;
      --  of the monitor's command, 0: none; of Start_Due: its release
      Who     : Schedule.Task_Name := Schedule.Task_Name'First;
      Kind    : Event_Kind := Idle;
      Label   : Label_Text := (others => ' ');
   end record
   with Size => 24 * 8;

   type Slice_Kind is (None, Job, Job_And_Wait);
   type Slices is array (Schedule.Task_Name) of Slice_Kind;
   --  The open slices of the text. All are closed, even if events are missing

   procedure Begin_Text
     (First    : Unsigned_64;
      Recorded : Unsigned_64;
      Kept     : Unsigned_64;
      Line     : out Texts.Text);
   --  The beginning of the text. First: time 0 of the trace; Recorded: number
   --  of events that were recorded; Kept: number of events that follow

   procedure Name_Task (Who : Schedule.Task_Name; Line : out Texts.Text);
   --  The name of the task and its position by priority

   procedure Put
     (Open  : in out Slices;
      First : Unsigned_64;
      Item  : Event;
      Line  : out Texts.Text)
   with
     Post =>
       (for all Who in Schedule.Task_Name =>
          (if Who /= Item.Who then Open (Who) = Open'Old (Who)))
       and then Open (Item.Who) =
         (case Item.Kind is
             when Start | Take_Up | Start_Due => Job,
             when Done  => None,
             when Wait  =>
               (if Open'Old (Item.Who) = None then None else Job_And_Wait),
             when Resume =>
               (if Open'Old (Item.Who) = None then None else Job),
             when Release | Due | Idle | Received | Sent | Ordered =>
                Open'Old (Item.Who));
   --  The text for Item; Line is empty if there is none

   End_Of_Text : constant String := ASCII.LF & "]}" & ASCII.LF;
   --  Follows Done for every task

end Trace_Json;
