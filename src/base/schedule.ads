--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one table of the supervisor's tasks: priorities, periods, deadlines
--  and the ceilings that follow from them. No other unit has such a number.

with Ada.Real_Time; use Ada.Real_Time;
with System;        use System;

package Schedule with SPARK_Mode is

   --  Priorities. GNATprove and the compiler want each as a constant of its
   --  own; the reason for each stands in its row below. Between equal numbers
   --  the order of arrival decides (FIFO_Within_Priorities).

   Stop_Priority           : constant Priority := 35;
   Line_Priority           : constant Priority := 34;
   Reload_Priority         : constant Priority := 33;
   Server_Priority         : constant Priority := 30;
   Move_Priority           : constant Priority := 26;
   Receive_Priority        : constant Priority := 25;
   Lost_Priority           : constant Priority := 24;
   Hold_Priority           : constant Priority := 23;
   Send_Priority           : constant Priority := 22;
   Battery_Priority        : constant Priority := 21;
   Open_Priority           : constant Priority := 20;
   Start_Priority          : constant Priority := 20;
   Start_Watchdog_Priority : constant Priority := 20;
   Reset_Priority          : constant Priority := 20;
   Query_Priority          : constant Priority := 20;
   Keep_Alive_Priority     : constant Priority := 20;
   Camera_Control_Priority : constant Priority := 20;
   Capture_Priority        : constant Priority := 19;
   Arena_Priority          : constant Priority := 18;
   Camera_Priority         : constant Priority := 17;
   Console_Priority        : constant Priority := 2;
   Main_Priority           : constant Priority := 1;

   --  Periods.

   Reload_Period     : constant Time_Span := Milliseconds (1000);  --  F11
   Battery_Period    : constant Time_Span := Milliseconds (500);   --  F13
   Keep_Alive_Period : constant Time_Span := Milliseconds (100);
   --  four failures of 100 ms + 87 ms each stay below the 1 s in which a
   --  lost line must be found
   Link_Period       : constant Time_Span := Milliseconds (250);
   --  how often the monitor's link is examined

   --  The tasks, a row each, the most urgent first.

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

   type Row is record
      Name      : String (1 .. 17);
      --  padded with blanks; the report's, where it has the thread
      Priority  : System.Priority;
      Report    : Any_Priority;
      --  what the thread has in the report, or the one that does its work
      Real_Time : Boolean;
      --  it goes to the processor of --cpu, where there is one
      Period    : Time_Span;
      --  from one release to the next; On_Event: an event releases it
      Deadline  : Time_Span;
      --  for what the comment says; Unbounded where no feature has a figure
   end record;

   No_Thread : constant Any_Priority := Any_Priority'First;
   --  of the report does this
   On_Event  : constant Time_Span := Time_Span_Zero;
   Unbounded : constant Time_Span := Time_Span_Last;

   Table : constant array (Task_Name) of Row :=
     (Th_Stop =>
        ("th_stop          ", Stop_Priority, No_Thread, True,
         On_Event, Unbounded),
      --  ends the process in order, whatever else goes on
      Th_Line =>
        ("th_line          ", Line_Priority, 20, True,
         On_Event, Milliseconds (100)),
      --  owns the robot's line. F12: a command to its frame at the robot.
      --  Before the monitor's tasks: an order that has been received does
      --  not wait for the receipt of the next
      Th_Reload_WD =>
        ("th_reloadWD      ", Reload_Priority, 20, True,
         Reload_Period, Milliseconds (50)),
      --  F11: the tightest window of all
      Th_Server =>
        ("th_server        ", Server_Priority, 30, True,
         On_Event, Milliseconds (50)),
      --  F2: a newcomer is admitted
      Th_Move =>
        ("th_move          ", Move_Priority, 20, True,
         On_Event, Milliseconds (5)),
      --  F12: a command to the first byte of its frame. Ahead of the receipt
      --  of further commands
      Th_Receive_From_Mon =>
        ("th_receiveFromMon", Receive_Priority, 25, True,
         On_Event, Milliseconds (10)),
      --  F4: a command to an answer without the robot
      Th_Com_Mon_Perdue =>
        ("th_comMonPerdue  ", Lost_Priority, 22, True,
         Link_Period, Milliseconds (100)),
      --  F6: a loss to the stop at the robot. Before the sending of images
      Th_Hold =>
        ("th_hold          ", Hold_Priority, 22, True,
         On_Event, Unbounded),
      --  ends the hold on unasked messages
      Th_Send_To_Mon =>
        ("th_sendToMon     ", Send_Priority, 22, True,
         On_Event, Milliseconds (10)),
      --  F4: the robot's answer, or an unasked message, to its sending
      Th_Battery_Level =>
        ("th_batteryLevel  ", Battery_Priority, 20, True,
         Battery_Period, Milliseconds (20)),
      --  F13: its jitter, which must not include a frame's image work
      Th_Open_Com_Robot =>
        ("th_openComRobot  ", Open_Priority, 20, True,
         On_Event, Unbounded),
      Th_Start_Robot =>
        ("th_startRobot    ", Start_Priority, 20, True,
         On_Event, Unbounded),
      Th_Start_Robot_WD =>
        ("th_startRobotWD  ", Start_Watchdog_Priority, 20, True,
         On_Event, Unbounded),
      Th_Reset_Robot =>
        ("th_resetRobot    ", Reset_Priority, 20, True,
         On_Event, Unbounded),
      Th_Query =>
        ("th_query         ", Query_Priority, 20, True,
         On_Event, Unbounded),
      --  ping, state, level and reload when the monitor asks
      Th_Keep_Alive =>
        ("th_keepAlive     ", Keep_Alive_Priority, 20, True,
         Keep_Alive_Period, Unbounded),
      --  asks a line that has been idle
      Th_Camera_Control =>
        ("th_cameraControl ", Camera_Control_Priority, 20, True,
         On_Event, Unbounded),
      Th_Capture_Img =>
        ("th_captureImg    ", Capture_Priority, 20, False,
         On_Event, Milliseconds (20)),
      --  F15: its jitter; its period is --fps's. After the robot's tasks: an
      --  image takes milliseconds, each of them microseconds
      Th_Arene =>
        ("th_arene         ", Arena_Priority, 20, False,
         On_Event, Unbounded),
      --  tens of milliseconds; the periodic images stand still meanwhile
      Th_Camera =>
        ("th_camera        ", Camera_Priority, 20, False,
         On_Event, Unbounded),
      --  owns the camera
      Th_Console =>
        ("th_console       ", Console_Priority, No_Thread, False,
         On_Event, Unbounded));
      --  writes the log

   function Name_Of (Who : Task_Name) return String
   with Post => Name_Of'Result'First = 1
     and then Name_Of'Result'Length in 1 .. 17;
   --  Without the blanks

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

   --  Times.

   Battery_Offset    : constant Time_Span := Milliseconds (250);
   --  from the start: keeps the battery away from the reload
   Idle_Line         : constant Time_Span := Milliseconds (80);
   --  a line that had an exchange this recently needs no ping
   Hold_Limit        : constant Time_Span := Milliseconds (950);
   --  PROTOCOL rule 7: the existing monitor waits 1 s for an answer

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
