--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of tasks: priorities, periods, deadlines and the ceilings that
--  follow from them. No other unit defines such a number.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Strings.Fixed;
with System;        use System;

package Schedule with SPARK_Mode is

   --  Priorities. GNATprove and the compiler need a named constant for each;
   --  the reason for each is at its row below. Equal priorities are served in
   --  the order of arrival (FIFO_Within_Priorities).

   Stop_Priority           : constant Priority := 35;
   --  the tasks that may have the robot's line
   Reload_Priority         : constant Priority := 34;
   Move_Priority           : constant Priority := 33;
   Open_Priority           : constant Priority := 32;
   Battery_Priority        : constant Priority := 31;
   Server_Priority         : constant Priority := 30;
   Lost_Priority           : constant Priority := 26;
   Receive_Priority        : constant Priority := 25;
   Mission_Priority        : constant Priority := 24;
   Send_Priority           : constant Priority := 22;
   Camera_Control_Priority : constant Priority := 20;
   Capture_Priority        : constant Priority := 19;
   Arena_Priority          : constant Priority := 18;
   Camera_Priority         : constant Priority := 17;
   Console_Priority        : constant Priority := 2;
   Main_Priority           : constant Priority := 1;

   --  Periods.

   Reload_Ms         : constant := 1000;  --  F11
   Reload_Period     : constant Time_Span := Milliseconds (Reload_Ms);
   First_Retry_Ms    : constant := 1100;
   Next_Retry_Ms     : constant := 1200;
   --  the same after a reload without an answer, and after the following ones:
   --  Robot.Line_Status
   Battery_Period    : constant Time_Span := Milliseconds (500);   --  F13
   Keep_Alive_Period : constant Time_Span := Milliseconds (140);
   --  without an exchange: four failures of 140 ms + 87 ms each take less than
   --  the 1 s within which a lost line must be detected
   Idle_Ping_Period  : constant Time_Span := Milliseconds (30_000);
   --  of an open line while the robot is not started: the robot switches
   --  itself off after two minutes without a command
   Link_Period       : constant Time_Span := Milliseconds (100);
   --  sampling period of the monitor's connection: the less, the longer may a
   --  monitor be silent that is to be found within a second
   Mission_Period    : constant Time_Span := Milliseconds (20);
   --  of th_mission while a mission is under way, beside each position

   --  The tasks, one row each, the highest priority first.

   type Thread_Name is
     (Th_Stop,
      Th_Start_Robot_WD,
      Th_Move,
      Th_Open_Com_Robot,
      Th_Start_Robot,
      Th_Reset_Robot,
      Th_Battery_Level,
      Th_Server,
      Th_Com_Mon_Perdue,
      Th_Receive_From_Mon,
      Th_Mission,
      Th_Send_To_Mon,
      Th_Camera_Control,
      Th_Capture_Img,
      Th_Arene,
      Th_Camera,
      Th_Console,
      Main);  --  the main procedure, which is no task

   subtype Task_Name is Thread_Name range Th_Stop .. Th_Console;

   subtype Real_Time_Task is Task_Name range Th_Stop .. Th_Camera_Control;
   --  Pinned to the processor of --cpu, if given

   type Row is record
      Name     : String (1 .. 17);
      --  padded with blanks; the name in the design report, if it is there
      Priority : System.Priority;
      Report   : Any_Priority;
      --  priority of the report's thread with this name or this work
      Period   : Time_Span;
      --  between releases; On_Event: released by an event, sporadic
      Deadline : Time_Span;
      --  for the interval named at the row; Unbounded: no requirement
   end record;

   No_Thread : constant Any_Priority := Any_Priority'First;
   --  no thread of the report does this
   On_Event  : constant Time_Span := Time_Span_Zero;
   Unbounded : constant Time_Span := Time_Span_Last;

   Table : constant array (Task_Name) of Row :=
     (Th_Stop =>
        ("th_stop          ", Stop_Priority, No_Thread, On_Event, Unbounded),
      --  ends the process in order, even under load
      Th_Start_Robot_WD =>
        ("th_startRobotWD  ", Reload_Priority, 20,
         Reload_Period, Milliseconds (50)),
      --  F11: the tightest time window of all
      Th_Move =>
        ("th_move          ", Move_Priority, 20, On_Event, Milliseconds (5)),
      --  F12: from command to the first byte of its frame. Above the reception
      --  of further commands
      Th_Open_Com_Robot =>
        ("th_openComRobot  ", Open_Priority, 20, Keep_Alive_Period, Unbounded),
      --  pings an idle line. What is done in an exchange is not put off by
      --  what needs no line
      Th_Start_Robot =>
        ("th_startRobot    ", Open_Priority, 20, On_Event, Unbounded),
      Th_Reset_Robot =>
        ("th_resetRobot    ", Open_Priority, 20, On_Event, Unbounded),
      Th_Battery_Level =>
        ("th_batteryLevel  ", Battery_Priority, 20,
         Battery_Period, Milliseconds (20)),
      --  F13: its jitter, which must not include image processing
      Th_Server =>
        ("th_server        ", Server_Priority, 30,
         On_Event, Milliseconds (50)),
      --  F2: admission of a new client
      Th_Com_Mon_Perdue =>
        ("th_comMonPerdue  ", Lost_Priority, 22,
         Link_Period, Milliseconds (100)),
      --  F6: from the loss to the stop at the robot. Above image sending
      Th_Receive_From_Mon =>
        ("th_receiveFromMon", Receive_Priority, 25,
         On_Event, Milliseconds (10)),
      --  F4: from command to answer, for commands that do not need the robot
      Th_Mission =>
        ("th_mission       ", Mission_Priority, No_Thread,
         On_Event, Milliseconds (100)),
      --  from an image to the first byte of the order that follows from it.
      --  Below the user's orders and the reload, above the images: while a
      --  mission is under way it looks at each position, and every
      --  Mission_Period
      Th_Send_To_Mon =>
        ("th_sendToMon     ", Send_Priority, 22, On_Event, Milliseconds (10)),
      --  F4: from the robot's answer, or an unsolicited message, to sending.
      --  Ends the hold on unsolicited messages
      Th_Camera_Control =>
        ("th_cameraControl ", Camera_Control_Priority, 20,
         On_Event, Unbounded),
      Th_Capture_Img =>
        ("th_captureImg    ", Capture_Priority, 20,
         On_Event, Milliseconds (20)),
      --  F15: its jitter; its period is set by --fps. Below the robot's tasks:
      --  an image takes milliseconds, each of them microseconds
      Th_Arene =>
        ("th_arene         ", Arena_Priority, 20, On_Event, Unbounded),
      --  takes tens of milliseconds; the periodic images pause meanwhile
      Th_Camera =>
        ("th_camera        ", Camera_Priority, 20, On_Event, Unbounded),
      --  owns the camera
      Th_Console =>
        ("th_console       ", Console_Priority, No_Thread,
         On_Event, Unbounded));
      --  writes the log

   function Name_Of (Who : Task_Name) return String is
     (Ada.Strings.Fixed.Trim (Table (Who).Name, Ada.Strings.Right))
   with Post => Name_Of'Result'Length <= 17;
   --  Without the blanks

   --  Ceilings: the highest priority of the tasks that call the object.
   --  GNATprove computes them from the code: proofs/faults lowers each by one,
   --  except the log's, and GNATprove rejects it.

   Outbox_Ceiling  : constant Priority := Reload_Priority;
   Line_Ceiling    : constant Priority := Stop_Priority;
   Turn_Ceiling    : constant Priority := Lost_Priority;
   Mission_Ceiling : constant Priority := Receive_Priority;
   Vision_Ceiling  : constant Priority := Stop_Priority;
   Frame_Ceiling   : constant Priority := Lost_Priority;
   Session_Ceiling : constant Priority := Stop_Priority;
   Journal_Ceiling : constant Priority := Priority'Last;
   --  the last-chance handler of a failed task also logs

   --  Time-outs and intervals.

   Battery_Offset    : constant Time_Span := Milliseconds (250);
   --  after the start: keeps the battery request away from the reload
   Hold_Limit        : constant Time_Span := Milliseconds (950);
   --  docs/wire.md, rule 7: the existing monitor waits 1 s for an answer

   Answer_Timeout_Ms : constant := 80;
   --  default of --answer-timeout: of the robot, from the end of the command.
   --  As long as an order may wait for an exchange without an answer
   --  (proofs/schedulability)
   Byte_Time         : constant Time_Span := Microseconds (1042);
   --  10 bits at 9600 baud

   Reload_Quiet      : constant Time_Span := Milliseconds (20);
   --  before a reload is due, only a stop or a movement may start
   Reload_Quiet_Suspect : constant Time_Span := Milliseconds (30);
   --  the same if the last exchange failed, beside the answer time-out, the
   --  whole of which the next may take

   Mission_Order_Limit : constant Time_Span := Milliseconds (50);
   --  an order of a mission that has waited this long for the line is not
   --  sent: the robot is elsewhere by then

   Progress_Interval : constant Time_Span := Milliseconds (1000);
   --  between two reports on the progress of a mission, or a new leg

   Camera_Silence_Tenths : constant := 25;  --  of a second
   Camera_Silence    : constant Time_Span :=
     Milliseconds (100 * Camera_Silence_Tenths);
   --  without a new image for this long the camera has failed

   Stop_Limit        : constant Time_Span := Milliseconds (800);
   --  an orderly stop waits at most this long for robot and camera
   Failure_Limit     : constant Time_Span := Milliseconds (300);
   --  the same after a failure, when they may never answer
   Console_Limit     : constant Time_Span := Milliseconds (100);
   --  for the last lines of the log
   Unsent_Limit      : constant Time_Span := Milliseconds (100);
   --  a line that is closed waits at most this long for its last bytes to
   --  leave: a device that hangs never takes them
   Accept_Pause      : constant Time_Span := Milliseconds (100);
   --  after a connection that could not be accepted
   Newcomer_Interval : constant Time_Span := Milliseconds (10);
   --  Minimum time between two turns in which th_server handles pending
   --  connections. Limits the processor time that a flood of connections can
   --  take from the orders of the monitor in command: 4 ms is too short on a
   --  Cortex-A53 (proofs/schedulability). A client with a token needs two
   --  turns within 50 ms (F2)
   Newcomers_Per_Turn : constant := 10;
   --  accepted or read in a turn at most. The kernel's queue of 512 is empty
   --  after half a second
   Refusals_Logged   : constant := 3;
   Refusal_Interval  : constant Time_Span := Milliseconds (1000);
   --  the most rejections that get a line in the log in this time; the others
   --  are counted
   Token_Limit       : constant Time_Span := Milliseconds (2000);
   --  for the first line of a client, if a token is required
   Pending_Period    : constant Time_Span := Milliseconds (100);
   --  th_server looks this often whether it is over
   Trace_Limit       : constant Time_Span := Milliseconds (2000);
   --  to write the file of --trace; with Stop_Limit and Console_Limit less
   --  than TimeoutStopSec of the systemd unit
   Release_Poll      : constant Time_Span := Milliseconds (5);
   --  polling period at the end of a session and of the process

   Camera_Release_Limit : constant Time_Span := Milliseconds (400);
   --  the end of a session waits at most this long for the camera

end Schedule;
