--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as a process: signals, failures, privileges.

with Ada.Directories;
with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Plain_Numbers;         use Plain_Numbers;
with Own_Process;
with Process_Facts;
with Programs;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;

procedure Process_Tests is

   Ends : constant String := ", ends 0, status moving 0";

   Stopped : constant String := ", stops" & Ends & ", closed";

   As_User : String renames Programs.As_User;

   procedure Need_Root is
   begin
      if Libc.Geteuid /= 0 then
         Skip ("only root can change its privileges");
      end if;
   end Need_Root;

   procedure Need_Real_Time is
   begin
      Need_Root;
      if not Own_Process.Real_Time_Allowed then
         Skip ("root has no real-time priorities here (CAP_SYS_NICE)");
      end if;
   end Need_Real_Time;

   procedure Need (Command, Reason : String) is
      --  Skips the test unless it can be run
   begin
      if Status_Of (Command) /= 0 then
         Skip (Reason);
      end if;
   end Need;

   procedure Expect_Copy
     (Options : String; Status : Integer; Text, Launcher : String) is
   begin
      Expect_Console (Options, Status, Text, Launcher,
                      Program => Programs.Copied_Supervisor);
   end Expect_Copy;

   procedure Too_Few_Threads is
      --  The limit of a user without other processes
      Alone   : constant String :=
        "setpriv --reuid=65533 --regid=65533 --clear-groups --inh-caps=-all"
        & " prlimit --nproc=";
      Refused : constant String := "fewer threads than it has tasks";
   begin
      Need_Root;
      for Limit of Words ("4 8 12") loop
         Expect_Copy ("--port 0", 1, Refused, Alone & Limit);
      end loop;
      Expect_Copy ("--check", 1, Refused, Alone & "4");
      Expect_Copy ("--version", 0, "destijl ", Alone & "1");
   end Too_Few_Threads;

   procedure Nobody_Listens (R : in out Rig) is
      Is_Refused : Boolean := False;
   begin
      begin
         Connect (R);
      exception
         when Failed =>
            Is_Refused := True;
      end;
      Check (Is_Refused, "somebody still listens");
   end Nobody_Listens;

   procedure Expect_Deadlines (S : Supervisor; Claim : String) is
      --  Claimed where all that they need is there
   begin
      S.Expect_Log ("deadlines: ");
      Check (not S.Says ("ceilings act; memory: locked")
             or else S.Says ("deadlines: as analysed " & Claim),
             "not what is claimed: " & S.Text);
   end Expect_Deadlines;

   procedure Own_Processor is
      --  --cpu: the real-time tasks there alone, all others elsewhere

      procedure Expect (Option, Processor : String) is
         R : Rig;
      begin
         Assemble (R, Supervisor_Options => Option);
         for Name of Words (Process_Facts.Thread_Names (R.Supervisor.Pid)) loop
            declare
               Where : constant String :=
                 Process_Facts.Processors (R.Supervisor.Pid, Name);
            begin
               Check
                 ((if Name in "th_captureImg" | "th_arene" | "th_camera"
                            | "th_console"
                     or else Index (Name, "th_") /= 1
                   then Where not in "" | Processor
                     and then Index (Where, Processor) = 0
                   else Where = Processor),
                  Option & ": " & Name & " runs on " & Where);
            end;
         end loop;
         Expect_Deadlines
           (R.Supervisor, "with --cpu, on processor " & Processor);
         R.Monitor.Expect ("ROPN", "AACK");
      end Expect;

      Allowed : constant String :=
        Process_Facts.File_Line ("/proc/self/status", "Cpus_allowed_list");
   begin
      Expect_Console ("--port 0 --cpu 1023", 1, "no processor 1023");
      if Index (Allowed, Ada.Strings.Maps.To_Set (",-")) = 0 then
         Skip ("there is one processor only");
      end if;
      Expect ("--cpu 0", "0");
      Expect ("--cpu auto",
              Allowed
                (1 + Index (Allowed, Ada.Strings.Maps.To_Set (",-" & ASCII.HT),
                            Going => Ada.Strings.Backward) .. Allowed'Last));
   end Own_Processor;

   procedure One_Processor (R : in out Rig) is
      --  Nothing to choose from: everything is there, asked or not
      Pid : constant int := R.Supervisor.Pid;
   begin
      if Process_Facts.Processors
           (Pid, Ada.Directories.Simple_Name (Programs.Supervisor)) /= "0"
      then
         Skip ("GNAT's run time, from 14 on, takes all processors");
      end if;
      Expect_Deadlines (R.Supervisor, "for one processor");
      for Name of Words (Process_Facts.Thread_Names (Pid)) loop
         Check (Process_Facts.Processors (Pid, Name) = "0",
                Name & " runs elsewhere");
      end loop;
      R.Monitor.Expect ("ROPN", "AACK");
   end One_Processor;

   procedure Failing_Task is
      --  The robot is stopped

      procedure Fail (Name : String) is
         R    : Rig;
         Time : Instant;
      begin
         Assemble (R);
         Play (R, Forward);
         Time := Now;
         R.Supervisor.Fail (Name);
         Check_Within (Now - Time, 5.0, "the end after a failure");
         Play (R, "status moving 0, seen M=0");
      exception
         when Occurrence : Failed | Too_Late =>
            Raise_Exception
              (Exception_Identity (Occurrence),
               Name & " fails: " & Exception_Message (Occurrence));
      end Fail;

      S      : Supervisor;
      Names  : Arguments;
      Unused : int;
   begin
      S.Start;
      Names := Words (Process_Facts.Thread_Names (S.Pid));
      --  the report's thirteen are among them
      for Name of Words
        ("th_server th_receiveFromMon th_sendToMon th_comMonPerdue"
         & " th_cameraControl th_captureImg th_arene th_openComRobot"
         & " th_startRobot th_startRobotWD th_resetRobot th_move"
         & " th_batteryLevel")
      loop
         Unused := Process_Facts.Thread_Named (S.Pid, Name);
      end loop;
      S.Stop;
      --  the environment task has the program's name
      Fail (Ada.Directories.Simple_Name (Programs.Supervisor));
      for Name of Names loop
         if Index (Name, "th_") = 1 then
            Fail (Name);
         end if;
      end loop;
   end Failing_Task;

   procedure Crashing_Library is
      --  Which an image has reached, while the robot moves

      procedure Crash (How : String; Status : Integer) is
         R    : Rig;
         Path : constant String := Programs.Temporary_Folder & "/crash";
         Time : Instant;
      begin
         Assemble (R, Camera => True,
                   Launcher => Programs.Preload ("libcrashing_decoder.so")
                     & " CRASH_FILE=" & Path & " CRASH=" & How);
         Play (R, With_Images & ", " & Forward);
         Time := Now;
         Check (Programs.New_File ("crash", "") = Path, Path);
         R.Supervisor.Expect_Exit (Status);
         Ada.Directories.Delete_File (Path);
         Play (R, "status moving 0");
         Check_Within (R.Emulator.Await_On_Wire ("M=0").First - Time, 0.2,
                       How & ": the stop");
      end Crash;

   begin
      for How of Words ("abort free fault stack thread exit") loop
         Crash (How, (if How in "abort" | "free" then 128 + 6   --  SIGABRT
                      elsif How = "exit" then 3 else 128 + 11));  --  SIGSEGV
      end loop;
   end Crashing_Library;

   Killed : constant String :=
     Forward & ", signal 9, ends 137, status moving 1, clear";

   procedure Option_Stop (R : in out Rig) is
   begin
      Expect_Console
        ("--stop --serial " & R.Emulator.Device, 0,
         "the robot was sent a stop on " & R.Emulator.Device);
      Play (R, "status moving 0");
      Expect_Console ("--stop --serial /no/such", 1,
                      "no stop was sent on /no/such: No such file");
   end Option_Stop;

   procedure Started_While_Moving (R : in out Rig) is
      --  Before anybody opens the line; nothing else is sent
   begin
      R.Supervisor.Start ("--serial " & R.Emulator.Device);
      Play (R, "status moving 0, said the robot was sent a stop on "
            & R.Emulator.Device & ", sent M=0 1");
      Check (R.Emulator.Journal.Last_Index = 1,
             "not only a stop: " & R.Emulator.Wire_Text);
      Play (R, "connect, " & Initial & ", " & Started);
   end Started_While_Moving;

   procedure Hundred_Connections (R : in out Rig) is
      Before : Process_Facts.Footprint;
   begin
      for Number in 1 .. 160 loop
         Play (R, "connect, "
               & (if Number mod 2 = 0 then Guarded else Started)
               & (if Number mod 10 = 0 then ", " & With_Positions else ""));
         if Number = 10 then
            --  each frame slot gets the memory of an image, once
            R.Monitor.Await ("CIMG", 40);
         end if;
         Play (R, "RGFW AACK, "
               & (case Number mod 3 is
                     when 0      => "close, over",
                     when 1      => "reset, over",
                     when others => "part RS, close, over"));
         if Number = 60 then
            Before := Process_Facts.Footprint_Of (R.Supervisor.Pid);
         end if;
      end loop;
      Process_Facts.Expect_Flat (R.Supervisor.Pid, Before);
   end Hundred_Connections;

   procedure Memory_Locked is
      --  Where the process may: by privilege, or by a limit that is none

      A_Library : constant := 1_024;
      --  Kilobytes: some lock a little for themselves

      procedure Expect (Launcher : String; Locked : Boolean) is
         R    : Rig;
         Size : Natural;
      begin
         Start (R, Launcher => Launcher,
                Program => Programs.Copied_Supervisor);
         R.Supervisor.Expect_Log
           ((if Locked then "memory: locked" else "memory: not locked"));
         Size := Process_Facts.Locked_Kilobytes (R.Supervisor.Pid);
         Check ((Size > A_Library) = Locked,
                Launcher & ":" & Size'Image & " kB locked");
         Check
           (not Locked
            or else Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)
              < Size / 2,
            Launcher & ": all of the libraries is in memory");
         R.Monitor.Expect ("RPIN", "ANAK");
      end Expect;

      Without_Limit : constant String :=
        "prlimit --memlock=unlimited:unlimited ";
      A_Little      : constant String :=
        "prlimit --memlock=8388608:8388608 ";
   begin
      Need_Root;
      Need ("setpriv --inh-caps=+ipc_lock true",
            "root may not lock memory here (CAP_IPC_LOCK)");
      Expect (A_Little & As_User, Locked => False);
      Expect (A_Little & "setpriv --bounding-set=-ipc_lock", Locked => False);
      Expect (A_Little & "setpriv --no-new-privs", Locked => True);
      Need (Without_Limit & "true",
            "nobody may raise the limit here; all else was well");
      Expect (Without_Limit & As_User, Locked => True);
   end Memory_Locked;

   procedure Drive_As_User (R : in out Rig; Start : String) is
      --  Another user's pseudo-terminal cannot be opened: it is given away
   begin
      Need_Root;
      R.Emulator.Start (Camera => True);
      Check (Libc.Chown (To_C (R.Emulator.Status ("device")), 65_534, 65_534)
             = 0, "the device cannot be given away");
      Rigs.Start
        (R,
         "--serial " & R.Emulator.Device & " --camera "
         & R.Emulator.Camera_Url,
         Launcher => As_User, Program => Programs.Copied_Supervisor);
      Play (R, Start & ", " & With_Positions & ", RGFW AACK, CASA CIMG");
   end Drive_As_User;

   procedure As_Ordinary_User is
      R : Rig;
   begin
      Drive_As_User (R, Started);
      Play (R, "clear, signal 15, ends 0, seen M=0");
   end As_Ordinary_User;

   procedure Windows_Of_Ordinary_User is
      --  One of five may be missed on a busy machine
      R : Rig;
   begin
      Drive_As_User (R, Guarded);
      delay 5.0;
      Check_In_Time
        (R.Emulator.Status_Number ("missed_total") <= 1, "missed windows");
   end Windows_Of_Ordinary_User;

   procedure With_File_Capability is
      --  An ordinary user's priorities, by the program's own capability; the
      --  linker searches in fewer places then, and finds the camera part
      R    : Rig;
      Copy : constant String := Programs.Temporary_Folder & "/capable";
   begin
      Need_Real_Time;
      Need ("which setcap", "there is no setcap here");
      Ada.Directories.Copy_File (Programs.Copied_Supervisor, Copy);
      Need ("setcap cap_sys_nice+ep " & Copy,
            "this file system keeps no capabilities");
      Check (Libc.Chmod (To_C (Copy), 8#755#) = 0, "the copy cannot be run");
      R.Emulator.Start (Camera => True);
      Start (R, "--camera " & R.Emulator.Camera_Url, As_User, Copy);
      R.Supervisor.Expect_Log ("real-time priorities: FIFO, ceilings");
      Play (R, With_Images & ", signal 15, ends 0");
   end With_File_Capability;

   procedure Restarted_At_Once (R : in out Rig) is
      --  On the same port, although connections of the first still linger
      Number : constant Positive := R.Supervisor.Port;
   begin
      R.Supervisor.Start ("--serial " & R.Emulator.Device, Port => Number);
      Play (R, "connect, ROPN AACK");
   end Restarted_At_Once;

   procedure Expect_Priorities (Launcher, Says : String) is
      --  They act for all tasks or for none, and ceilings do or do not, as the
      --  start says: by a violation. The supervisor says the same in one line
      With_Ceilings : constant Boolean := Says = "FIFO, ceilings";
      Test          : Child;
      R             : Rig;
      Real_Time     : Natural;
   begin
      Test.Launch
        ("env " & Launcher & " "
         & Programs.Copied (Programs.Beside ("ceiling_violation")));
      Check
        (Test.Exit_Status = 0
         and then Test.Says ("said: " & Says, From => Output)
         and then Test.Says
           ("seen: "
            & (if With_Ceilings then "Program_Error" else "no exception"),
            From => Output),
         "not so: " & Launcher & ": " & Test.Text (Output));
      Start (R, Launcher => Launcher, Program => Programs.Copied_Supervisor);
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Supervisor.Expect_Log ("real-time priorities: " & Says);
      Check (R.Supervisor.Count_Of ("priorities") = 1,
             "not in one line: " & R.Supervisor.Text);
      Real_Time := Process_Facts.Real_Time_Threads (R.Supervisor.Pid);
      Check
        (Real_Time = (if Index (Says, "FIFO") = 1
                      then Process_Facts.Threads (R.Supervisor.Pid) else 0),
         Launcher & ":" & Real_Time'Image & " real-time threads");
   end Expect_Priorities;

   Not_Permitted : constant String := "none (no CAP_SYS_NICE";
   Refused       : constant String := "none (refused";

   procedure With_Ceilings is
   begin
      Need_Real_Time;
      Expect_Priorities ("setpriv --no-new-privs", "FIFO, ceilings");
      Expect_Priorities (Programs.As_Service, "FIFO, ceilings");
   end With_Ceilings;

   procedure Without_Ceilings is
      --  Nor as root, or with the capability, of a namespace of users, for
      --  which Linux gives no priorities
      Is_Root      : constant Boolean := Libc.Geteuid = 0;
      In_Namespace : constant String :=
        (if Is_Root then As_User & " " else "") & "unshare --user ";
   begin
      Expect_Priorities ((if Is_Root then As_User else "env"), Not_Permitted);
      if Is_Root then
         Expect_Priorities
           ("setpriv --bounding-set=-sys_nice --inh-caps=-sys_nice",
            Not_Permitted);
      end if;
      Need (In_Namespace & "true",
            "no namespace of users can be made here; all else was well");
      Expect_Priorities (In_Namespace & "--map-root-user", Refused);
      Expect_Priorities
        (In_Namespace & "--map-user=65534 --keep-caps", Refused);
   end Without_Ceilings;

   procedure Refused_By_Filter is
      --  Nor does --check advise what would not help, and --version needs none
      Filter : constant String := Programs.Copied
        (Ada.Directories.Containing_Directory
           (Ada.Directories.Containing_Directory
              (Programs.Beside ("system_tests")))
         & "/tests/system/refuse_real_time");
   begin
      Need_Real_Time;
      Expect_Priorities (Filter, Refused);
      Expect_Priorities (Programs.As_Service & " " & Filter, Refused);
      Expect_Console
        ("--version", 0, "destijl ", Launcher => Filter);
      Check
        (Index
           (Console ("--check", 1, Launcher => Filter),
            "run as root") = 0,
         "--check advises to run as root");
   end Refused_By_Filter;

   procedure Refused_By_Group is
      --  A control group has no run time for real-time tasks until it is given
      --  some
      All_Groups : constant String := "/sys/fs/cgroup/cpu";
      Group      : constant String :=
        All_Groups & "/"
        & Ada.Directories.Simple_Name (Programs.Temporary_Folder);
      Launcher   : constant String := Programs.New_File
        ("without_run_time",
         "#!/bin/sh" & ASCII.LF & "echo $$ >" & Group & "/cgroup.procs || exit"
         & ASCII.LF & "exec ""$@""" & ASCII.LF, Mode => 8#755#);

      procedure Remove_Group is
      begin
         --  the kernel needs a moment to notice that it is empty
         Check (Status_Of ("timeout|10|sh|-c|until rmdir " & Group
                           & "; do sleep 0.1; done", '|') = 0,
                "a control group is left behind");
      end Remove_Group;

   begin
      Need_Real_Time;
      if not Ada.Directories.Exists (All_Groups & "/cpu.rt_runtime_us") then
         Skip ("no groups with run time here (CONFIG_RT_GROUP_SCHED)");
      end if;
      Ada.Directories.Create_Directory (Group);
      begin
         Expect_Priorities (Launcher, Refused);
         Expect_Console ("--version", 0, "destijl ", Launcher);
      exception
         when others =>
            Remove_Group;
            raise;
      end;
      Remove_Group;
   end Refused_By_Group;

   procedure By_Limit is
      --  By a limit below the tasks' highest priority none has one; by one
      --  below the highest of Linux there are no ceilings
      Limits : constant array (1 .. 6) of Positive := (3, 20, 35, 36, 98, 99);
   begin
      Need_Root;
      Need ("prlimit --rtprio=99:99 true",
            "nobody may raise the limit of priorities here");
      for Limit of Limits loop
         Expect_Priorities
           ("prlimit --rtprio=" & Image (Limit) & ":" & Image (Limit) & " "
            & As_User,
            (case Limit is
                when 1 .. 35  => Not_Permitted,
                when 36 .. 98 => "FIFO, no ceilings",
                when others   => "FIFO, ceilings"));
      end loop;
   end By_Limit;

   procedure Console_Blocked (R : in out Rig) is
      --  Nobody reads the log: its pipe is full after 64 kB
      Count : constant := 3_000;
   begin
      R.Supervisor.Ignore_Errors;
      Play (R, Started);
      R.Monitor.Send
        (Count * ("RPIN" & ASCII.LF & "worth a line" & ASCII.LF));
      for Number in 1 .. Count loop
         Check_Label (R.Monitor.Next_Answer, "AACK", "RPIN" & Number'Image);
         Check_Label (R.Monitor.Next_Answer, "ACER", "after" & Number'Image);
      end loop;
      Play (R, "RGFW AACK, clear, signal 15, seen M=0" & Ends);
   end Console_Blocked;

   procedure Console_Monitor (R : in out Rig) is
      --  The project's own monitor drives the robot from a script
      Script : constant String := Programs.New_File
        ("script", Translate ("ROPN RSWW COPN RMOV:50 RGBT RSTP CCLS RCLS ",
         Ada.Strings.Maps.To_Mapping (" ", (1 => ASCII.LF))));
   begin
      Expect_Monitor (R.Supervisor.Port, "",
                      "--host 127.0.0.1 --script " & Script, 0);
      Play (R, "sent M=50 1");
   end Console_Monitor;

begin
   for Signal of Words ("15 2 3 10 12 14 20 24 26 30 40 64") loop
      --  SIGTERM, SIGINT, Ctrl-\, SIGUSR1, SIGUSR2, SIGALRM, Ctrl-Z, SIGXCPU,
      --  SIGVTALRM, SIGPWR, two of real time
      Script ("Stop_By_Signal_" & Signal & "_While_Moving",
              Forward & ", signal " & Signal & Stopped,
              In_Time => Signal in "15" | "2");
   end loop;
   Script ("Stop_Not_By_Ignored_Hang_Up",
           "ROPN AACK, signal 1, signal 13, signal 21, signal 22, signal 25,"
           & " signal 32, signal 33, RPIN AACK",
           Launcher => "nohup");
   --  Where it is ignored; nor by a limit of a file or a terminal, nor by the
   --  signals that glibc has for itself
   Add ("Threads_Too_Few", Too_Few_Threads'Access);
   Script ("Stop_With_Camera_And_Watchdog",
           Guarded & ", " & With_Positions & ", RGFW AACK, signal 15"
           & Ends & ", status viewers 0", Camera => True, In_Time => True);
   Script ("Stop_While_Robot_Is_Silent",
           Forward & ", tell silent on, signal 15" & Ends, In_Time => True);
   --  It is sent although nothing answers
   Script ("Stop_While_Camera_Stalls",
           With_Images & ", " & Forward & ", tell camera stall, wait 0.3,"
           & " signal 15" & Ends, Camera => True, In_Time => True);
   Script ("Stop_With_Stalled_Monitor",
           With_Images & ", " & Forward & ", pause, wait 1.5, signal 15"
           & Ends, Camera => True, In_Time => True);
   Script ("Stop_At_Once", "signal 2, signal 15" & Ends, Nobody_Listens'Access,
           Connected => False, In_Time => True);
   --  Without a session, and twice
   Add ("Never_Moves_On_After_A_Failed_Task",
        Failing_Task'Access, In_Time => True);
   Script ("Stop_By_Option_After_SIGKILL", Killed, Option_Stop'Access);
   Script ("Stop_By_The_Next_Start_After_SIGKILL", Killed,
           Started_While_Moving'Access);
   Add ("Never_Moves_On_After_A_Crash_In_A_Library",
        Crashing_Library'Access, In_Time => True);
   Add ("Threads_On_Their_Own_Processor", Own_Processor'Access);
   Script ("Threads_On_One_Processor", "", One_Processor'Access,
           Launcher => "taskset --cpu-list 0");
   Script ("Threads_On_One_Processor_Chosen", "", One_Processor'Access,
           Launcher => "taskset --cpu-list 0",
           Supervisor_Options => "--cpu auto");
   Script ("Never_Grows_In_100_Connections", "", Hundred_Connections'Access,
           Camera => True, Emulator_Options => "--baud 0",
           Connected => False);
   Script ("Restart_At_Once", "ROPN AACK, signal 15, ends 0",
           Restarted_At_Once'Access);
   Add ("Memory_Is_Locked_Where_It_May", Memory_Locked'Access);
   Add ("Privileges_By_File_Capability", With_File_Capability'Access);
   Add ("Privileges_Of_Ordinary_User", As_Ordinary_User'Access);
   Add ("Privileges_Of_Ordinary_User_Keep_Windows",
        Windows_Of_Ordinary_User'Access, Timed => True);
   Add ("Privileges_With_Ceilings", With_Ceilings'Access);
   Add ("Privileges_Without_Ceilings", Without_Ceilings'Access);
   Add ("Privileges_Refused_By_Group", Refused_By_Group'Access);
   Add ("Privileges_Refused_By_Filter", Refused_By_Filter'Access);
   Add ("Privileges_Limited", By_Limit'Access);
   Script ("Never_Waits_For_The_Console", "", Console_Blocked'Access,
           Supervisor_Options => "--log-level debug",
           Emulator_Options => "--baud 0", In_Time => True);
   Script ("Console_Monitor_Drives_The_Robot", "", Console_Monitor'Access,
           Camera => True, Connected => False);
end Process_Tests;
