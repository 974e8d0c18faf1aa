--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as a process: signals, failures, privileges.

with Ada.Directories;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Dialogues;             use Dialogues;
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
with Supervisors;

procedure Process_Tests is

   Ends : constant String := ", ends 0, status moving 0";

   Stopped : constant String := ", stops" & Ends & ", closed";

   As_User : String renames Programs.As_User;

   type Signals is array (Positive range <>) of int;

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

   procedure Need_Tool (Name : String) is
      use type GNAT.OS_Lib.String_Access;
      Tool : GNAT.OS_Lib.String_Access :=
        GNAT.OS_Lib.Locate_Exec_On_Path (Name);
   begin
      if Tool = null then
         Skip ("there is no " & Name & " here");
      end if;
      GNAT.OS_Lib.Free (Tool);
   end Need_Tool;

   procedure Not_Stopped_By_Hang_Up is
      --  Where it is ignored; nor by a limit of a file or a terminal, nor by
      --  the signals that glibc has for itself
      R : Rig;
   begin
      Assemble (R, Launcher => "nohup");
      R.Monitor.Expect ("ROPN", "AACK");
      for Signal of Signals'(Libc.Sighup, 13, 21, 22, 25, 32, 33) loop
         R.Supervisor.Send_Signal (Signal);
      end loop;
      R.Monitor.Expect ("RPIN", "AACK");
      Check (R.Supervisor.Is_Running, "it has ended");
   end Not_Stopped_By_Hang_Up;

   procedure Too_Few_Threads is
      --  The limit of a user without other processes
      Alone : constant String :=
        "setpriv --reuid=65533 --regid=65533 --clear-groups --inh-caps=-all"
        & " prlimit --nproc=";
   begin
      Need_Root;
      for Limit in 1 .. 3 loop
         Supervisors.Expect_Console
           ("--port 0", 1, "fewer threads than it has tasks",
            Launcher => Alone & Image (4 * Limit),
            Program  => Programs.Copied_Supervisor);
      end loop;
      Supervisors.Expect_Console
        ("--check", 1, "fewer threads than it has tasks",
         Launcher => Alone & "4", Program => Programs.Copied_Supervisor);
      Supervisors.Expect_Console
        ("--version", 0, "destijl ",
         Launcher => Alone & "1", Program => Programs.Copied_Supervisor);
   end Too_Few_Threads;

   procedure Stopped_At_Once is
      --  Without a session, and twice
      R : Rig;
   begin
      Assemble (R, Connected => False);
      Play (R, "signal 2, signal 15" & Ends);
      Check (not Connects (R.Supervisor.Port), "somebody still listens");
   end Stopped_At_Once;

   procedure Thirteen_Threads is

      --  The report's own, by the names that the kernel shows (15
      --  characters of each)
      S : Supervisors.Supervisor;
   begin
      S.Start;
      for Name of Words
        ("th_server th_receiveFromMon th_sendToMon th_comMonPerdue"
         & " th_cameraControl th_captureImg th_arene th_openComRobot"
         & " th_startRobot th_startRobotWD th_resetRobot th_move"
         & " th_batteryLevel")
      loop
         Check (Process_Facts.Thread_Named (S.Pid, Name) > 0,
                "no thread " & Name & " among"
                & Process_Facts.Thread_Names (S.Pid));
      end loop;
   end Thirteen_Threads;

   procedure Own_Processor is
      --  --cpu: the real-time tasks there alone, all others elsewhere
      Wrong : Supervisors.Supervisor;

      procedure Expect (Option, Processor : String) is
         R : Rig;

         function Where (Name : String) return String is
           (Process_Facts.Processors
              (R.Supervisor.Pid,
               Process_Facts.Thread_Named (R.Supervisor.Pid, Name)));
      begin
         Assemble (R, Supervisor_Options => Option);
         for Name of Words (Process_Facts.Thread_Names (R.Supervisor.Pid)) loop
            if Name in "th_captureImg" | "th_arene" | "th_camera"
                     | "th_console"
              or else Index (Name, "th_") /= 1
            then
               Check (Where (Name) not in "" | Processor
                      and then Index (Where (Name), Processor) = 0,
                      Option & ": " & Name & " runs on " & Where (Name));
            else
               Check (Where (Name) = Processor,
                      Option & ": " & Name & " runs on " & Where (Name));
            end if;
         end loop;
         R.Supervisor.Expect_Log ("deadlines: ");
         Check (not R.Supervisor.Says ("ceilings act; memory: locked")
                or else R.Supervisor.Says
                  ("deadlines: as analysed with --cpu, on processor "
                   & Processor),
                "not what is claimed: " & R.Supervisor.Log_Text);
         R.Monitor.Expect ("ROPN", "AACK");
      end Expect;

      Allowed : constant String :=
        Process_Facts.File_Line ("/proc/self/status", "Cpus_allowed_list");
   begin
      Wrong.Run ("--port 0 --cpu 1023");
      Check (Wrong.Exit_Status = 1, "a processor that is not there");
      Check (Index (Wrong.Log_Text, "no processor 1023") > 0,
             "no reason: " & Wrong.Log_Text);
      if Index (Allowed, Ada.Strings.Maps.To_Set (",-")) = 0 then
         Skip ("there is one processor only");
      end if;
      Expect ("--cpu 0", "0");
      Expect ("--cpu auto",
              Allowed
                (1 + Index (Allowed, Ada.Strings.Maps.To_Set (",-" & ASCII.HT),
                            Going => Ada.Strings.Backward) .. Allowed'Last));
   end Own_Processor;

   procedure One_Processor is
      --  Nothing to choose from: everything is there, asked or not

      procedure Expect (Option : String) is
         R : Rig;
      begin
         Assemble (R, Supervisor_Options => Option,
                   Launcher => "taskset --cpu-list 0");
         if Process_Facts.Processors (R.Supervisor.Pid, R.Supervisor.Pid)
           /= "0"
         then
            Skip ("GNAT's run time, from 14 on, takes all processors");
         end if;
         R.Supervisor.Expect_Log ("deadlines: ");
         Check (not R.Supervisor.Says ("ceilings act; memory: locked")
                or else R.Supervisor.Says
                  ("deadlines: as analysed for one processor"),
                "not what is claimed: " & R.Supervisor.Log_Text);
         for Name of Words (Process_Facts.Thread_Names (R.Supervisor.Pid)) loop
            Check
              (Process_Facts.Processors
                 (R.Supervisor.Pid,
                  Process_Facts.Thread_Named (R.Supervisor.Pid, Name)) = "0",
               Option & ": " & Name & " runs elsewhere");
         end loop;
         R.Monitor.Expect ("ROPN", "AACK");
      end Expect;
   begin
      Expect ("");
      Expect ("--cpu auto");
   end One_Processor;

   procedure Failing_Task is
      --  A task that fails unexpectedly: the robot is stopped, exit 3. The
      --  fault is a signal that the run time turns into an exception.

      procedure Fail (Name : String) is
         R      : Rig;
         Thread : int;
         Time   : Instant;
         Status : Integer;
      begin
         Assemble (R);
         Move_Forward (R);
         Thread := Process_Facts.Thread_Named (R.Supervisor.Pid, Name);
         Check (Thread > 0,
                "no thread " & Name & " among"
                & Process_Facts.Thread_Names (R.Supervisor.Pid));
         Time := Now;
         Check (Libc.Tgkill (R.Supervisor.Pid, Thread, Libc.Sigsegv) = 0,
                "the thread cannot be signalled");
         Status := R.Supervisor.Exit_Status;
         Check_Within (Now - Time, 5.0, "the end after a failure");
         Check (Status = 3,
                "exit status" & Status'Image & " after the failure of "
                & Name);
         R.Emulator.Await_Status ("moving", "0");
         Check (R.Emulator.Count_Of ("M=0") >= 1,
                "no stop on the wire after the failure of " & Name);
      end Fail;

      Names : Arguments;
   begin
      declare
         S : Supervisors.Supervisor;
      begin
         S.Start;
         Names := Words (Process_Facts.Thread_Names (S.Pid));
      end;
      Check (Natural (Names.Length) > 13, "the threads have no names");
      --  the environment task has the program's name
      Fail (Ada.Directories.Simple_Name (Programs.Supervisor));
      for Name of Names loop
         if Index (Name, "th_") = 1 then
            Fail (Name);
            Forget_Last_Lines;
         end if;
      end loop;
   end Failing_Task;

   procedure Crash_While_Moving (How : String; Status : Integer) is
      --  In a library, which an image has reached
      R    : Rig;
      Path : constant String := Programs.Temporary_Folder & "/crash";
      File : File_Type;
      Time : Instant;
      Seen : Integer;
   begin
      Assemble (R, Camera => True,
                Launcher => Programs.Preload ("libcrashing_decoder.so")
                  & " CRASH_FILE=" & Path & " CRASH=" & How);
      Open_Camera (R);
      Move_Forward (R);
      Time := Now;
      Create (File, Out_File, Path);
      Seen := R.Supervisor.Exit_Status;
      Delete (File);
      Check (Seen = Status, How & ": exit status" & Seen'Image);
      R.Emulator.Await_Status ("moving", "0");
      Check_Within (R.Emulator.Await_On_Wire ("M=0").First - Time, 0.2,
                    How & ": the stop");
      Forget_Last_Lines;
   end Crash_While_Moving;

   procedure Crashing_Library is
   begin
      for How of Words ("abort free fault stack thread exit") loop
         Crash_While_Moving
           (How, (if How in "abort" | "free" then 128 + 6   --  SIGABRT
                  elsif How = "exit" then 3 else 128 + 11));  --  SIGSEGV
      end loop;
   end Crashing_Library;

   procedure Kill_While_Moving (R : in out Rig) is
   begin
      Assemble (R);
      Move_Forward (R);
      R.Supervisor.Send_Signal (Libc.Sigkill);
      Check (R.Supervisor.Exit_Status = 128 + 9, "its end");
      Check (R.Emulator.Status ("moving") = "1", "the robot has stopped");
      R.Emulator.Clear_Journal;
   end Kill_While_Moving;

   procedure Option_Stop is
      R : Rig;
   begin
      Kill_While_Moving (R);
      Supervisors.Expect_Console
        ("--stop --serial " & R.Emulator.Device, 0,
         "the robot was sent a stop on " & R.Emulator.Device);
      R.Emulator.Await_Status ("moving", "0");
      Supervisors.Expect_Console
        ("--stop --serial /no/such", 1,
         "no stop was sent on /no/such: No such file");
   end Option_Stop;

   procedure Option_Print_Markers is
   begin
      Supervisors.Expect_Console
        ("--print-markers 999 --marker-size 20", 0, "999, frame 20 mm");
   end Option_Print_Markers;

   procedure Started_While_Moving is
      --  Before anybody opens the line; nothing else is sent
      R : Rig;
   begin
      Kill_While_Moving (R);
      R.Supervisor.Start ("--serial " & R.Emulator.Device);
      R.Emulator.Await_Status ("moving", "0");
      R.Supervisor.Expect_Log
        ("the robot was sent a stop on " & R.Emulator.Device);
      Check (R.Emulator.Count_Of ("M=0") = 1
             and then R.Emulator.Journal.Last_Index = 1,
             "not only a stop: " & R.Emulator.Wire_Text);
      Connect (R);
      Expect_Initial_State (R);
      Start_Robot (R);
   end Started_While_Moving;

   procedure Hundred_Connections is
      R           : Rig;
      Memory      : Natural := 0;
      Threads     : Natural := 0;
      Descriptors : Natural := 0;

      procedure Visit (Number : Positive) is
      begin
         Connect (R);
         Start_Robot (R, Watchdog => Number mod 2 = 0);
         if Number mod 10 = 0 then
            Open_Camera (R, Positions => True);
         end if;
         if Number = 10 then
            --  each frame slot gets the memory of an image, once
            for Image in 1 .. 40 loop
               Check (R.Monitor.Next_Of ("CIMG").Size > 0, "an image");
            end loop;
         end if;
         R.Monitor.Expect ("RGFW", "AACK");
         Play (R, (case Number mod 3 is
                      when 0      => "close, over",
                      when 1      => "reset, over",
                      when others => "part RS, close, over"));
      end Visit;

   begin
      Assemble (R, Camera => True, Emulator_Options => "--baud 0",
                Connected => False);
      for Number in 1 .. 60 loop
         Visit (Number);
      end loop;
      Memory := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
      Threads := Process_Facts.Threads (R.Supervisor.Pid);
      Descriptors := Process_Facts.Descriptors (R.Supervisor.Pid);
      for Number in 61 .. 160 loop
         Visit (Number);
      end loop;
      Note ("memory" & Memory'Image & " kB,"
            & Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)'Image
            & " kB;" & Threads'Image & " threads;" & Descriptors'Image
            & " descriptors");
      Check (Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)
             <= Memory + 1024,
             "memory grows from" & Memory'Image & " kB to"
             & Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)'Image);
      Check (Process_Facts.Threads (R.Supervisor.Pid) = Threads,
             "threads before and after differ");
      Check (Process_Facts.Descriptors (R.Supervisor.Pid) = Descriptors,
             "descriptors before and after differ");
   end Hundred_Connections;

   procedure Memory_Locked is
      --  Where the process may: by privilege, or by a limit that is none

      A_Library : constant := 1_024;
      --  Kilobytes: some lock a little for themselves

      procedure Expect (Launcher : String; Locked : Boolean) is
         R    : Rig;
         Size : Natural;
      begin
         R.Emulator.Start (Camera => False);
         R.Supervisor.Start
           ("--serial " & R.Emulator.Device,
            Launcher => Launcher, Program => Programs.Copied_Supervisor);
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
         Connect (R);
         R.Monitor.Expect ("RPIN", "ANAK");
      end Expect;

      As_Much_As_It_Likes : constant String :=
        "prlimit --memlock=unlimited:unlimited ";
      A_Little            : constant String :=
        "prlimit --memlock=8388608:8388608 ";
      Tool                : Child;
   begin
      Need_Root;
      Tool.Start ("setpriv", Words ("--inh-caps=+ipc_lock true"));
      if Tool.Exit_Status /= 0 then
         Skip ("root may not lock memory here (CAP_IPC_LOCK)");
      end if;
      Expect (A_Little & As_User, Locked => False);
      Expect (A_Little & "setpriv --bounding-set=-ipc_lock", Locked => False);
      Expect (A_Little & "setpriv --no-new-privs", Locked => True);
      Tool.Start ("prlimit", Words ("--memlock=unlimited:unlimited true"));
      if Tool.Exit_Status = 0 then
         Expect (As_Much_As_It_Likes & As_User, Locked => True);
      else
         Note ("not tried without a limit: nobody may raise it here");
      end if;
   end Memory_Locked;

   procedure Drive_As_User (R : in out Rig; Watchdog : Boolean := False) is
      --  Another user's pseudo-terminal cannot be opened: it is given away
   begin
      Need_Root;
      R.Emulator.Start (Camera => True);
      declare
         Device : constant String := R.Emulator.Status ("device");
      begin
         Check (Libc.Chown (To_C (Device), 65_534, 65_534) = 0,
                "the device cannot be given away");
      end;
      R.Supervisor.Start
        ("--serial " & R.Emulator.Device & " --camera "
         & R.Emulator.Camera_Url,
         Launcher => As_User, Program => Programs.Copied_Supervisor);
      Connect (R);
      Start_Robot (R, Watchdog);
      Open_Camera (R, Positions => True);
      R.Monitor.Expect ("RGFW", "AACK");
   end Drive_As_User;

   procedure As_Ordinary_User is
      R : Rig;
   begin
      Drive_As_User (R);
      R.Monitor.Expect ("CASA", "CIMG");
      R.Emulator.Clear_Journal;
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "exit status");
      Check (R.Emulator.Count_Of ("M=0") >= 1, "no stop on the wire");
   end As_Ordinary_User;

   procedure Windows_Of_Ordinary_User is
      --  One of five may be missed on a busy machine
      R : Rig;
   begin
      Drive_As_User (R, Watchdog => True);
      R.Monitor.Expect ("CASA", "CIMG");
      delay 5.0;
      Check_In_Time
        (R.Emulator.Status_Number ("missed_total") <= 1, "missed windows");
   end Windows_Of_Ordinary_User;

   procedure With_File_Capability is
      --  An ordinary user's priorities, by the program's own capability; the
      --  linker searches in fewer places then, and finds the camera part
      R    : Rig;
      Copy : constant String := Programs.Temporary_Folder & "/capable";
      Tool : Child;
   begin
      Need_Real_Time;
      Need_Tool ("setcap");
      Ada.Directories.Copy_File (Programs.Copied_Supervisor, Copy);
      Tool.Start ("setcap", Words ("cap_sys_nice+ep " & Copy));
      if Tool.Exit_Status /= 0 then
         Skip ("this file system keeps no capabilities");
      end if;
      Check (Libc.Chmod (To_C (Copy), 8#755#) = 0, "the copy cannot be run");
      R.Emulator.Start (Camera => True);
      R.Supervisor.Start ("--camera " & R.Emulator.Camera_Url,
                          Launcher => As_User, Program => Copy);
      R.Supervisor.Expect_Log ("real-time priorities: FIFO, ceilings");
      Connect (R);
      Open_Camera (R);
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "exit status");
   end With_File_Capability;

   procedure Restarted_At_Once is
      --  On the same port, although connections of the first still linger
      R      : Rig;
      Second : Supervisors.Supervisor;
      Number : Positive;
   begin
      Assemble (R);
      R.Monitor.Expect ("ROPN", "AACK");
      Number := R.Supervisor.Port;
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0, "exit status");
      Second.Start ("--serial " & R.Emulator.Device, Port => Number);
      R.Monitor.Connect (Number);
      R.Monitor.Expect ("ROPN", "AACK");
   end Restarted_At_Once;

   procedure Expect_Priorities (Launcher, Says : String) is
      --  They act for all tasks or for none, and ceilings do or do not, as the
      --  start says: by a violation. The supervisor says the same in one line
      With_Ceilings : constant Boolean := Says = "FIFO, ceilings";
      Test          : Child;
      R             : Rig;
      Real_Time     : Natural;
   begin
      Test.Start
        ("env",
         Words (Launcher & " "
                & Programs.Copied (Programs.Beside ("ceiling_violation"))));
      Check
        (Test.Exit_Status = 0
         and then Test.Awaited (Output, "said: " & Says) = 1
         and then Test.Awaited
           (Output,
            "seen: "
            & (if With_Ceilings then "Program_Error" else "no exception")) = 1,
         "not so: " & Launcher);
      R.Supervisor.Start
        (Launcher => Launcher, Program => Programs.Copied_Supervisor);
      Connect (R);
      R.Monitor.Expect ("RPIN", "ANAK");
      R.Supervisor.Expect_Log ("real-time priorities: " & Says);
      Check (R.Supervisor.Count_Of ("priorities") = 1,
             "not in one line: " & R.Supervisor.Log_Text);
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
      Tool         : Child;
   begin
      if Is_Root then
         Expect_Priorities (As_User, Not_Permitted);
         Expect_Priorities
           ("setpriv --bounding-set=-sys_nice --inh-caps=-sys_nice",
            Not_Permitted);
      else
         Expect_Priorities ("env", Not_Permitted);
      end if;
      Tool.Start ("env", Words (In_Namespace & "true"));
      if Tool.Exit_Status /= 0 then
         Skip ("no namespace of users can be made here; all else was well");
      end if;
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
      Supervisors.Expect_Console
        ("--version", 0, "destijl ", Launcher => Filter);
      Check
        (Index
           (Supervisors.Console ("--check", 1, Launcher => Filter),
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
      Launcher   : constant String :=
        Programs.Temporary_Folder & "/without_run_time";
      File       : File_Type;

      procedure Remove_Group is
         Tool : Child;
      begin
         --  the kernel needs a moment to notice that it is empty
         Tool.Start
           ("timeout",
            Words ("10|sh|-c|until rmdir " & Group & "; do sleep 0.1; done",
                   Separator => '|'));
         Check (Tool.Exit_Status = 0, "a control group is left behind");
      end Remove_Group;

   begin
      Need_Real_Time;
      if not Ada.Directories.Exists (All_Groups & "/cpu.rt_runtime_us") then
         Skip ("no groups with run time here (CONFIG_RT_GROUP_SCHED)");
      end if;
      Create (File, Out_File, Launcher);
      Put_Line (File, "#!/bin/sh");
      Put_Line (File, "echo $$ >" & Group & "/cgroup.procs || exit");
      Put_Line (File, "exec ""$@""");
      Close (File);
      Check (Libc.Chmod (To_C (Launcher), 8#755#) = 0, "cannot be run");
      Ada.Directories.Create_Directory (Group);
      begin
         Expect_Priorities (Launcher, Refused);
         Supervisors.Expect_Console
           ("--version", 0, "destijl ", Launcher => Launcher);
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
      procedure Expect (Limit : Positive; Says : String) is
      begin
         Expect_Priorities
           ("prlimit --rtprio=" & Image (Limit) & ":" & Image (Limit) & " "
            & As_User, Says);
      end Expect;
      Tool : Child;
   begin
      Need_Root;
      Tool.Start ("prlimit", Words ("--rtprio=99:99 true"));
      if Tool.Exit_Status /= 0 then
         Skip ("nobody may raise the limit of priorities here");
      end if;
      Expect (3, Not_Permitted);
      Expect (20, Not_Permitted);
      Expect (35, Not_Permitted);
      Expect (36, "FIFO, no ceilings");
      Expect (98, "FIFO, no ceilings");
      Expect (99, "FIFO, ceilings");
   end By_Limit;

   procedure Console_Blocked is
      --  Nobody reads the log: its pipe is full after 64 kB
      Count : constant := 3_000;
      R     : Rig;
   begin
      Assemble (R, Supervisor_Options => "--log-level debug",
                Emulator_Options => "--baud 0");
      R.Supervisor.Ignore_Log;
      Start_Robot (R);
      for Number in 1 .. Count loop
         R.Monitor.Send
           ("RPIN" & ASCII.LF & "nonsense that is worth a line" & ASCII.LF);
      end loop;
      for Number in 1 .. Count loop
         Check_Label (R.Monitor.Next_Answer, "AACK", "RPIN" & Number'Image);
         Check_Label (R.Monitor.Next_Answer, "ACER", "after" & Number'Image);
      end loop;
      Play (R, "RGFW AACK, clear, signal 15, seen M=0" & Ends);
   end Console_Blocked;

   procedure Console_Monitor is
      --  The project's own monitor drives the robot from a script
      R       : Rig;
      Tool    : Child;
      File    : File_Type;
      Script  : constant String := Programs.Temporary_Folder & "/script";
   begin
      Assemble (R, Camera => True, Connected => False);
      Create (File, Out_File, Script);
      for Line of Words ("ROPN RSWW COPN RMOV:50 RGBT RSTP CCLS RCLS") loop
         Put_Line (File, Line);
      end loop;
      Close (File);
      Tool.Start
        (Programs.Monitor,
         Words ("--host 127.0.0.1 --port"
           & Positive'Image (R.Supervisor.Port) & " --script " & Script),
         "console monitor");
      Check (Tool.Exit_Status = 0, "the console monitor has failed");
      Check (R.Emulator.Count_Of ("M=50") = 1, "no M=50 on the wire");
   end Console_Monitor;

begin
   for Signal of Words ("15 2 3 10 12 14 20 24 26 30 40 64") loop
      --  SIGTERM, SIGINT, Ctrl-\, SIGUSR1, SIGUSR2, SIGALRM, Ctrl-Z, SIGXCPU,
      --  SIGVTALRM, SIGPWR, two of real time
      Script ("Stop_By_Signal_" & Signal & "_While_Moving",
              Forward & ", signal " & Signal & Stopped,
              In_Time => Signal in "15" | "2");
   end loop;
   Add ("Stop_Not_By_Ignored_Hang_Up", Not_Stopped_By_Hang_Up'Access);
   Add ("Threads_Too_Few", Too_Few_Threads'Access);
   Script ("Stop_With_Camera_And_Watchdog",
           "ROPN AACK, RSWW AACK, " & With_Positions & ", RGFW AACK, signal 15"
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
   Add ("Stop_At_Once", Stopped_At_Once'Access, In_Time => True);
   Add ("Threads_Are_The_Reports_Thirteen", Thirteen_Threads'Access);
   Add ("Never_Moves_On_After_A_Failed_Task",
        Failing_Task'Access, In_Time => True);
   Add ("Stop_By_Option_After_SIGKILL", Option_Stop'Access);
   Add ("Print_Markers_By_Option", Option_Print_Markers'Access);
   Add ("Stop_By_The_Next_Start_After_SIGKILL", Started_While_Moving'Access);
   Add ("Never_Moves_On_After_A_Crash_In_A_Library",
        Crashing_Library'Access, In_Time => True);
   Add ("Threads_On_Their_Own_Processor", Own_Processor'Access);
   Add ("Threads_On_One_Processor", One_Processor'Access);
   Add ("Never_Grows_In_100_Connections", Hundred_Connections'Access);
   Add ("Restart_At_Once", Restarted_At_Once'Access);
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
   Add ("Never_Waits_For_The_Console",
        Console_Blocked'Access, In_Time => True);
   Add ("Console_Monitor_Drives_The_Robot", Console_Monitor'Access);
end Process_Tests;
