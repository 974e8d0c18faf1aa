--  SPDX-License-Identifier: GPL-3.0-or-later
--  Orders and answers, beside a bare forwarder.

with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Bench_Settings;
with Both_Ends;         use Both_Ends;
with Busy_Loops;
with Child_Processes;   use Child_Processes;
with Emulators;
with Expectations;      use Expectations;
with Instants;          use Instants;
with Interfaces.C;      use Interfaces.C;
with Libc;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Reports;
with Samples;
with Schedule;
with Supervisors;

procedure Report_Order_Times is

   Block : constant := 50;
   --  Exchanges through one of them before it is the other's turn: what
   --  the machine does meanwhile concerns all

   Attempts : constant := 20;

   Silence_Limit : constant Duration := 0.080 + 3 * 0.001_042;
   --  The robot's answer is waited for 80 ms from the end of the command,
   --  whose three bytes would take so long at 9600 baud

   subtype Supervisor_Place is Place range Ours .. Traced;
   --  Traced: another supervisor, with --trace

   type Distribution is array (Place) of Samples.Set;

   type Condition is
     (Idle, Beside_Traced, Loaded, Service, Loaded_Service, With_Gap);
   --  Beside_Traced: idle, with and without --trace in turns. Service: as
   --  systemd runs it, an ordinary user with CAP_SYS_NICE

   function Title (Under : Condition) return String is
     (case Under is
         when Idle           => "idle",
         when Beside_Traced  => "idle, with --trace, to the same without",
         when Loaded         => "full load",
         when Service        => "idle, as a service",
         when Loaded_Service => "full load, as a service",
         when With_Gap       => "while images stream, default gap");

   Orders, Answers : Distribution;
   --  Under one condition
   Stops           : Samples.Set;
   Left_Out        : Natural := 0;
   --  exchanges that were repeated

   Source : Generator;
   Amount : Natural := 0;

   function Measurable (Under : Condition) return Boolean is
     (Under not in Service | Loaded_Service
      or else (Libc.Geteuid = 0 and then Own_Process.Real_Time_Allowed));

   function Is_Taken (Through : Place; Under : Condition) return Boolean is
     (Through = Ours or else (Through = Traced) = (Under = Beside_Traced));

   procedure One (Through : Place; Result : out Exchange) is
      --  a different one each time
      Value : constant String := Image (1 + Amount mod 9_000);
   begin
      Amount := Amount + 1;
      Serve (0.001 + 0.002 * Duration (Random (Source)));
      Both_Ends.Measure
        (Through,
         (if Through = Floor then Framed ("M=" & Value)
          else "RMOV:" & Value & ASCII.LF),
         "M=" & Value, Result);
   end One;

   function Said (Events : Event_Vectors.Vector) return String is
      --  Their texts
      Result : Unbounded_String;
   begin
      for Item of Events loop
         Append (Result, " " & To_String (Item.Text));
      end loop;
      return (if Events.Is_Empty then " nothing" else To_String (Result));
   end Said;

   procedure Recover (Which : Place) is
      --  From a robot that counts as lost: the machine was busy elsewhere
   begin
      --  what is late comes meanwhile
      Serve (0.2);
      if Which in Supervisor_Place then
         Forget (Which);
         Send (Which, "ROPN" & ASCII.LF & "RSOW" & ASCII.LF);
         Await_Message (Which, "AACK ACRJ ATIM ANAK", Count => 2);
      end if;
   end Recover;

   procedure Measure_Stops is
      --  Ours must be there
      Count  : constant Positive :=
        Integer'Max (20, Bench_Settings.Sample_Count / 10);
      Missed : Natural := 0;

      procedure Stop_One is
         Unused, Begun, Time : Instant;
      begin
         --  in step, whatever was before
         Serve (0.01);
         Forget (Ours);
         Send (Ours, "RPIN" & ASCII.LF);
         Await_Message (Ours, "AACK ATIM ANAK");
         Forget (Ours);
         Set_Unanswered (Ours, "b");
         Send (Ours, "RGST" & ASCII.LF);
         Await_Frame (Ours, "b", Unused);
         Serve (0.002 + 0.07 * Duration (Random (Source)));
         Begun := Now;
         Send (Ours, "RSTP" & ASCII.LF);
         Await_Frame (Ours, "M=0", Time);
         Stops.Add (Time - Begun);
         Await_Message (Ours, "ATIM AACK", Count => 2);
      end Stop_One;

   begin
      while Stops.Count < Count loop
         begin
            Stop_One;
         exception
            when Failed | Too_Late =>
               Missed := Missed + 1;
               if Missed > Attempts then
                  raise;
               end if;
               Recover (Ours);
         end;
      end loop;
      Left_Out := Left_Out + Missed;
   end Measure_Stops;

   procedure Start_Forwarder (Process : in out Child) is
      --  The floor, at the priority of the task that writes to the line
      Number : Natural;
      Line   : Unbounded_String;
   begin
      Process.Launch
        (Programs.Beside ("forwarder"),
         Words
           (Device (Floor)
            --  Linux counts priorities from 1
            & Integer'Image
                (if Own_Process.Real_Time_Allowed
                 then Schedule.Move_Priority + 1 else 0)));
      Number := Process.Awaited (Errors, "listening on", 5.0);
      Check (Number > 0, "the forwarder does not listen");
      Line := Process.Element (Errors, Number).Text;
      Connect
        (Floor,
         Positive'Value (Slice (Line, Index (Line, ":") + 1, Length (Line))),
         By_Lines => False);
   end Start_Forwarder;

   procedure Measure (Under : Condition) is
      --  Loaded: images with positions, two busy loops. With_Gap: images
      --  alone, and the default gap between messages. Otherwise no camera
      Bare        : Child;
      Driving     : array (Supervisor_Place) of Supervisors.Supervisor;
      Camera      : Emulators.Emulator;
      Load        : Busy_Loops.Load;
      Result      : Exchange;

      With_Load   : constant Boolean := Under in Loaded | Loaded_Service;
      With_Camera : constant Boolean := With_Load or else Under = With_Gap;

      procedure Measure_Block (Which : Place) is
      begin
         for Count in 1 .. Block loop
            for Attempt in 1 .. Attempts loop
               One (Which, Result);
               exit when Result.Clean;
               Left_Out := Left_Out + 1;
               Check (Attempt < Attempts,
                      "no exchange succeeds any more: " & Which'Image
                      & ", on the line" & Said (Frames (Which))
                      & ", to the monitor"
                      & Said (Messages (Which)));
               Recover (Which);
            end loop;
            Orders (Which).Add (Result.Order);
            Answers (Which).Add (Result.Answer);
         end loop;
      end Measure_Block;

   begin
      Orders := (others => Samples.None);
      Answers := (others => Samples.None);
      for Which in Place loop
         if Is_Taken (Which, Under) then
            Open_Line (Which);
         end if;
      end loop;
      if Is_Taken (Floor, Under) then
         Start_Forwarder (Bare);
      end if;
      if With_Camera then
         Camera.Start (Camera => True);
      end if;
      for Which in Supervisor_Place loop
         if Is_Taken (Which, Under) then
            Driving (Which).Start
              ("--serial " & Device (Which)
               & (if Under = With_Gap then "" else " --message-gap 0")
               & (if With_Camera then " --camera " & Camera.Camera_Url
                  else "")
               & (if Which = Traced
                  then " --trace " & Programs.Temporary_Folder
                       & "/orders.json"
                  else ""),
               Launcher =>
                 (if Under in Service | Loaded_Service
                  then Programs.As_Service
                  else ""),
               Program  =>
                 (if Under in Service | Loaded_Service
                  then Programs.Copied_Supervisor
                  else ""));
            Connect (Which, Driving (Which).Port, By_Lines => True);
         end if;
      end loop;
      Own_Process.Prefer_Real_Time (True);
      for Which in Supervisor_Place loop
         if Is_Taken (Which, Under) then
            Send (Which, "ROPN" & ASCII.LF & "RSOW" & ASCII.LF);
            Await_Message (Which, "AACK", Count => 2);
         end if;
      end loop;
      if With_Camera then
         Forget (Ours);
         Send (Ours,
               "COPN" & ASCII.LF
               & (if With_Load then "CPCO" & ASCII.LF else ""));
         Await_Message (Ours, "CIMG", Count => 10);
      end if;
      Own_Process.Prefer_Real_Time (False);
      if With_Load then
         Load.Start;
      end if;
      Own_Process.Prefer_Real_Time (True);
      Serve (0.5);

      while Orders (Ours).Count < Bench_Settings.Sample_Count loop
         for Which in Place loop
            if Is_Taken (Which, Under) then
               Measure_Block (Which);
            end if;
         end loop;
      end loop;
      if Under = Idle then
         Measure_Stops;
      end if;
      Own_Process.Prefer_Real_Time (False);
      Close_All;
   end Measure;

   procedure Put
     (Section, About, Name : String;
      Under                : Condition;
      Times                : Distribution) is
   begin
      Reports.Begin_Section (Section, About);
      if Under = Beside_Traced then
         Reports.Put (Name & Title (Under), Times (Traced), Times (Ours));
      else
         Reports.Put (Name & Title (Under), Times (Ours), Times (Floor));
      end if;
   end Put;

begin
   Reset (Source, 5544);
   for Under in Condition loop
      if Measurable (Under) then
         Measure (Under);
         Put ("answers", "robot's answer to the monitor's receipt", "answer, ",
              Under, Answers);
         Put ("orders", "monitor's order to first byte at the robot's end",
              "order, ", Under, Orders);
      end if;
      if Under = Idle then
         Reports.Put
           ("stop while another order waits for a silent robot", Stops);
         Reports.Put_Number
           ("longest stop, beyond the time-out and an order's p99.9",
            1.0E6 * Float
              (Stops.Quantile (1.0) - Silence_Limit
               - Orders (Ours).Quantile (0.999)), "us");
      end if;
   end loop;
   Reports.Put_Note
     (Image (Left_Out)
      & " exchanges were repeated: something else was on the line, or they"
      & " failed");
end Report_Order_Times;
