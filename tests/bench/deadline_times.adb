--  SPDX-License-Identifier: GPL-3.0-or-later
--  The deadlines from end to end.

with Ada.Containers.Vectors;
with Ada.Exceptions;
with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;

with Bench_Settings;
with Budgets;
with Busy_Loops;
with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Reports;
with Rigs;                  use Rigs;
with Samples;
with Loads;
with Standstills;
with Supervisor_Model;      use Supervisor_Model;
with System.Multiprocessors;

package body Deadline_Times is

   use type System.Multiprocessors.CPU;

   type Subject is
     (First_Answer, Own_Answer, Robot_Answer, Monitor_Lost, Reload, First_Byte,
      Last_Byte, Level, Image);

   function Name_Of (Which : Subject) return String is
     (case Which is
         when First_Answer => "F2 connection to the first answer",
         when Own_Answer   => "F4 command to the supervisor's own answer",
         when Robot_Answer => "F4 robot's answer to the monitor's",
         when Monitor_Lost => "F6 loss of the monitor to the stop's last byte",
         when Reload       => "F11 reload due to its first byte",
         when First_Byte   => "F12 order to first byte, line free",
         when Last_Byte    => "F12 order to last byte, all of them",
         when Level        => "F13 battery level due to its message",
         when Image        => "F15 from image to image");

   subtype Demanded is Subject range First_Answer .. Level;

   Requirement_Of : constant array (Demanded) of Requirement_Name :=
     (First_Answer => F2_Admitted,
      Own_Answer   => F4_Own_Answer,
      Robot_Answer => F4_Robot_Answer,
      Monitor_Lost => F6_Stop,
      Reload       => F11_Reload,
      First_Byte   => F12_First_Byte,
      Last_Byte    => F12_At_Robot,
      Level        => F13_Level);

   type Subject_Times is array (Subject) of Samples.Set;
   type Subject_Deadlines is array (Subject) of Reports.Deadline;

   type Span is record
      Of_What  : Subject := Image;
      From, To : Instant := Never;
   end record;

   package Span_Vectors is new Ada.Containers.Vectors (Positive, Span);

   type Sending is record
      Time, Answered : Instant := Never;
      Order          : Unbounded_String;
      --  as it will be on the wire, "" where it will not
   end record;

   type Arrival is record
      Time  : Instant       := Never;
      Label : Message_Label := (others => ' ');
   end record;

   package Arrival_Vectors is new Ada.Containers.Vectors (Positive, Arrival);

   package Sending_Vectors is new Ada.Containers.Vectors (Positive, Sending);

   Baud      : constant Positive := 9_600;
   Byte_Time : constant Duration := Duration (10_000_000 / Baud) / 1_000_000;
   Frame_End : constant := 2;
   --  the checksum and the end of an answer

   Command_Interval : constant Duration :=
     Duration (Budgets.Command_Interval) / 1_000_000;
   Reload_Period    : constant Duration := 1.0;
   Battery_Offset   : constant Duration := 0.25;
   Battery_Period   : constant Duration := 0.5;

   Line_Rest : constant Duration := 0.001;
   --  how long who has the line may take after an exchange before it is
   --  free again

   --  for an answer

   type Tally is record
      Sessions  : Natural := 0;
      Broken    : Natural := 0;
      --  of these, ended by something that did not come
      Orders    : Natural := 0;
      Robots    : Natural := 0;
      --  lost: an order did not have the answer that it should
      Windows   : Natural := 0;
      --  of the watchdog, missed by a reload
      Reloads   : Natural := 0;
      Stops     : Natural := 0;
      Levels    : Natural := 0;
      --  that did not come
   end record;

   Source  : Generator;
   Watched : Boolean := False;

   procedure Take_Bounds (Result : in out Subject_Deadlines) is
      Known : Analysis;

      procedure Take (Which : Subject; Name : Requirement_Name) is
         Item : Requirement renames Known.Requirements (Name);
         To   : Reports.Deadline renames Result (Which);
      begin
         Check (Item.Known, "no bound for " & Name_Of (Which));
         To.Bound := To.Bound + Duration (Item.Bound) / 1_000_000;
         To.Limit := To.Limit + Duration (Item.Limit) / 1_000_000;
      end Take;

   begin
      Analyse
        (Of_The_Table,
         (if System.Multiprocessors.Number_Of_CPUs > 1 then Real_Time_Apart
          else One_Processor),
         (others => <>), (others => <>), Known);
      for Which in Demanded loop
         Take (Which, Requirement_Of (Which));
         Result (Which).Of_All := Always (Requirement_Of (Which));
      end loop;
      Take (First_Answer, F4_Own_Answer);
   end Take_Bounds;

   procedure Lose (R : in out Rig; Number : Natural) is
   begin
      case Number mod 3 is
         when 0      => R.Monitor.Close;
         when 1      => R.Monitor.Reset;
         when others => R.Monitor.Half_Close;
      end case;
   end Lose;

   procedure Drive
     (R        : in out Rig;
      End_Time : Instant;
      Spans    : in out Span_Vectors.Vector;
      Sent     : in out Sending_Vectors.Vector;
      Found    : in out Arrival_Vectors.Vector;
      Sound    : out Boolean;
      Count    : in out Tally)
   is
      --  A session, from its connection to its loss. Found: what came to the
      --  monitor from when on all was under way. Sound: the robot was not
      --  lost, which ends it
      Begun  : constant Instant := Now;
      Due    : Instant;
      Unused : Message;
      Missed : Natural;
      First  : Positive;
      Number : Natural := 0;

      procedure Ask (Command, Wire, Wanted : String) is
         Time : Instant;
         Item : Message;
      begin
         R.Monitor.Skip_To_Now;
         Time := Now;
         R.Monitor.Send_Line (Command);
         Item := R.Monitor.Next_Answer (Command);
         Count.Orders := Count.Orders + 1;
         if Item.Label /= Wanted then
            Sound := False;
            --  what the watch for stand-stills has yet to notice
            delay 0.1;
            Reports.Put_Note
              ("session" & Count.Sessions'Image & ": " & Command
               & " answered by " & Item.Label & ", of "
               & Milliseconds (Item.Time - Time) & " stood still: "
               & Milliseconds (Standstills.Within (Time, Item.Time)));
            return;
         end if;
         Sent.Append ((Time, Item.Time, To_Unbounded_String (Wire)));
         if Wire = "" then
            Spans.Append ((Own_Answer, Time, Item.Time));
         end if;
      end Ask;

   begin
      Sound := True;
      Connect (R);
      R.Monitor.Send_Line ("RPIN");
      Spans.Append ((First_Answer, Begun, R.Monitor.Next_Answer.Time));
      Play (R, Guarded);
      Play (R, With_Positions);
      Missed := R.Emulator.Status_Number ("missed_total");
      First := R.Monitor.Count + 1;
      Due := Now;
      while Sound and then Now < End_Time loop
         Number := Number + 1;
         declare
            Value : constant String := Image (1 + Number mod 9_000);
         begin
            case Number mod 6 is
               when 0 => Ask ("RMOV:-" & Value, "M=-" & Value, "AACK");
               when 1 => Ask ("RTRN:" & Value, "T=" & Value, "AACK");
               when 2 => Ask ("RGST", "b", "RCST");
               when 3 => Ask ("RMOV:" & Value, "M=" & Value, "AACK");
               when 4 => Ask ("what", "", "ACER");
               when others => Ask ("RSTP", "M=0", "AACK");
            end case;
         end;
         --  not in step with the periods, and never sooner
         Due := Instant'Max
           (Now, Due + Command_Interval + 0.01 * Duration (Random (Source)));
         delay Due - Now;
      end loop;
      if Sound then
         Count.Windows := Count.Windows
           + R.Emulator.Status_Number ("missed_total") - Missed;
      else
         Count.Robots := Count.Robots + 1;
      end if;
      delay Command_Interval;
      for Place in First .. R.Monitor.Count loop
         Found.Append
           ((R.Monitor.Element (Place).Time, R.Monitor.Element (Place).Label));
      end loop;
      if Sound and then Number mod 2 = 0 then
         --  while an order is under way
         R.Monitor.Send_Line ("RMOV:9001");
         delay 0.015 * Duration (Random (Source));
      end if;
      Lose (R, Count.Sessions);
   end Drive;

   procedure Look_At_Line
     (Journal : Emulators.Notes;
      Sent    : Sending_Vectors.Vector;
      Lost    : Instant;
      Sound   : Boolean;
      Spans   : in out Span_Vectors.Vector;
      Start   : out Instant;
      Count   : in out Tally)
   is
      --  Start: when the robot's answer to the start had come
      Place   : Positive := 1;
      --  in Sent
      Free    : Instant  := Never;
      --  when the line was, after the exchange before
      Answer  : Instant;
      Stopped : Boolean  := False;
      Reloads : Natural  := 0;
      Turn    : Natural;
      Due     : Instant;
   begin
      Start := Never;
      for Item of Journal loop
         Answer := Item.Last + (Length (Item.Answer) + Frame_End) * Byte_Time;
         while Place <= Sent.Last_Index
           and then (Sent (Place).Order = ""
                     or else Sent (Place).Answered < Item.First)
         loop
            Place := Place + 1;
         end loop;
         if Place <= Sent.Last_Index
           and then Sent (Place).Order = Item.Command
           and then Sent (Place).Time < Item.First
         then
            if Item.Command /= "b" then
               Spans.Append ((Last_Byte, Sent (Place).Time, Item.Last));
               if Free + Line_Rest < Sent (Place).Time then
                  Spans.Append ((First_Byte, Sent (Place).Time, Item.First));
               end if;
            end if;
            Spans.Append ((Robot_Answer, Answer, Sent (Place).Answered));
            Place := Place + 1;
         elsif Item.Command = "W" then
            Start := Answer;
         elsif Item.Command = "w" and then Item.First < Lost
           and then (Sound or else Place <= Sent.Last_Index)
         then
            Reloads := Reloads + 1;
            Turn := Natural ((Item.First - Start) / Reload_Period);
            Due := Start + Turn * Reload_Period;
            Spans.Append ((Reload, Instant'Min (Due, Item.First),
                           Instant'Max (Due, Item.First)));
         elsif Item.Command = "M=0" and then Item.First >= Lost
           and then Sound and then not Stopped
         then
            Stopped := True;
            Spans.Append ((Monitor_Lost, Lost, Item.Last));
         end if;
         Free := Answer;
      end loop;
      Check (Start /= Never, "no start on the line");
      if not Sound then
         return;
      end if;
      Count.Stops := Count.Stops + Boolean'Pos (not Stopped);
      --  those that were due, but for one that may be on its way
      Turn := Natural
        (Duration'Max
           (0.0, (Lost - Start) / Reload_Period - 0.55));
      Count.Reloads := Count.Reloads + Integer'Max (0, Turn - Reloads);
   end Look_At_Line;

   procedure Look_At_Messages
     (Found : Arrival_Vectors.Vector;
      Start : Instant;
      Spans : in out Span_Vectors.Vector;
      Count : in out Tally)
   is
      Due    : Instant := Never;
      Before : Instant := Never;
   begin
      for Item of Found loop
         if Item.Label = "CIMG" then
            if Before /= Never then
               Spans.Append ((Image, Before, Item.Time));
            end if;
            Before := Item.Time;
         elsif Item.Label = "RBLV" then
            if Due = Never then
               Due := Start + Battery_Offset;
               while Due + Battery_Period <= Item.Time loop
                  Due := Due + Battery_Period;
               end loop;
            else
               Due := Due + Battery_Period;
            end if;
            Spans.Append ((Level, Due, Item.Time));
            while Due + 2 * Battery_Period <= Item.Time loop
               --  the next one is this one's
               Count.Levels := Count.Levels + 1;
               Due := Due + Battery_Period;
            end loop;
         end if;
      end loop;
      Check (Due /= Never, "no battery level");
      while Due + 2 * Battery_Period < Found.Last_Element.Time loop
         Count.Levels := Count.Levels + 1;
         Due := Due + Battery_Period;
      end loop;
   end Look_At_Messages;

   procedure Note
     (Spans : Span_Vectors.Vector;
      Times : in out Subject_Times;
      Kept  : in out Subject_Deadlines)
   is

      procedure Compare
        (Item  : Span;
         Limit : Duration;
         Above : in out Natural;
         Ran   : in out Natural)
      is
         Time : constant Duration := Item.To - Item.From;
      begin
         if Limit > 0.0 and then Time > Limit then
            Above := Above + 1;
            if Time - Standstills.Within (Item.From, Item.To) > Limit then
               Ran := Ran + 1;
            end if;
         end if;
      end Compare;

   begin
      for Item of Spans loop
         declare
            To : Reports.Deadline renames Kept (Item.Of_What);
         begin
            Times (Item.Of_What).Add (Item.To - Item.From);
            Compare (Item, To.Bound, To.Longer, To.Longer_Ran);
            Compare (Item, To.Limit, To.Missed, To.Missed_Ran);
         end;
      end loop;
   end Note;

   procedure Report (Kept, Stood_Still : out Boolean) is
      R         : Rig;
      Load      : Busy_Loops.Load;
      Times     : Subject_Times;
      Deadlines : Subject_Deadlines;
      Count     : Tally;
      Host      : constant Duration := Standstills.Taken_By_Host;
      End_Time  : Instant;
      Taken     : Duration;
      Said      : Instant := Now;

      procedure Put (Name : String; Value : Natural; Most : Integer := -1) is
      begin
         Reports.Put_Number
           (Name, Float (Value), "",
            Wanted => (if Most < 0 then Reports.No_Goals
                       else (1 => (Reports.Value, Float (Most)))));
      end Put;

      procedure Run_Session is
         Spans : Span_Vectors.Vector;
         Sent  : Sending_Vectors.Vector;
         Found : Arrival_Vectors.Vector;
         Start : Instant;
         Sound : Boolean;
      begin
         R.Emulator.Clear_Journal;
         Drive (R,
                Instant'Min
                  (End_Time, Now + 10.0 + 10.0 * Duration (Random (Source))),
                Spans, Sent, Found, Sound, Count);
         --  the stop, and what the watch for stand-stills has yet to notice
         delay 0.5;
         Look_At_Line
           (R.Emulator.Journal, Sent, R.Monitor.Left_At, Sound, Spans, Start,
            Count);
         if Sound then
            Look_At_Messages (Found, Start, Spans, Count);
         end if;
         Note (Spans, Times, Deadlines);
      end Run_Session;

   begin
      Reports.Begin_Section
        ("deadlines", "from end to end, between the monitor's socket and the"
         & " robot's line");
      if not Watched then
         Standstills.Watch (Turn => 1, Lines => True);
         Watched := True;
      end if;
      Standstills.Forget;
      Take_Bounds (Deadlines);
      Loads.Assemble
        (R, "--baud" & Positive'Image (Baud), Connected => False);
      Load.Start (Yielding => True);
      Own_Process.Prefer_Real_Time (True);
      End_Time := Now + Duration (Bench_Settings.Seconds);
      while Now < End_Time loop
         Count.Sessions := Count.Sessions + 1;
         begin
            Run_Session;
         exception
            when Problem : Failed =>
               Check (R.Supervisor.Is_Running,
                      "the supervisor has ended: " & R.Supervisor.Text);
               Count.Broken := Count.Broken + 1;
               Reports.Put_Note ("session" & Count.Sessions'Image & ": "
                                 & Ada.Exceptions.Exception_Message (Problem));
         end;
         R.Monitor.Close;
         if Now - Said > 300.0 then
            Ada.Text_IO.Put_Line
              ("   sessions" & Count.Sessions'Image & ", broken"
               & Count.Broken'Image & ", orders" & Count.Orders'Image);
            Said := Now;
         end if;
         delay 1.0;
      end loop;
      Own_Process.Prefer_Real_Time (False);
      Load.Stop;

      Kept := Count.Stops + Count.Reloads + Count.Levels + Count.Broken = 0;
      for Which in Subject loop
         Reports.Put_Deadline
           (Name_Of (Which), Times (Which), Deadlines (Which));
         Kept := Kept
           and then not (Deadlines (Which).Of_All
                         and then Deadlines (Which).Missed_Ran > 0);
      end loop;
      Put ("sessions", Count.Sessions);
      Put ("sessions that broke off", Count.Broken, 0);
      Put ("orders", Count.Orders);
      Put ("sessions in which the robot was lost", Count.Robots, 0);
      Put ("stops after a loss that did not come", Count.Stops, 0);
      Put ("reloads that did not come", Count.Reloads, 0);
      Put ("windows of the watchdog missed", Count.Windows, 0);
      Put ("battery levels that did not come", Count.Levels, 0);
      Reports.Put_Number ("longest stand-still of a processor",
                          1.0E6 * Float (Standstills.Longest), "us");
      Taken := Standstills.Taken_By_Host - Host;
      Reports.Put_Number
        ("longest way of a byte through another pseudo-terminal",
         1.0E6 * Float (Standstills.Longest_Line), "us");
      Reports.Put_Number ("time that the host took", Float (Taken), "s");
      Stood_Still := Standstills.Has_Stood_Still (Host);
      Reports.End_Section;
   end Report;

begin
   Reset (Source, 5544);
end Deadline_Times;
