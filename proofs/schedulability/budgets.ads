--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the analysis takes for granted: processor times as measured, and
--  the load for which the deadlines are promised. Times in microseconds.

with Response_Times; use Response_Times;

package Budgets with SPARK_Mode is

   --  An activity is what a task does between two waits. Where a task waits
   --  for the robot's line in between, it has two.

   type Activity_Name is
     (Kernel,              --  timer ticks and interrupts of a processor
      Stop,                --  th_stop: signal to stop order
      Line_Request,        --  th_line: takes a request, writes its frame
      Line_Answer,         --  th_line: reads the answer, says so
      Line_Open,           --  th_line: opens or closes the device
      Reload_Due,          --  th_reloadWD: asks for the reload
      Reload_Done,         --  th_reloadWD: when the next is due
      Newcomer,            --  th_server: takes a connection or reads a piece
                           --  of its first line; admits or refuses
      Move_Order,          --  th_move: asks for the movement
      Move_Answer,         --  th_move: answers the monitor
      Receive,             --  th_receiveFromMon: one command
      Loss,                --  th_comMonPerdue: one look; a loss, up to the
                           --  request that stops the robot
      Hold,                --  th_hold: all that it does in 100 ms
      Send_Answer,         --  th_sendToMon: an answer
      Send_Battery,        --  th_sendToMon: a battery level
      Send_Position,       --  th_sendToMon: a position
      Send_Image,          --  th_sendToMon: an image
      Battery_Due,         --  th_batteryLevel: asks for the level
      Battery_Done,        --  th_batteryLevel: passes it on
      Open_Close,          --  th_openComRobot: order and answer
      Start,               --  th_startRobot: order and answer
      Start_Watchdog,      --  th_startRobotWD: order and answer
      Reset,               --  th_resetRobot: order and answer
      Query_Order,         --  th_query: asks
      Query_Answer,        --  th_query: answers the monitor
      Keep_Alive,          --  th_keepAlive: asks, takes note
      Camera_Control,      --  th_cameraControl: order and answer
      Capture,             --  th_captureImg: position, drawing, JPEG, base64
      Arena,               --  th_arene: search, drawing, JPEG, base64
      Camera,              --  th_camera: one image of the camera
      Console,             --  th_console: one line of the log
      Environment);        --  main procedure: waits for ever

   type Activity_Times is array (Activity_Name) of Span;

   --  Measured on two machines, each with two cores of an Intel Xeon (both
   --  virtual, Linux 6.18, the second of 2.7 GHz; on the first a wake-up
   --  costs two to three times as much), as root, both processors busy with
   --  other work all the time, robot's line at 9600 baud, images of 640x480
   --  with positions. The longer of the two, rounded up to 5 us; 1 and 2 say
   --  of which machine, and of how many it is the longest:
   --    bench  script/bench tasks: its load
   --    each   single commands, 20 ms apart, as they are in it now
   --  Of 122_000 activities in eleven minutes on the first machine fewer
   --  than one in a thousand of each task took longer, by up to 1 ms and
   --  often several tasks' at once; the analysis bears them as wake-ups that
   --  come late

   Processor_Time : constant Activity_Times :=
     (Kernel          => 10,      --  assumed, of each Tick_Interval
      Stop            => 180,     --  each 2:  177, SIGTERM while driving
      Line_Request    => 115,     --  each 1:  112 of 2995
      Line_Answer     => 145,     --  each 1:  142 of 2995
      Line_Open       => 240,     --  each 1:  238 of 518
      Reload_Due      => 150,     --  each 1:  146 of 1658
      Reload_Done     => 150,     --  each 1:  the same
      Newcomer        => 315,     --  each 2:  311 of 2200, two interrupted
      Move_Order      => 140,     --  bench 1: 137 of 6561
      Move_Answer     => 140,     --  bench 1: the same
      Receive         => 170,     --  bench 1: 169 of 9086
      Loss            => 170,     --  bench 1: 169 of 2350
      Hold            => 160,     --  bench 2: 159 of 602
      Send_Answer     => 140,     --  each 1:  139 of 4817
      Send_Battery    => 140,     --  as an answer
      Send_Position   => 220,     --  each 1:  216 of 600
      Send_Image      => 355,     --  bench 2: 353 of 1495
      Battery_Due     => 140,     --  each 1:  136 of 1628
      Battery_Done    => 140,     --  each 1:  the same
      Open_Close      => 140,     --  each 1:  138 of 800
      Start           => 135,     --  each 1:  135 of 867
      Start_Watchdog  => 130,     --  each 1:  128 of 496
      Reset           => 160,     --  each 1:  158 of 2176
      Query_Order     => 105,     --  bench 1: 103 of 3221
      Query_Answer    => 105,     --  bench 1: the same
      Keep_Alive      => 105,     --  bench 2: 52 of 359, twice
      Camera_Control  => 165,     --  each 1:  162 of 311
      Capture         => 9_500,   --  bench 2: 9414 of 663
      Arena           => 6_700,   --  each 2:  6689 of 12
      Camera          => 2_250,   --  bench 2: 2248 of 603
      Console         => 195,     --  each 1:  193 of 2867
      Environment     => 0);      --  it does nothing any more

   Capture_Low  : constant Span := 2_250;
   Capture_High : constant Span := 5_400;
   --  bench 1: 99 of 100 images take no less, no more. On the second machine
   --  3_800 and 5_900, which is a smaller difference

   --  The operations of the protected objects

   type Operation_Name is
     (Outbox_Short,        --  every operation that copies no image
      Outbox_Image,        --  Put_Image, Answer_With_Image, Take
      Line_Operation,      --  Robot_Line
      Port_Operation,      --  Order_Ports, Vision_Queue
      Vision_Operation,    --  Vision_State, Camera_Requests, Frame_Store
      Session_Operation,
      Journal_Operation,
      Settings_Operation,
      Event_Operation);    --  the mutex of a suspension object

   type Operation_Times is array (Operation_Name) of Span;

   --  bin/operation_times (tests/bench/operations.gpr), the longer of both
   --  machines: 99 of 100 are below 1.0 us, with an image 3.2 us,
   --  Robot_Line.Take 1.7 us, Journal.Put 2.1 us; at least twice that, for
   --  an object that another processor has used. What takes longer is an
   --  interrupt, and in the kernel's budget

   Operation_Time : constant Operation_Times :=
     (Outbox_Short        => 2,
      Outbox_Image        => 8,
      Line_Operation      => 4,
      Port_Operation      => 2,
      Vision_Operation    => 2,
      Session_Operation   => 2,
      Journal_Operation   => 5,
      Settings_Operation  => 2,
      Event_Operation     => 2);

   --  The load

   Command_Interval : constant Positive_Span := 50_000;
   --  between two commands of the monitor: 20 a second. script/bench sends
   --  25, of which 17 go to the robot
   Session_Interval : constant Positive_Span := 1_000_000;
   --  between two beginnings, two ends of a session
   Arena_Interval   : constant Positive_Span := 1_000_000;
   Camera_Interval  : constant Positive_Span := 33_333;
   --  30 images a second are asked of a camera
   Tick_Interval    : constant Positive_Span := 1_000;
   --  of the kernel: timer ticks, network and serial interrupts together

   Robot_Turnaround : constant Span := 5_000;
   --  from the last byte of a command to the first byte of its answer:
   --  both radios and the robot. To be measured on a real pair

   Wake_Latency     : constant Span := 200;
   --  of the kernel, from the event to the task's first instruction, while
   --  no task of ours is in the way. PREEMPT_RT, or a kernel as prompt

   Message_Gap      : constant Span := 4_000;
   --  --message-gap, its default

   Cortex_A53_Factor : constant := 6;
   --  how much longer an A53 of 1.2 GHz takes, see README.md

   --  Frames on the line, in bytes: text, checksum, end

   Short_Frame    : constant := 3;   --  one letter
   Stop_Frame     : constant := 5;   --  M=0
   Longest_Frame  : constant := 10;  --  M=-32768
   Probe_Frames   : constant := 5;
   --  a letter and what the answer to V is longer than the usual one

end Budgets;
