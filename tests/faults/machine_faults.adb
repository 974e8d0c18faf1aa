--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults caused by the machine and its administrator.

with Ada.Directories;       use Ada.Directories;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with Interfaces.C;          use Interfaces.C;
with System.Multiprocessors;

with Busy_Loops;
with Expectations;          use Expectations;
with Faults;                use Faults;
with Libc;
with Monitor_Clients;
with Own_Process;
with Process_Facts;
with Programs;
with Random_Numbers;        use Random_Numbers;
with Supervisors;
with Tolerances;            use Tolerances;
with Worlds;                use Worlds;

package body Machine_Faults is

   --  Signals

   type Stopping is new Fault with record
      Signal : int := Libc.Sigterm;
   end record;

   overriding procedure Inject (F : in out Stopping; W : in out World);

   --  Standard error

   type Bad_Error_Kind is (All_Closed, Closed, Full_Device, Full_Disk);

   type Bad_Error is new Fault with record
      Kind : Bad_Error_Kind := Closed;
   end record;
   --  It is so from the start

   overriding procedure Prepare (F : Bad_Error; P : in out Plan);
   overriding procedure Inject (F : in out Bad_Error; W : in out World);

   --  Privileges

   type Privilege_Kind is (Root, User, User_With_Nice, Root_Without_Nice);

   type Started_As is new Fault with record
      Kind : Privilege_Kind := Root;
   end record;

   overriding procedure Prepare (F : Started_As; P : in out Plan);
   overriding procedure Inject (F : in out Started_As; W : in out World);

   function Is_Root return Boolean is (Libc.Geteuid = 0);

   Clock_Library : constant String := "libclock_shift.so";
   --  Beside the running program

   Pipe_File : int := -1;

   function Script (Name : String; Text : String) return Unbounded_String is
      --  A shell script of this run with Text as its lines, that runs its
      --  arguments; its path
      Path   : constant String := Programs.Temporary_Folder & "/" & Name;
      File   : File_Type;
      Unused : int;
   begin
      if not Exists (Path) then
         Create (File, Out_File, Path);
         Put_Line (File, "#!/bin/sh");
         Put_Line (File, Text);
         Close (File);
         Unused := Libc.Chmod (To_C (Path), 8#755#);
      end if;
      return To_Unbounded_String (Path);
   end Script;

   function Pipe return String is
      --  The named pipe that stands for standard error; made at its first use
      Path : constant String := Programs.Temporary_Folder & "/log";
   begin
      if Pipe_File < 0 then
         Check (Libc.Mkfifo (To_C (Path), 8#600#) = 0, "no pipe to be had");
         --  for reading and writing: so no open waits for the other end
         Pipe_File := Libc.Open
           (To_C (Path), Libc.O_Rdwr + Libc.O_Nonblock + Libc.O_Cloexec);
      end if;
      return Path;
   end Pipe;

   function Drained return Natural is
      --  Takes all that is in it; how many bytes that was
      Buffer : String (1 .. 4_096);
      Size   : long;
      Result : Natural := 0;
   begin
      loop
         Size := Libc.Read (Pipe_File, Buffer'Address, Buffer'Length);
         exit when Size <= 0;
         Result := Result + Natural (Size);
      end loop;
      return Result;
   end Drained;

   function Clock_File return String is
     (Programs.Temporary_Folder & "/clock");
   --  An offset of the supervisor's wall clock, in seconds

   procedure Set_Shift (Seconds : Long_Long_Integer) is
      Size   : constant := 8;
      Value  : aliased constant Long_Long_Integer := Seconds;
      File   : File_Type;
      Place  : int;
      Unused : int;
   begin
      if not Exists (Clock_File) then
         Create (File, Out_File, Clock_File);
         Close (File);
      end if;
      Place := Libc.Open (To_C (Clock_File), Libc.O_Wronly + Libc.O_Cloexec);
      Check
        (Libc.Write (Place, Value'Address, Size) = Size,
         "the clock cannot be set");
      Unused := Libc.Close (Place);
   end Set_Shift;

   overriding procedure Inject (F : in out Stopping; W : in out World) is
   begin
      W.Listen;
      W.Supervisor.Send_Signal (F.Signal);
      W.Nobody_In_Command (Within => Stop_Limit);
      W.Supervisor_Ends (Status => 0);
      if Chance (W.Source, 3) and then W.Supervisor.Is_Running then
         --  an impatient user
         W.Supervisor.Send_Signal (F.Signal);
      end if;
   end Inject;

   procedure Break_Pipes (W : in out World) is
   begin
      for Number in 1 .. Whole (W.Source, 1, 20) loop
         W.Supervisor.Send_Signal (Libc.Sigpipe);
         W.Talk (Span (W.Source, 0.0, 0.02), Calm => True);
      end loop;
   end Break_Pipes;

   procedure Kill (W : in out World) is
   begin
      W.Listen;
      if W.Present and then W.Line_Works
        and then W.Robot /= Moving_With_Watchdog
      then
         --  one without it would drive on
         W.Order ("RCLS", "AACK ANAK");
         W.Bring_To (Moving_With_Watchdog);
         W.Talk (Span (W.Source, 0.0, 1.5), Calm => True);
      end if;
      W.Supervisor.Send_Signal (Libc.Sigkill);
      W.Supervisor_Ends (Status => 128 + Integer (Libc.Sigkill));
      --  by itself: nothing on the line causes it
      W.Expect_Status
        ("moving", "0", Within => Watchdog_Limit + Noise);
      W.Robot_Ready := False;
   end Kill;

   overriding procedure Prepare (F : Bad_Error; P : in out Plan) is
   begin
      P.Log_Is_Read := False;
      P.Launcher :=
        (case F.Kind is
            when All_Closed  =>
               Script ("all_closed", "exec ""$@"" <&- >&- 2>&-"),
            when Closed      => Script ("closed", "exec ""$@"" 2>&-"),
            when Full_Device =>
               Script ("full_device", "exec ""$@"" 2>/dev/full"),
            when Full_Disk   =>
               Script
                 ("full_disk",
                  "set -e" & ASCII.LF
                  & "disk=$(dirname ""$0"")/disk" & ASCII.LF
                  & "if [ ""$1"" != --mounted ]; then" & ASCII.LF
                  & "   mkdir -p ""$disk""" & ASCII.LF
                  & "   unshare --mount --propagation private true"
                  & " 2>/dev/null ||" & ASCII.LF
                  & "      exec ""$@"" 2>/dev/full" & ASCII.LF
                  & "   exec unshare --mount --propagation private"
                  & " ""$0"" --mounted ""$@""" & ASCII.LF
                  & "fi" & ASCII.LF
                  & "shift" & ASCII.LF
                  & "mount -t tmpfs -o size=4k tmpfs ""$disk""" & ASCII.LF
                  & "exec ""$@"" 2>""$disk/log"""));
   end Prepare;

   overriding procedure Inject (F : in out Bad_Error; W : in out World) is
      Standard_Error : constant := 2;
      Error_File     : constant String :=
        Process_Facts.Open_File (W.Pid, Standard_Error);
   begin
      if F.Kind = Full_Disk and then not Is_Root then
         Skip ("only root can make a file system of 4 kB");
      elsif F.Kind = Full_Disk and then Error_File = "/dev/full" then
         Skip ("no namespace for mounts here, or / is no mount point");
      end if;
      --  if closed, no other file may get its descriptor
      Check
        (Error_File =
           (case F.Kind is
               when Closed | All_Closed => "/dev/null",
               when Full_Device         => "/dev/full",
               when Full_Disk           =>
                  Programs.Temporary_Folder & "/disk/log"),
         "its standard error is " & Error_File);
      --  each produces a log line
      for Number in 1 .. Whole (W.Source, 1, 200) loop
         W.Say ("nonsense");
      end loop;
      W.Talk (Span (W.Source, 0.0, 0.5));
   end Inject;

   --  The pipe fills up, and is read again later

   procedure Prepare_Pipe (P : in out Plan) is
   begin
      P.Log_Is_Read := False;
      P.Launcher := Script ("pipe", "exec ""$@"" 2>'" & Pipe & "'");
   end Prepare_Pipe;

   procedure Fill_Pipe (W : in out World) is
      Zeros : constant String (1 .. 4_096) := (others => ASCII.NUL);
   begin
      Check (Drained > 0, "the log does not go to the pipe");
      while Libc.Write (Pipe_File, Zeros'Address, Zeros'Length) > 0 loop
         null;
      end loop;
      --  a line of the log may have left room in its page
      while Libc.Write (Pipe_File, Zeros'Address, 1) > 0 loop
         null;
      end loop;
      for Number in 1 .. Whole (W.Source, 1, 600) loop
         W.Say ("nonsense");
      end loop;
      W.Talk (Span (W.Source, 0.0, 0.5));
      if Chance (W.Source, 3) then
         W.Expect_Answers;
         W.Lose (Orderly);
         W.Try_To_Join;
      end if;
   end Fill_Pipe;

   procedure Empty_Pipe (W : in out World) is
      pragma Unreferenced (W);
      Unused : constant Natural := Drained;
   begin
      null;
   end Empty_Pipe;

   --  The machine's clock is not changed. A library preloaded before the C
   --  library reports another time to the supervisor only. A deadline computed
   --  from it is then an hour off for the kernel: this detects a dependence
   --  more reliably than a real change, which only affects waits in progress.

   procedure Prepare_Clock (P : in out Plan) is
   begin
      if not Exists (Clock_File) then
         Set_Shift (0);
      end if;
      if Exists (Programs.Beside (Clock_Library)) then
         P.Launcher := To_Unbounded_String
           (Programs.Preload (Clock_Library) & " CLOCK_SHIFT=" & Clock_File);
      end if;
   end Prepare_Clock;

   procedure Set_Clock (W : in out World) is
      Hour : constant := 3_600;
      Year : constant := 365 * 24 * Hour;
   begin
      if not Exists (Programs.Beside (Clock_Library)) then
         Skip ("there is no " & Clock_Library);
      end if;
      Check
        (Process_Facts.Has_Mapped (W.Pid, Clock_Library),
         "the supervisor has not loaded " & Clock_Library);
      for Number in 1 .. Whole (W.Source, 1, 4) loop
         Set_Shift
           ((case Whole (W.Source, 1, 5) is
                when 1      => Hour,
                when 2      => -Hour,
                when 3      => 20 * Year,
                when 4      => -20 * Year,
                when others =>
                   Long_Long_Integer (Whole (W.Source, -10, 10))));
         W.Talk (Span (W.Source, 0.0, 0.5));
      end loop;
   end Set_Clock;

   procedure Set_Clock_Back (W : in out World) is
      pragma Unreferenced (W);
   begin
      Set_Shift (0);
   end Set_Clock_Back;

   Load : Busy_Loops.Load;

   procedure Be_Busy (W : in out World) is
      Most : constant := 4;
   begin
      Load.Start
        (Positive'Min
           (Most, Positive (System.Multiprocessors.Number_Of_CPUs)));
      W.Talk (Span (W.Source, 0.5, 1.5));
      --  during the load, not after it
      begin
         W.Expect_Answers (if W.Alone then Busy_Limit else Answer_Limit);
      exception
         when Failed =>
            --  a late line changes an answer, but does not delay it
            W.Explained_By :=
              Explanation'Max (W.Explained_By, A_Stopped_Machine);
            raise;
      end;
   end Be_Busy;

   procedure Be_Idle (W : in out World) is
      pragma Unreferenced (W);
   begin
      Load.Stop;
   end Be_Idle;

   Usual : aliased Libc.Resource_Limit := (0, 0);
   Owner : int := 0;
   --  whose limit it is

   procedure Take_Descriptors (W : in out World) is
      Spare  : constant Natural := Whole (W.Source, 0, 1);
      Log    : constant Natural := W.Supervisor.Log_Length;
      Few    : aliased Libc.Resource_Limit;
      Others_Who_Connect : array (1 .. Whole (W.Source, 0, 3))
        of Monitor_Clients.Client;

      function Said return Boolean is
        (W.Supervisor.Says
           ("a monitor could not connect", Within => Noise, After => Log));

   begin
      W.Expect_Answers;
      Owner := W.Pid;
      Check
        (Libc.Prlimit (Owner, Libc.Rlimit_Nofile, null, Usual'Access) = 0,
         "its limits cannot be read");
      Few :=
        (Soft => unsigned_long (Process_Facts.Next_Descriptor (Owner) + Spare),
         Hard => Usual.Hard);
      Check
        (Libc.Prlimit (Owner, Libc.Rlimit_Nofile, Few'Access, null) = 0,
         "its limit cannot be set");
      W.Reachable := False;
      for Other of Others_Who_Connect loop
         --  the kernel takes them, the supervisor cannot
         Other.Connect (W.Port, W.Address, Real_Time => False);
      end loop;
      W.Talk (Span (W.Source, 0.1, 0.5), Calm => True);
      if W.The_Plan.Log_Is_Read and then W.Present and then Spare = 0
        and then Others_Who_Connect'Length > 0
      then
         --  unless another fault has set one free
         Check
           (Said
            or else unsigned_long (Process_Facts.Next_Descriptor (Owner))
              < Few.Soft,
            "it could take a connection: the limit does not hold");
      end if;
      W.Talk (Span (W.Source, 0.2, 1.0));
   end Take_Descriptors;

   procedure Give_Descriptors (W : in out World) is
   begin
      if Owner = W.Pid and then not W.Expected_End then
         Check
           (Libc.Prlimit (Owner, Libc.Rlimit_Nofile, Usual'Access, null) = 0,
            "its limit cannot be set back");
      end if;
      W.Reachable := True;
   end Give_Descriptors;

   function Can_Be_Had (Kind : Privilege_Kind) return Boolean is
     (case Kind is
         when User                  => True,
         when Root_Without_Nice     => Is_Root,
         when Root | User_With_Nice =>
            Is_Root and then Own_Process.Real_Time_Allowed);

   overriding procedure Prepare (F : Started_As; P : in out Plan) is
      Give_Line : constant String :=
        "for word; do" & ASCII.LF
        & "   [ ""$before"" != --serial ] || chown 65534 ""$word""" & ASCII.LF
        & "   before=$word" & ASCII.LF
        & "done" & ASCII.LF;
      --  the robot's line: another user's cannot be opened

      As_User   : constant String :=
        "exec setpriv --reuid=65534 --regid=65534 --clear-groups ";
   begin
      P.Fresh := True;
      if F.Kind /= Root and then Is_Root and then Can_Be_Had (F.Kind) then
         P.Program := To_Unbounded_String (Programs.Copied_Supervisor);
         P.Launcher :=
           (case F.Kind is
               when User_With_Nice    =>
                  Script
                    ("user_with_nice",
                     Give_Line & As_User
                     & "--inh-caps=-all,+sys_nice --ambient-caps=+sys_nice"
                     & " --bounding-set=-all,+sys_nice ""$@"""),
               when Root_Without_Nice =>
                  To_Unbounded_String
                    ("setpriv --bounding-set=-sys_nice --inh-caps=-sys_nice"),
               when others            =>
                  Script
                    ("user",
                     Give_Line & As_User & "--inh-caps=-all ""$@"""));
      end if;
   end Prepare;

   overriding procedure Inject (F : in out Started_As; W : in out World) is
   begin
      if not Can_Be_Had (F.Kind) then
         Skip ("only root can change its privileges, to those it has");
      end if;
      if W.The_Plan.Log_Is_Read then
         W.Expect_Log
           ((case F.Kind is
                when Root | User_With_Nice    =>
                   "real-time priorities: FIFO, ceilings",
                when User | Root_Without_Nice =>
                   "real-time priorities: none"),
            Within => 2.0);
      end if;
      W.Talk (Span (W.Source, 0.2, 1.0));
   end Inject;

   procedure Register is
   begin
      Add (Machine, "SIGTERM",
           new Stopping'(Signal => Libc.Sigterm, others => <>), Cost => 3.0,
           Ends => Supervisor_Ends);
      Add (Machine, "SIGINT",
           new Stopping'(Signal => Libc.Sigint, others => <>), Cost => 3.0,
           Ends => Supervisor_Ends);
      Add (Machine, "SIGHUP",
           new Stopping'(Signal => Libc.Sighup, others => <>), Cost => 3.0,
           Ends => Supervisor_Ends);
      Add (Machine, "SIGPIPE", Break_Pipes'Access);
      Add (Machine, "SIGKILL while moving, with watchdog", Kill'Access,
           Cost => 8.0, Ends => Supervisor_Ends, Robot => Robot_Moving,
           Alone => True);
      Add (Machine, "standard error closed",
           new Bad_Error'(Kind => Closed, others => <>));
      Add (Machine, "input, output and error closed",
           new Bad_Error'(Kind => All_Closed, others => <>));
      Add (Machine, "full pipe behind standard error",
           Fill_Pipe'Access, Empty_Pipe'Access, Prepare_Pipe'Access);
      Add (Machine, "full device behind standard error",
           new Bad_Error'(Kind => Full_Device, others => <>));
      Add (Machine, "full disk behind standard error",
           new Bad_Error'(Kind => Full_Disk, others => <>));
      Add (Machine, "wall clock set back and forth",
           Set_Clock'Access, Set_Clock_Back'Access, Prepare_Clock'Access);
      Add (Machine, "all processors busy", Be_Busy'Access, Be_Idle'Access);
      Add (Machine, "out of descriptors",
           Take_Descriptors'Access, Give_Descriptors'Access);
      Add (Machine, "started as root",
           new Started_As'(Kind => Root, others => <>), Cost => 3.0);
      Add (Machine, "started as an ordinary user",
           new Started_As'(Kind => User, others => <>), Cost => 3.0,
           Alone => True);
      Add (Machine, "started with cap_sys_nice only",
           new Started_As'(Kind => User_With_Nice, others => <>), Cost => 3.0,
           Alone => True);
      Add (Machine, "started as root without cap_sys_nice",
           new Started_As'(Kind => Root_Without_Nice, others => <>),
           Cost => 3.0);
   end Register;

end Machine_Faults;
