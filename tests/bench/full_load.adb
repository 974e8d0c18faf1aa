--  SPDX-License-Identifier: GPL-3.0-or-later
--  The figures of F4, F11, F12, F13 and F15 under full load, and what the
--  tasks take of the processors under it.

with Ada.Numerics.Float_Random;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Bench_Settings;
with Busy_Loops;
with Emulators;
with Instants;              use Instants;
with Mission_Drives;
with Monitor_Clients;       use Monitor_Clients;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Reports;
with Rigs;                  use Rigs;
with Samples;
with Service_Starts;
with Single_Commands;
with Task_Times;

package body Full_Load is

   procedure Measure
     (Baud    : Natural;
      Tasks   : Boolean  := False;
      Seconds : Positive := Bench_Settings.Seconds)
   is
      --  Tasks: the processor time of the tasks instead of the delays
      use Ada.Numerics.Float_Random;

      Answer_Bytes : constant := 3;
      --  of the robot: a character, its checksum, the end

      Byte_Time : constant Duration := (if Baud = 0 then 0.0 else 10.0 / Baud);

      Where : constant String := (if Baud = 0 then "unpaced, " else "9600, ");
      --  the robot's line

      type Sending is record
         Time  : Instant := Never;
         Order : Unbounded_String;
         --  as it will be on the wire, "" where it will not
      end record;

      R         : Rig;
      Load      : Busy_Loops.Load;
      Source    : Generator;
      Start     : Instant;
      First     : Natural;
      Amount    : Natural := 0;
      Own       : Samples.Set;
      Robots    : Samples.Set;
      Orders    : Samples.Set;
      Net       : Samples.Set;
      Reloads   : Samples.Set;
      Batteries : Samples.Set;
      Images    : Samples.Set;
      Places    : Samples.Set;
      Missed    : Natural;

      Journal   : Emulators.Notes;
      Sent      : array (1 .. 4 * 100 * Seconds) of Sending;
      Sent_Last : Natural := 0;

      procedure Ask_And_Note (Command : String; Wire : String) is
         --  Sends and waits for the answer; of an own answer notes the time
         Item : Message;
         Time : Instant;
      begin
         R.Monitor.Skip_To_Now;
         Time := Now;
         R.Monitor.Send_Line (Command);
         Item := R.Monitor.Next_Answer (Command);
         if Sent_Last < Sent'Last then
            Sent_Last := Sent_Last + 1;
            Sent (Sent_Last) := (Time, To_Unbounded_String (Wire));
         end if;
         if Wire = "" then
            Own.Add (Item.Time - Time);
         end if;
      end Ask_And_Note;

      procedure Pause is
         --  Between two commands: 15 to 45 ms
      begin
         delay 0.015 + 0.03 * Duration (Random (Source));
      end Pause;

      procedure Evaluate_Orders is
         --  Amounts differ from order to order, so that each is found
         Free  : Instant := Never;
         --  when the line was free again before the command
         Place : Natural := 0;
      begin
         for Item of Journal loop
            for Number in Place + 1 .. Sent_Last loop
               if Sent (Number).Order = Item.Command
                 and then Item.First > Sent (Number).Time
                 and then Element (Item.Command, 1) in 'M' | 'T'
               then
                  Orders.Add (Item.First - Sent (Number).Time);
                  Net.Add
                    (Item.First
                     - Instant'Max (Sent (Number).Time, Free));
                  Place := Number;
                  exit;
               end if;
            end loop;
            Free := Item.Last + Answer_Bytes * Byte_Time;
         end loop;
      end Evaluate_Orders;

      procedure Evaluate_Robot_Answers is
         --  From the answer's last byte on the wire to the monitor. The
         --  state is asked for by the monitor only.
         Number : Positive := First;
      begin
         for Item of Journal loop
            if Item.Command = "b" then
               while Number <= R.Monitor.Count
                 and then (R.Monitor.Element (Number).Label /= "RCST"
                           or else R.Monitor.Element (Number).Time
                             < Item.Last)
               loop
                  Number := Number + 1;
               end loop;
               exit when Number > R.Monitor.Count;
               Robots.Add (R.Monitor.Element (Number).Time
                           - (Item.Last + Answer_Bytes * Byte_Time));
               Number := Number + 1;
            end if;
         end loop;
      end Evaluate_Robot_Answers;

      procedure Evaluate_Periods is
         Battery, Image, Place : Instant := Never;

         procedure Add
           (To : in out Samples.Set; Item : Message; Last : in out Instant)
         is
         begin
            if Last /= Never then
               To.Add (Item.Time - Last);
            end if;
            Last := Item.Time;
         end Add;

      begin
         for Number in First .. R.Monitor.Count loop
            declare
               Item : constant Message := R.Monitor.Element (Number);
            begin
               if Item.Label = "RBLV" then
                  Add (Batteries, Item, Battery);
               elsif Item.Label = "CIMG" then
                  Add (Images, Item, Image);
               elsif Item.Label = "CPOS" then
                  Add (Places, Item, Place);
               end if;
            end;
         end loop;
         for Item of Journal loop
            if Item.Command = "w" and then Item.Interval > 0.0 then
               Reloads.Add (Item.Interval);
            end if;
         end loop;
      end Evaluate_Periods;

      function Spread (Set : Samples.Set; Share : Float; Middle : Duration)
         return Duration
      is (Duration'Max
           (abs (Set.Quantile (Share) - Middle),
            abs (Set.Quantile (1.0 - Share) - Middle)));

      procedure Put_Off (Name : String; Most, Off : Duration) is
      begin
         Reports.Put_Number
           (Where & Name, 1.0E6 * Float (Off), "us",
            Wanted => (1 => (Reports.Value, 1.0E6 * Float (Most), False)));
      end Put_Off;

   begin
      Service_Starts.Assemble (R, "--baud " & Image (Baud));
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Load.Start;
      delay 2.0;

      Own_Process.Prefer_Real_Time (True);
      Reset (Source, 5544);
      R.Emulator.Clear_Journal;
      First := R.Monitor.Count + 1;
      if Tasks then
         Task_Times.Start (R.Supervisor.Pid);
      end if;
      Start := Now;
      while Now - Start < Duration (Seconds) loop
         Amount := Amount + 1;
         declare
            Value : constant String := Image (1 + Amount mod 9_000);
         begin
            case Amount mod 4 is
               when 0 =>
                  Ask_And_Note ("RMOV:-" & Value, "M=-" & Value);
               when 1 =>
                  Ask_And_Note ("RTRN:" & Value, "T=" & Value);
               when 2 =>
                  Ask_And_Note ("RMOV:" & Value, "M=" & Value);
               when others =>
                  Ask_And_Note ("RSTP", "M=0");
            end case;
         end;
         Pause;
         if Amount mod 4 = 0 then
            Ask_And_Note ("RGST", "b");
            Pause;
         elsif Amount mod 4 = 2 then
            Ask_And_Note ("what", "");
            Pause;
         end if;
      end loop;
      Own_Process.Prefer_Real_Time (False);
      if Tasks then
         Task_Times.Stop;
         return;
      end if;

      Journal := R.Emulator.Journal;
      Missed := R.Emulator.Status_Number ("missed_total");
      Evaluate_Orders;
      Evaluate_Robot_Answers;
      Evaluate_Periods;

      Reports.Put (Where & "F4 command to the supervisor's own answer", Own,
                   (1 => (Reports.P999, 10_000.0, False)));
      Reports.Put (Where & "F4 robot's answer to the monitor's", Robots,
                   (1 => (Reports.P999, 10_000.0, False)));
      Put_Off ("F11 reload at the robot, furthest off 1000 ms", 0.050,
               Spread (Reloads, 1.0, 1.0));
      Reports.Put_Number
        (Where & "F11 windows of the watchdog missed", Float (Missed), "",
         Wanted => (1 => (Reports.Value, 0.0, False)));
      Reports.Put (Where & "F12 order to first byte on the line", Orders);
      if Baud > 0 then
         Reports.Put (Where & "F12 without waiting for the line", Net,
                      (1 => (Reports.P999, 5_000.0, False)));
      end if;
      --  an unpaced line has no time of its own that could be told from the
      --  robot's and the pseudo-terminal's
      Put_Off ("F13 battery levels, mean off 500 ms", 0.005,
               abs (Batteries.Mean - 0.5));
      Put_Off ("F13 battery levels, p99 off 500 ms", 0.020,
               Spread (Batteries, 0.99, 0.5));
      Put_Off ("F15 images, mean off 100 ms", 0.001, abs (Images.Mean - 0.1));
      Put_Off ("F15 images, p99 off 100 ms", 0.020,
               Spread (Images, 0.99, 0.1));
      Reports.Put (Where & "F18 between positions", Places);
   end Measure;

   procedure Report is
   begin
      Reports.Begin_Section
        ("load", "images with positions, a command 15 to 45 ms after each"
         & " answer, two busy loops");
      Measure (Baud => 9_600);
      Measure (Baud => 0);
      Reports.End_Section;
   end Report;

   procedure Report_Tasks is
   begin
      Reports.Begin_Section
        ("tasks", "what one activity of a task takes under that load, for"
         & " single commands, and beside missions");
      Measure (Baud    => 9_600,
               Tasks   => True,
               Seconds => Bench_Settings.Short_Seconds);
      Single_Commands;
      Mission_Drives.Measure_Tasks;
      Task_Times.Print;
      Reports.End_Section;
   end Report_Tasks;

end Full_Load;
