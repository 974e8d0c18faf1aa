--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a trace records of the tasks, and the text that it becomes: the JSON
--  of Chrome's trace format, which ui.perfetto.dev opens.

with Interfaces; use Interfaces;
with Schedule;
with Texts;

package Trace_Json with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Trace_Json);
   --  A claim that GNATprove checks: every subprogram ends

   use type Schedule.Task_Name;

   type Event_Kind is
     (Release,    --  the task has something to do from now on
      Due,        --  the same by the clock, from the time that was set
      Start,      --  of a job
      Take_Up,    --  both at once: the kernel has released the task
      Start_Due,  --  of a job whose release was at the time Number
      Done,       --  its end, or nothing where none is under way
      Wait,       --  the job waits, Label says what for
      Resume,     --  and goes on
      Idle,       --  the task found nothing to do
      Received,   --  a message of the monitor, Label is its own
      Sent,       --  a message to the monitor
      Ordered);   --  a command to the robot, Label is its letter

   subtype Label_Text is String (1 .. 6);
   --  Letters and digits, then blanks

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
   --  What is open in the text so far: what is begun there is ended there,
   --  whichever events are missing

   procedure Begin_Text
     (First    : Unsigned_64;
      Recorded : Unsigned_64;
      Kept     : Unsigned_64;
      Line     : out Texts.Text);
   --  How the text begins. First: the time from which times are counted;
   --  Recorded: how many events there have been; Kept: those that follow

   procedure Name_Task (Who : Schedule.Task_Name; Line : out Texts.Text);
   --  Its name and its place among the others, by priority

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
   --  What Item adds, nothing where Line is empty

   End_Of_Text : constant String := ASCII.LF & "]}" & ASCII.LF;
   --  After Done for every task

end Trace_Json;
