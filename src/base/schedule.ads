--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one table of the supervisor's tasks: priorities, periods, deadlines
--  and the ceilings that follow from them. No other unit has such a number.

with Ada.Real_Time; use Ada.Real_Time;
with System;        use System;

package Schedule with SPARK_Mode is

   --  Priorities. The report's own are in the last column; where a number
   --  differs, the reason stands beside it. Between equal numbers the
   --  order of arrival decides (FIFO_Within_Priorities).
   --
   --  robot line before the monitor's tasks: the reload of the watchdog has
   --  the tightest window of all (50 ms), and an order that has been
   --  received must not wait for the receipt of the next.

   Line_Priority          : constant Priority := 34;  --  new: owns the line
   Reload_Priority        : constant Priority := 33;  --  new: 1000 ms reload
   Server_Priority        : constant Priority := 30;  --  30
   Receive_Priority       : constant Priority := 25;  --  25
   Move_Priority          : constant Priority := 26;  --  20: F12, ahead of
   --  the receipt of further commands
   Hold_Priority          : constant Priority := 23;  --  new: ends the hold
   Send_Priority          : constant Priority := 22;  --  22
   Lost_Priority          : constant Priority := 24;  --  22: F6 gives it
   --  100 ms, so it goes before the sending of images
   Open_Priority          : constant Priority := 20;  --  20
   Start_Priority         : constant Priority := 20;  --  20
   Start_Watchdog_Priority : constant Priority := 20;  --  20
   Reset_Priority         : constant Priority := 20;  --  20
   Query_Priority         : constant Priority := 20;  --  new: ping, state
   Battery_Priority       : constant Priority := 21;  --  20: F13, its jitter
   --  must not include a frame's image work
   Keep_Alive_Priority    : constant Priority := 20;  --  new: idle pings
   Camera_Control_Priority : constant Priority := 20;  --  20
   Capture_Priority       : constant Priority := 19;  --  20: an image takes
   --  milliseconds, every robot thread microseconds
   Arena_Priority         : constant Priority := 18;  --  20: tens of
   --  milliseconds, and the periodic images stand still meanwhile
   Camera_Priority        : constant Priority := 17;  --  new: owns the camera
   Stop_Priority          : constant Priority := 35;  --  new: orderly stop
   Console_Priority       : constant Priority := 2;   --  new: writes the log
   Main_Priority          : constant Priority := 1;

   --  The tasks by name, the most urgent first.

   type Task_Name is
     (Th_Stop,
      Th_Line,
      Th_Reload_WD,
      Th_Server,
      Th_Move,
      Th_Receive_From_Mon,
      Th_Com_Mon_Perdue,
      Th_Hold,
      Th_Send_To_Mon,
      Th_Battery_Level,
      Th_Open_Com_Robot,
      Th_Start_Robot,
      Th_Start_Robot_WD,
      Th_Reset_Robot,
      Th_Query,
      Th_Keep_Alive,
      Th_Camera_Control,
      Th_Capture_Img,
      Th_Arene,
      Th_Camera,
      Th_Console);

   function Priority_Of (Who : Task_Name) return Priority is
     (case Who is
         when Th_Stop             => Stop_Priority,
         when Th_Line             => Line_Priority,
         when Th_Reload_WD        => Reload_Priority,
         when Th_Server           => Server_Priority,
         when Th_Move             => Move_Priority,
         when Th_Receive_From_Mon => Receive_Priority,
         when Th_Com_Mon_Perdue   => Lost_Priority,
         when Th_Hold             => Hold_Priority,
         when Th_Send_To_Mon      => Send_Priority,
         when Th_Battery_Level    => Battery_Priority,
         when Th_Open_Com_Robot   => Open_Priority,
         when Th_Start_Robot      => Start_Priority,
         when Th_Start_Robot_WD   => Start_Watchdog_Priority,
         when Th_Reset_Robot      => Reset_Priority,
         when Th_Query            => Query_Priority,
         when Th_Keep_Alive       => Keep_Alive_Priority,
         when Th_Camera_Control   => Camera_Control_Priority,
         when Th_Capture_Img      => Capture_Priority,
         when Th_Arene            => Arena_Priority,
         when Th_Camera           => Camera_Priority,
         when Th_Console          => Console_Priority);

   --  Ceilings: the highest priority of the tasks that call the object.
   --  GNATprove knows them from the code; proofs/faults lowers each but the
   --  log's by one, and GNATprove refuses that.

   Outbox_Ceiling  : constant Priority := Line_Priority;
   Line_Ceiling    : constant Priority := Stop_Priority;
   Order_Ceiling   : constant Priority := Move_Priority;
   Turn_Ceiling    : constant Priority := Receive_Priority;
   Camera_Ceiling  : constant Priority := Stop_Priority;
   Vision_Ceiling  : constant Priority := Lost_Priority;
   Frame_Ceiling   : constant Priority := Lost_Priority;
   Session_Ceiling : constant Priority := Stop_Priority;
   Journal_Ceiling : constant Priority := Priority'Last;
   --  the last-chance handler of a failed task logs too

   --  Periods and times.

   Reload_Period     : constant Time_Span := Milliseconds (1000);  --  F11
   Battery_Period    : constant Time_Span := Milliseconds (500);   --  F13
   Battery_Offset    : constant Time_Span := Milliseconds (250);
   --  from the start: keeps the battery away from the reload
   Keep_Alive_Period : constant Time_Span := Milliseconds (100);
   --  four failures of 100 ms + 87 ms each stay below the 1 s in which a
   --  lost line must be found
   Idle_Line         : constant Time_Span := Milliseconds (80);
   --  a line that had an exchange this recently needs no ping
   Hold_Limit        : constant Time_Span := Milliseconds (950);
   --  PROTOCOL rule 7: the existing monitor waits 1 s for an answer
   Link_Period       : constant Time_Span := Milliseconds (250);
   --  how often the monitor's link is examined

   Answer_Timeout    : constant Time_Span := Milliseconds (80);
   --  of the robot, after the end of the command (PROTOCOL.md)
   Byte_Time         : constant Time_Span := Microseconds (1042);
   --  10 bits at 9600 baud

   Reload_Quiet      : constant Time_Span := Milliseconds (20);
   --  before a reload is due, nothing but a stop or a movement is begun
   Reload_Quiet_Suspect : constant Time_Span := Milliseconds (110);
   --  the same while the line has failed last: the exchange may take all of
   --  the answer time-out

   Camera_Silence_Tenths : constant := 25;  --  of a second
   Camera_Silence    : constant Time_Span :=
     Milliseconds (100 * Camera_Silence_Tenths);
   --  without a new image for this long the camera counts as failed

   Stop_Limit        : constant Time_Span := Milliseconds (800);
   --  an orderly stop does not wait longer for robot and camera
   Failure_Limit     : constant Time_Span := Milliseconds (300);
   --  the same after a failure, when it may never come
   Console_Limit     : constant Time_Span := Milliseconds (100);
   --  for the last lines of the log
   Accept_Pause      : constant Time_Span := Milliseconds (100);
   --  after a connection that could not be accepted
   Newcomer_Interval : constant Time_Span := Milliseconds (10);
   --  between two turns in which th_server sees to newcomers and their first
   --  lines, at least. A flood of them may not take so much of the processor
   --  that an order of the monitor in command is late; with 4 ms it could be
   --  on a Cortex-A53 (proofs/schedulability). A newcomer with a token needs
   --  two turns, and has 50 ms (F2)
   Newcomers_Per_Turn : constant := 10;
   --  whom th_server takes in, hears or refuses in a turn. The kernel's queue
   --  of 512 is empty after half a second
   Hearings_Per_Turn : constant := 3;
   --  of these at most are newcomers that it has taken in before; and so many
   --  refusals at most get a line each in the log. A line may wait for the
   --  task that writes it (proofs/schedulability, "inverted")
   Block_Time        : constant Time_Span := Milliseconds (900);
   --  for sources that flood. Less than the second after which the kernel of
   --  a monitor there tries again
   Refusal_Pause     : constant Time_Span := Milliseconds (1000);
   --  without a refusal: each of the next is in the log again
   Token_Limit       : constant Time_Span := Milliseconds (2000);
   --  for the first line of a newcomer, where a token is asked for
   Trace_Limit       : constant Time_Span := Milliseconds (2000);
   --  for the file of --trace; with Stop_Limit and Console_Limit less than
   --  TimeoutStopSec of the systemd unit
   Store_Limit       : constant Time_Span := Milliseconds (10_000);
   --  after which the main procedure takes the events of --trace to the file,
   --  however few
   Release_Poll      : constant Time_Span := Milliseconds (5);
   --  how often the ends of a session and of the process look again

   Camera_Release_Limit : constant Time_Span := Milliseconds (400);
   --  the end of a session does not wait longer for the camera

end Schedule;
