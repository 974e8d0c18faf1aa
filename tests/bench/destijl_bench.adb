--  SPDX-License-Identifier: GPL-3.0-or-later
--  Prints the figures of F4, F11, F12, F13 and F15 under full load: images
--  with positions, 30 commands a second, two busy loops; and the processor
--  times of the tasks beside the budgets of the response-time analysis.

with Ada.Command_Line;      use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Numerics.Float_Random;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;
with Interfaces.C;
with System.Multiprocessors;
with System;

with Busy_Loops;
with Child_Processes;
with Emulators;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Own_Priority;
with Programs;
with Rigs;                  use Rigs;
with Samples;
with Task_Times;

procedure Destijl_Bench is

   Bad_Usage : exception;

   Seconds : Positive := 60;
   --  of each of the three measurements
   Quick_Seconds : constant := 10;

   procedure Read_Command_Line;

   procedure Print_Usage (To : File_Type);

   function File_Line (Path : String; Key : String) return String;
   --  The first line of a file that contains Key; "" if there is none

   procedure Print_Machine;

   procedure Measure (Baud : Natural; Tasks : Boolean := False);
   --  Tasks: the processor time of the tasks instead of the delays

   -----------------
   -- Print_Usage --
   -----------------

   procedure Print_Usage (To : File_Type) is
   begin
      Put_Line (To, "usage: destijl_bench [--seconds N] [--quick]");
      Put_Line (To, "   --seconds N   of each measurement (60)");
      Put_Line (To, "   --quick       10 seconds each");
      Put_Line (To, "   --supervisor PATH, --emulator PATH");
      Put_Line (To, "                 instead of those beside this one");
   end Print_Usage;

   -----------------------
   -- Read_Command_Line --
   -----------------------

   procedure Read_Command_Line is
      Number : Positive := 1;

      function Value return String;
      --  The next argument

      function Value return String is
      begin
         if Number = Argument_Count then
            raise Bad_Usage with Argument (Number) & " needs a value";
         end if;
         Number := Number + 1;
         return Argument (Number);
      end Value;

   begin
      while Number <= Argument_Count loop
         declare
            Name : constant String := Argument (Number);
         begin
            if Name = "--seconds" then
               Seconds := Positive'Value (Value);
            elsif Name = "--quick" then
               Seconds := Quick_Seconds;
            elsif Name = "--supervisor" then
               Programs.Set_Supervisor (Value);
            elsif Name = "--emulator" then
               Programs.Set_Emulator (Value);
            elsif Name = "--help" then
               Print_Usage (Standard_Output);
               GNAT.OS_Lib.OS_Exit (0);
            else
               raise Bad_Usage with "unknown option " & Name;
            end if;
         exception
            when Constraint_Error =>
               raise Bad_Usage with Name & " takes a number";
         end;
         Number := Number + 1;
      end loop;
   end Read_Command_Line;

   ---------------
   -- File_Line --
   ---------------

   function File_Line (Path : String; Key : String) return String is
      File : File_Type;
   begin
      Open (File, In_File, Path);
      while not End_Of_File (File) loop
         declare
            Line : constant String := Get_Line (File);
         begin
            if Key = "" or else Index (Line, Key) > 0 then
               Close (File);
               return Line;
            end if;
         end;
      end loop;
      Close (File);
      return "";
   exception
      when Name_Error | Use_Error =>
         return "";
   end File_Line;

   -------------------
   -- Print_Machine --
   -------------------

   procedure Print_Machine is
      use type Interfaces.C.unsigned;
      Model : constant String := File_Line ("/proc/cpuinfo", "model name");
      Board : constant String :=
        File_Line ("/sys/firmware/devicetree/base/model", "");
   begin
      Put_Line
        ("machine: "
         & (if Board /= "" then Board
            elsif Model /= "" then
              Trim (Model (Index (Model, ":") + 1 .. Model'Last), Both)
            else "unknown processor")
         & ","
         & System.Multiprocessors.Number_Of_CPUs'Image & " cores");
      Put_Line ("kernel: " & File_Line ("/proc/version", ""));
      Put_Line
        ("        "
         & (if File_Line ("/sys/kernel/realtime", "1") = "1"
            then "PREEMPT_RT" else "not PREEMPT_RT"));
      Put_Line
        ("user: "
         & (if Libc.Geteuid = 0 then "root" else "an ordinary user"));
      Put_Line
        ("load: images with positions at 10 a second, 30 commands a"
         & " second, two busy loops");
   end Print_Machine;

   -------------
   -- Measure --
   -------------

   procedure Measure (Baud : Natural; Tasks : Boolean := False) is
      use Ada.Numerics.Float_Random;

      Answer_Bytes : constant := 3;
      --  of the robot: a character, its checksum, the end

      Byte_Time : constant Duration :=
        (if Baud = 0 then 0.0 else 10.0 / Baud);

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

      procedure Ask_And_Note (Command : String; Wire : String);
      --  Sends and waits for the answer; of an own answer notes the time

      procedure Pause;
      --  Between two commands: 15 to 45 ms

      procedure Evaluate_Orders;
      procedure Evaluate_Robot_Answers;
      procedure Evaluate_Periods;

      ------------------
      -- Ask_And_Note --
      ------------------

      procedure Ask_And_Note (Command : String; Wire : String) is
         Item : Message;
         Time : Instant;
      begin
         R.Monitor.Skip_To_Now;
         Time := Now;
         R.Monitor.Send_Line (Command);
         Item := R.Monitor.Next_Answer (Within => 5.0, Command => Command);
         if Sent_Last < Sent'Last then
            Sent_Last := Sent_Last + 1;
            Sent (Sent_Last) := (Time, To_Unbounded_String (Wire));
         end if;
         if Wire = "" then
            Own.Add (Item.Time - Time);
         end if;
      end Ask_And_Note;

      -----------
      -- Pause --
      -----------

      procedure Pause is
      begin
         delay 0.015 + 0.03 * Duration (Random (Source));
      end Pause;

      ---------------------
      -- Evaluate_Orders --
      ---------------------

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
                 and then (Element (Item.Command, 1) in 'M' | 'T')
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

      ----------------------------
      -- Evaluate_Robot_Answers --
      ----------------------------

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
               Robots.Add
                 (R.Monitor.Element (Number).Time
                  - (Item.Last + Answer_Bytes * Byte_Time));
               Number := Number + 1;
            end if;
         end loop;
      end Evaluate_Robot_Answers;

      ----------------------
      -- Evaluate_Periods --
      ----------------------

      procedure Evaluate_Periods is
         Battery, Image, Place : Instant := Never;

         procedure Add
           (To : in out Samples.Set; Item : Message; Last : in out Instant);

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

      function Image_Of (Value : Integer) return String is
        (Trim (Integer'Image (Value), Both));

   begin
      Assemble
        (R, Camera => True,
         Emulator_Options => "--baud " & Image_Of (Baud));
      New_Line;
      Put_Line
        ("robot's line "
         & (if Baud = 0 then "unpaced" else "at" & Baud'Image & " baud")
         & "," & Seconds'Image & " s");
      if R.Supervisor.Says ("real-time priorities:", Within => 1.0) then
         declare
            Log   : constant String := R.Supervisor.Log_Text;
            Place : constant Positive :=
              Index (Log, "real-time priorities:");
         begin
            Put_Line
              ("supervisor: "
               & Log (Place .. Index (Log, (1 => ASCII.LF), Place) - 1));
         end;
      end if;
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Load.Start;
      delay 2.0;

      Own_Priority.Prefer_Real_Time (True);
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
            Value : constant String := Image_Of (1 + Amount mod 9_000);
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
      Own_Priority.Prefer_Real_Time (False);
      if Tasks then
         Task_Times.Stop;
         Task_Times.Print;
         return;
      end if;

      Journal := R.Emulator.Journal;
      Missed := R.Emulator.Status_Number ("missed_total");
      Evaluate_Orders;
      Evaluate_Robot_Answers;
      Evaluate_Periods;

      Samples.Print_Header;
      Own.Print
        ("F4 command to the supervisor's own answer", "p99.9 < 10",
         Own.Quantile (0.999) < 0.010);
      Robots.Print
        ("F4 robot's answer to the monitor's", "p99.9 < 10",
         Robots.Quantile (0.999) < 0.010);
      Reloads.Print
        ("F11 between reloads, at the robot", "1000 +- 50",
         Missed = 0 and then Spread (Reloads, 1.0, 1.0) < 0.050);
      Put_Line ("F11 missed windows:" & Missed'Image);
      Orders.Print
        ("F12 order sent to first byte on the line", "", True);
      if Baud > 0 then
         Net.Print
           ("F12 the same without waiting for the line", "p99.9 < 5",
            Net.Quantile (0.999) < 0.005);
      end if;
      --  an unpaced line has no time of its own that could be told from the
      --  robot's and the pseudo-terminal's
      Batteries.Print
        ("F13 between battery levels", "500 +- 1 %, p99 +- 20",
         abs (Batteries.Mean - 0.5) < 0.005
         and then Spread (Batteries, 0.99, 0.5) < 0.020);
      Images.Print
        ("F15 between images", "100 +- 1 %, p99 +- 20",
         abs (Images.Mean - 0.1) < 0.001
         and then Spread (Images, 0.99, 0.1) < 0.020);
      Places.Print
        ("F18 between positions", "", True);
      Put_Line
        ("means: battery " & Milliseconds (Batteries.Mean) & ", images "
         & Milliseconds (Images.Mean) & ", reloads "
         & Milliseconds (Reloads.Mean));
   end Measure;

   Unused : System.Address;

begin
   Unused := Libc.Signal (Libc.Sigpipe, Libc.Ignored);
   Read_Command_Line;
   Print_Machine;
   Measure (Baud => 9_600);
   Measure (Baud => 0);
   Measure (Baud => 9_600, Tasks => True);
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit (0);

exception
   when Problem : Bad_Usage =>
      Put_Line
        (Standard_Error,
         "destijl_bench: " & Ada.Exceptions.Exception_Message (Problem));
      Print_Usage (Standard_Error);
      GNAT.OS_Lib.OS_Exit (2);
   when Problem : others =>
      Put_Line
        (Standard_Error,
         "destijl_bench: " & Ada.Exceptions.Exception_Message (Problem));
      Child_Processes.Stop_All;
      Child_Processes.Print_Last_Lines;
      Programs.Remove_Temporary_Folder;
      GNAT.OS_Lib.OS_Exit (1);
end Destijl_Bench;
