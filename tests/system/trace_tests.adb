--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace: --trace FILE, from the events in the supervisor to the file.

with Ada.Directories;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Process_Facts;
with Programs;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;
with Supervisors;           use Supervisors;
with Trace_Files;           use Trace_Files;

procedure Trace_Tests is

   Tasks : constant := 17;

   function Trace_Path return String is
     (Programs.Temporary_Folder & "/trace.txt");

   function Read_Trace return Trace is
   begin
      return Result : constant Trace := Trace_Of (Trace_Path) do
         Check (Natural (Result.Tasks.Length) = Tasks,
                Result.Tasks.Length'Image & " tasks have a name");
      end return;
   end Read_Trace;

   procedure Check_Way (T : Trace; Label, Carrier, Order : String) is
      --  One command of the monitor from its receipt by way of task Carrier
      --  and the robot's answer to the monitor's
      Place   : Natural  := 0;
      Command : Natural  := 0;
      Since   : Duration := 0.0;

      procedure Follow (Who, What : String; Numbered : Boolean := True) is
         --  The next such event
         function Is_It (Item : Event) return Boolean is
           (Item.Who = Who and then Item.What = What
            and then (not Numbered or else Command in 0 | Item.Command));
      begin
         loop
            Place := Place + 1;
            Check (Place <= T.Events.Last_Index,
                   Label & Command'Image & ": no " & What & " of " & Who);
            exit when Is_It (T.Events (Place));
         end loop;
         Check (T.Events (Place).Time >= Since, "an effect before its cause");
         Since := T.Events (Place).Time;
         if Command = 0 then
            Command := T.Events (Place).Command;
            Check (Command > 0, "a command without a number");
         end if;
      end Follow;

   begin
      Follow ("th_receiveFromMon", "in " & Label);
      Follow (Carrier, "release");
      Follow (Carrier, "take");
      Follow (Carrier, "robot " & Order, Numbered => False);
      Follow (Carrier, "wait answer", Numbered => False);
      Follow (Carrier, "resume", Numbered => False);
      Follow ("th_sendToMon", "release");
      Follow ("th_sendToMon", "start", Numbered => False);
      Follow ("th_sendToMon", "out AACK", Numbered => False);
   end Check_Way;

   procedure Whole_Session is
      R     : Rig;
      Other : Client;
      T     : Trace;
      Since : Instant;
   begin
      Assemble (R, Camera => True,
                Supervisor_Options =>
                  "--trace " & Trace_Path & " --token " & Token_File);
      R.Monitor.Send_Line ("AUTH:" & Token);
      Play (R, Guarded & ", RGFW AACK, RSTP AACK, " & With_Positions);
      Check (Process_Facts.Inherited (R.Supervisor.Pid) = "",
             "inherited:" & Process_Facts.Inherited (R.Supervisor.Pid));
      Play (R, "CASA CIMG, send CACO, AUTH:" & Token & " ACER, RPIN AACK,"
            & " seen w");
      if R.Monitor.Ask ("MGCM:45;33").Label = "AACK" then
         R.Monitor.Await ("MEND");
      end if;
      Play (R, "CCLS AACK, RRST AACK, RSOW AACK, comes RBLV");
      Other.Connect (R.Supervisor.Port);
      Other.Send_Line ("AUTH:" & Token);
      Play (R, "close, log session closed");
      Since := Now;
      R.Supervisor.Expect_End;
      Check_Within (Now - Since, 4.0, "the end, with a trace");
      T := Read_Trace;
      for Name of T.Tasks loop
         Check (Count_Of (T, Name, "start") > 0, "no job of " & Name);
      end loop;
      Check_Way (T, "ROPN", "th_openComRobot", "r");
      Check_Way (T, "RSWW", "th_startRobotWD", "W");
      Check_Way (T, "RGFW", "th_move", "M");
      Check_Way (T, "RPIN", "th_openComRobot", "p");
      Check_Way (T, "RRST", "th_resetRobot", "r");
      Check_Way (T, "RSOW", "th_startRobot", "u");
      Check (Process_Facts.File_Line (Trace_Path, Token) = "",
             "the token is in the trace");
   end Whole_Session;

   procedure After_A_Failure is
      T : Trace;

      procedure Fail (Who : String) is
         --  While the robot moves
         R : Rig;
      begin
         Assemble (R, Supervisor_Options => "--trace " & Trace_Path);
         Play (R, Forward);
         R.Supervisor.Fail (Who);
         T := Read_Trace;
         Check (Count_Of (T, "th_receiveFromMon", "in RGFW") = 1,
                "the movement");
      end Fail;

   begin
      --  the main procedure, which ends the process then, is at the file
      Fail ("th_stop");
      Fail ("th_resetRobot");
      Check (Count_Of (T, "th_stop", "robot M") >= 1, "no stop in the trace");
   end After_A_Failure;

   procedure Nothing_Happened is
      S      : Supervisor;
      Reader : Child;
      T      : Trace;
   begin
      S.Start ("--trace " & Trace_Path);
      S.Send_Signal (Libc.Sigint);
      S.Expect_Exit (0);
      T := Read_Trace;
      Reader.Launch ("stat -c mode:%a " & Trace_Path);
      Check (Reader.Says ("mode:600", Patience, From => Output),
             "the trace is readable for others");
   end Nothing_Happened;

   procedure Unusable_Files is
      Path : constant String := Trace_Path & ".new";
      Link : constant String := Trace_Path & ".link";

      procedure Refuse (Path, Reason : String) is
      begin
         Expect_Console
           ("--port 0 --trace " & Path, 1,
            "destijl: cannot use the trace file " & Path & ": " & Reason);
         Expect_Console ("--check --port 0 --trace " & Path, 1,
                         "not ok  trace file " & Path & ": " & Reason);
      end Refuse;

   begin
      Refuse (Programs.Temporary_Folder & "/none/trace", "No such file");
      Refuse (Programs.Temporary_Folder, "Is a directory");
      Refuse ("/dev/ptmx", "Illegal seek");  --  a terminal
      Check (Libc.Symlink (To_C (Path), To_C (Link)) = 0, "no symbolic link");
      Refuse (Link, "Too many levels of symbolic links");
      Expect_Console ("--check --port 0 --camera /no/such --trace " & Path, 1,
                      "ok      trace file " & Path);
      Check (not Ada.Directories.Exists (Path), "--check has left its file");
   end Unusable_Files;

   procedure Full_Disk is

      procedure Fill (Path, Launcher, Reason : String) is
         R : Rig;
      begin
         Assemble (R, Supervisor_Options => "--trace " & Path,
                   Launcher => Launcher);
         Play (R, Forward & ", signal 15, ends 0, said the trace is not"
               & " complete: " & Reason & ", status moving 0");
      end Fill;

   begin
      Fill ("/dev/full", "", "No space left");
      Fill (Trace_Path, "prlimit --fsize=4096", "File too large");
   end Full_Disk;

begin
   Add ("Trace_Whole_Session", Whole_Session'Access, In_Time => True);
   Add ("Trace_After_A_Failure", After_A_Failure'Access);
   Add ("Trace_Nothing_Happened", Nothing_Happened'Access);
   Add ("Trace_Unusable_Files", Unusable_Files'Access);
   Add ("Trace_Full_Disk", Full_Disk'Access);
end Trace_Tests;
