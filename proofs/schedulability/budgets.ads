--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the analysis takes for granted: processor times as measured, and
--  the load for which the deadlines are promised. Times in microseconds.

with Response_Times; use Response_Times;

package Budgets with SPARK_Mode is

   --  An activity is what a task does between two waits, or up to the robot's
   --  answer and after it.

   type Activity_Name is
     (Kernel,              --  timer ticks and interrupts of a processor
      Stop,                --  th_stop: signal to stop order
      Line_Request,        --  a task takes the line, writes the frame
      Line_Answer,         --  it reads the answer, gives the line back;
                           --  answers a stop of the monitor
      Line_Outcome,        --  it answers any other order, and says what a
                           --  start sets going
      Line_Open,           --  it opens or closes the device
      Reload_Due,          --  th_startRobotWD: it is time for the reload
      Reload_Done,         --  th_startRobotWD: when the next is due
      Newcomer,            --  th_server: one turn: takes in so many, reads
                           --  what they sent, admits or refuses each
      Receive,             --  th_receiveFromMon: one command
      Loss,                --  th_comMonPerdue: one look; a loss, up to the
                           --  request that stops the robot
      Send_Look,           --  th_sendToMon: it wakes, and finds that it must
                           --  wait for the gap after the last message
      Send_Answer,         --  th_sendToMon: an answer
      Send_Battery,        --  th_sendToMon: a battery level
      Send_Mission,        --  th_sendToMon: a mission's progress or end
      Send_Position,       --  th_sendToMon: a position
      Send_Image,          --  th_sendToMon: an image
      Battery_Due,         --  th_batteryLevel: it is time for the level
      Battery_Done,        --  th_batteryLevel: passes it on
      Ping_Due,            --  th_openComRobot: the line may be idle
      Ping_Done,           --  th_openComRobot: when the next is due
      Mission_Begin,       --  th_mission: whether it may begin; the answer
      Mission_Due,         --  th_mission: at its time, one look at what is
                           --  known, up to its request
      Mission_Seen,        --  th_mission: a position: the same
      Mission_Told,        --  th_mission: the request has been carried out
      Camera_Order,        --  th_cameraControl: asks for the camera, or
                           --  answers at once
      Camera_Answer,       --  th_cameraControl: answers when it is open
      Capture,             --  th_captureImg: position, drawing, JPEG, base64
      Arena,               --  th_arene: search, drawing, JPEG, base64
      Camera,              --  th_camera: one image of the camera
      Console,             --  th_console: one line of the log
      Environment);        --  main procedure: waits for ever

   type Machine_Name is (First, Second);
   --  Both have two cores of an Intel Xeon and are virtual, with Linux 6.18;
   --  the second of 2.7 GHz. On the first a wake-up costs two to three times
   --  as much, and most of these times are little else

   type Machine_Times is array (Machine_Name) of Span;
   type Activity_Times is array (Activity_Name) of Machine_Times;

   --  Measured as root, both processors busy with other work all the time,
   --  robot's line at 9600 baud, images of 640x480 with positions; rounded up
   --  to 5 us. None is the longest that there can be: each is a bound that
   --  99.9 % of the task's activities keep, in runs longer than those that
   --  it was taken from. Behind each: where it was found on the first machine
   --  and on the second, as the longest of how many:
   --    bench  script/bench tasks: its load
   --    each   its single commands, 20 ms apart
   --  Those of th_mission were measured on a third such machine, beside the
   --  missions of script/bench, and stand for both
   --  Of those that took longer most did by less than 1 ms, one by 13, and
   --  often several tasks' at once, whatever they do. They are borne as
   --  wake-ups that come late: README.md, how late these may be
   --
   --  When these were measured, one task had the line: the others woke, asked
   --  it, and were woken again. On both machines that took 150 us at most, in
   --  53_955 activities of all of them, and on the second up to 60 (reload),
   --  65 (level), 55 (ping). What a task does now instead was compared with it
   --  on a fourth machine, under the same load, by the clock of each thread:
   --  asking took 66 us, half of all; to be woken and look, 39; to look when
   --  the exchange is over, 5, and to pass a level on, 20; to answer an order,
   --  39 after a start, 22 after others. So a budget marked "of asking" is
   --  this part of what asking took. Request and answer took as long as before

   Measured : constant Activity_Times :=
     (Kernel          => (10, 10),        --  assumed, of each Tick_Interval
      Stop            => (125, 180),      --  each 123 of 129, 177 driving
      Line_Request    => (115, 105),      --  each 112 of 2995, bench 105
      Line_Answer     => (145, 105),      --  each 142 of 2995, bench 105
      Line_Outcome    => (90, 40),        --  0.6 of asking
      Line_Open       => (240, 240),      --  each 238 of 518; as the first
      Reload_Due      => (90, 40),        --  0.6 of asking
      Reload_Done     => (20, 10),        --  0.1 of asking
      Newcomer        => (450, 450),      --  floods: 428 of 1566; as the first
      Receive         => (200, 185),      --  bench 169 of 9086, each 155; and
                                          --  two readings of a longest path
      Loss            => (170, 150),      --  bench 169 of 2350, each 147
      Send_Look       => (100, 100),      --  a trace: 65 of 778 from release
                                          --  to wait, the wake-up included
      Send_Answer     => (140, 105),      --  each 139 of 4817, 105 of 350
      Send_Battery    => (140, 105),      --  as an answer
      Send_Mission    => (140, 105),      --  as an answer
      Send_Position   => (220, 105),      --  each 216 of 600; as an answer
      Send_Image      => (280, 355),      --  bench 276, 353 of 1495
      Battery_Due     => (90, 40),        --  0.6 of asking
      Battery_Done    => (55, 25),        --  0.35 of asking
      Ping_Due        => (90, 35),        --  0.6 of asking
      Ping_Done       => (20, 10),        --  0.1 of asking
      Mission_Begin   => (300, 300),      --  trace 194 of 8, with its wake-up
      Mission_Due     => (150, 150),      --  bench 114 of 1183
      Mission_Seen    => (150, 150),
      Mission_Told    => (150, 150),      --  with a look that follows at once
      Camera_Order    => (165, 40),       --  each 162 of 311, 39 of 36
      Camera_Answer   => (165, 40),
      Capture         => (6_600, 9_500),  --  bench 6593 of 3155, 9414 of 663
      Arena           => (6_700, 6_700),  --  each 6672 of 271, 6689 of 12
      Camera          => (1_150, 2_250),  --  bench 1150, 2248 of 603
      Console         => (195, 70),       --  each 193 of 2867, bench 67
      Environment     => (0, 0));         --  it does nothing any more

   function Processor_Time (Name : Activity_Name) return Span is
     (Span'Max (Measured (Name) (First), Measured (Name) (Second)));
   --  "This machine" of the analysis is as slow as the slower of the two,
   --  in each activity

   Capture_Low  : constant Span := 2_250;
   Capture_High : constant Span := 5_400;
   --  bench: 99 of 100 images of the first machine take no less, no more. On
   --  the second 3_800 and 5_900, which is a smaller difference

   --  The operations of the protected objects

   type Operation_Name is
     (Outbox_Operation,    --  all but Take: none copies an image
      Outbox_Take,
      Line_Operation,      --  Robot.Line
      Turn_Operation,      --  Vision.Turns, Missions.Requests
      Vision_Operation,    --  Vision.State, Vision.Frames
      Session_Operation,
      Journal_Operation);

   type Operation_Times is array (Operation_Name) of Span;

   --  bin/operation_times (tests/bench/operations.gpr), the longer of both
   --  machines: 99 of 100 are below 1.0 us, Robot.Line.Take 1.7 us,
   --  Journal.Put 2.1 us; at least twice that, for an object that another
   --  processor has used. What takes longer is an interrupt, and in the
   --  kernel's budget. Monitor.Outbox.Take was 3.2 us with the copy of an
   --  image, which it makes no more; what it does besides were two short
   --  operations

   Operation_Time : constant Operation_Times :=
     (Outbox_Operation    => 2,
      Outbox_Take         => 8,
      Line_Operation      => 4,
      Turn_Operation      => 2,
      Vision_Operation    => 2,
      Session_Operation   => 2,
      Journal_Operation   => 5);

   --  The load

   Command_Interval : constant Positive_Span := 50_000;
   --  between two commands of the monitor: 20 a second. script/bench sends
   --  25, of which 17 go to the robot
   Question_Interval : constant Positive_Span := 100_000;
   --  the same while a mission is under way
   Session_Interval : constant Positive_Span := 1_000_000;
   --  between two beginnings, two ends of a session; of a mission, by order
   Arena_Interval   : constant Positive_Span := 1_000_000;
   Camera_Interval  : constant Positive_Span := 33_333;
   --  30 images a second are asked of a camera
   Mission_Pause    : constant Positive_Span := 20_000;
   --  after the robot's answer to a mission, which was a question whether it
   --  still moves, until the next
   Tick_Interval    : constant Positive_Span := 1_000;
   --  of the kernel: timer ticks, network and serial interrupts together

   Robot_Turnaround : constant Span := 5_000;
   --  from the last byte of a command to the first byte of its answer
   Radio_Turnaround : constant Span := 45_000;
   --  the same through a pair of radios: in each direction three characters of
   --  silence and at most 12 ms of air, then the bytes once more, of a longest
   --  command and a short answer; the robot at once
   Radio_Time_Out   : constant Span := 150_000;
   --  --answer-timeout by radio
   Radio_Interval   : constant Positive_Span := 200_000;
   --  between two commands of the monitor by radio

   Wake_Latency     : constant Span := 200;
   --  of the kernel, from the event to the task's first instruction, while
   --  no task of ours is in the way. PREEMPT_RT, or a kernel as prompt

   Message_Gap      : constant Span := 20_000;
   --  --message-gap, its default: before an unsolicited message
   Answer_Gap       : constant Span := 4_000;
   --  before an answer; and the time after which th_sendToMon looks whether
   --  there is one

   Cortex_A53_Factor : constant := 6;
   --  how much longer an A53 of 1.2 GHz takes than the second machine, see
   --  README.md

   --  Frames on the line, in bytes: text, checksum, end

   Short_Frame    : constant := 3;   --  one letter
   Stop_Frame     : constant := 5;   --  M=0
   Longest_Frame  : constant := 10;  --  M=-32768
   Mission_Frame  : constant := 9;
   --  M=-5000
   Probe_Frames   : constant := 5;
   --  a letter and what the answer to V is longer than the usual one

end Budgets;
