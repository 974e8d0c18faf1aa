--  SPDX-License-Identifier: GPL-3.0-or-later
--  From end to end: sessions, each from its connection to its loss, under the
--  load of the analysis. Puts what was sent and seen at both ends, and when.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Exceptions;
with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with System.Multiprocessors; use type System.Multiprocessors.CPU;

with Bench_Settings;
with Budgets;
with Busy_Loops;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Loads;
with Monitor_Clients;       use Monitor_Clients;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Reports;               use Reports;
with Rigs;                  use Rigs;
with Standstills;
with Supervisor_Model;      use Supervisor_Model;

procedure Report_Deadlines is

   Command_Interval : constant Duration :=
     Duration (Budgets.Command_Interval) / 1_000_000;

   type List is new Unbounded_String;
   --  Of JSON, without its brackets

   type Session is record
      Begun, Answered : Instant := Never;
      --  its connection, and the first answer
      Sent : List;
      --  orders: when, when answered, as they will be on the wire, "" where
      --  they will not
      Lost : List;
      --  the order without the answer that it should have, which ends the
      --  session: when, when answered, by which label, what it was
      Seen : List;
      --  messages to the monitor while all was under way: when, their labels
   end record;

   Sessions, Orders, Windows : Natural := 0;
   --  Windows: of the watchdog, missed by a reload

   Source   : Generator;
   R        : Rig;
   Load     : Busy_Loops.Load;
   Host     : constant Duration := Standstills.Taken_By_Host;
   End_Time : Instant;

   procedure Add (To : in out List; Time : Instant; More : String) is
   begin
      Append (To, (if Length (To) = 0 then "[" else ",[") & Time'Image & ","
              & More & "]");
   end Add;

   procedure Put_Demands is
      --  The bounds of the analysis and the limits of the features
      Known : Analysis;
   begin
      Analyse
        (Of_The_Table,
         (if System.Multiprocessors.Number_Of_CPUs > 1 then Real_Time_Apart
          else One_Processor),
         (others => <>), (others => <>), Known);
      for Name in Requirement_Name loop
         if Known.Requirements (Name).Known then
            Reports.Put_Members
              ("""demand"": " & Quoted (To_Lower (Name'Image))
               & ", ""bound"":" & Known.Requirements (Name).Bound'Image
               & ", ""limit"":" & Known.Requirements (Name).Limit'Image
               & ", ""every"": " & To_Lower (Boolean'Image (Always (Name))));
         end if;
      end loop;
   end Put_Demands;

   procedure Lose (Number : Natural) is
   begin
      case Number mod 3 is
         when 0      => R.Monitor.Close;
         when 1      => R.Monitor.Reset;
         when others => R.Monitor.Half_Close;
      end case;
   end Lose;

   procedure Drive (Until_Time : Instant; Item : in out Session) is
      Due    : Instant;
      Missed : Natural;
      First  : Positive;
      Number : Natural := 0;

      procedure Ask (Command, Wire, Wanted : String) is
         Time   : Instant;
         Answer : Message;
      begin
         R.Monitor.Skip_To_Now;
         Time := Now;
         R.Monitor.Send_Line (Command);
         Answer := R.Monitor.Next_Answer (Command);
         Orders := Orders + 1;
         if Answer.Label = Wanted then
            Add (Item.Sent, Time, Answer.Time'Image & "," & Quoted (Wire));
         else
            Add (Item.Lost, Time, Answer.Time'Image & ","
                 & Quoted (Answer.Label) & "," & Quoted (Command));
         end if;
      end Ask;

   begin
      Item.Begun := Now;
      Connect (R);
      R.Monitor.Send_Line ("RPIN");
      Item.Answered := R.Monitor.Next_Answer.Time;
      Play (R, Guarded);
      Play (R, With_Positions);
      Missed := R.Emulator.Status_Number ("missed_total");
      First := R.Monitor.Count + 1;
      Due := Now;
      while Item.Lost = "" and then Now < Until_Time loop
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
      if Item.Lost = "" then
         Windows := Windows
           + R.Emulator.Status_Number ("missed_total") - Missed;
      end if;
      delay Command_Interval;
      for Place in First .. R.Monitor.Count loop
         Add (Item.Seen, R.Monitor.Element (Place).Time,
              Quoted (R.Monitor.Element (Place).Label));
      end loop;
      if Item.Lost = "" and then Number mod 2 = 0 then
         --  while an order is under way
         R.Monitor.Send_Line ("RMOV:9001");
         delay 0.015 * Duration (Random (Source));
      end if;
      Lose (Sessions);
   end Drive;

   procedure Run_Session is
      Item         : Session;
      Line, Stalls : List;

      procedure Add_Stall (From, To : Instant) is
      begin
         Add (Stalls, From, To'Image);
      end Add_Stall;

      function Member (Name : String; Value : List) return String is
        (", """ & Name & """: [" & To_String (Value) & "]");

   begin
      R.Emulator.Clear_Journal;
      Drive
        (Instant'Min
           (End_Time, Now + 10.0 + 10.0 * Duration (Random (Source))), Item);
      --  the stop, and what the watch for stand-stills has yet to notice
      delay 0.5;
      for Frame of R.Emulator.Journal loop
         Add (Line, Frame.First,
              Frame.Last'Image & "," & Quoted (To_String (Frame.Command)) & ","
              & Natural'Image (Length (Frame.Answer)));
      end loop;
      Standstills.Tell (Item.Begun, Add_Stall'Access);
      Reports.Put_Members
        ("""session"":" & Sessions'Image & ", ""begun"":" & Item.Begun'Image
         & ", ""answered"":" & Item.Answered'Image
         & ", ""left"":" & R.Monitor.Left_At'Image
         & Member ("sent", Item.Sent) & Member ("lost", Item.Lost)
         & Member ("seen", Item.Seen) & Member ("line", Line)
         & Member ("stalls", Stalls));
   end Run_Session;

begin
   Reset (Source, 5544);
   Reports.Begin_Section
     ("deadlines", "from end to end, between the monitor's socket and the"
      & " robot's line");
   Standstills.Watch (Turn => 1, Lines => True);
   Put_Demands;
   Loads.Assemble (R, "--baud 9600", Connected => False);
   Load.Start (Yielding => True);
   Own_Process.Prefer_Real_Time (True);
   End_Time := Now + Duration (Bench_Settings.Seconds);
   while Now < End_Time loop
      Sessions := Sessions + 1;
      begin
         Run_Session;
      exception
         when Problem : Failed =>
            Check (R.Supervisor.Is_Running,
                   "the supervisor has ended: " & R.Supervisor.Text);
            Reports.Put_Members
              ("""broken"": "
               & Quoted (Ada.Exceptions.Exception_Message (Problem)));
      end;
      R.Monitor.Close;
      delay 1.0;
   end loop;
   Own_Process.Prefer_Real_Time (False);
   Load.Stop;
   Reports.Put_Number ("sessions", Float (Sessions));
   Reports.Put_Number ("orders", Float (Orders));
   Reports.Put_Number ("windows of the watchdog missed", Float (Windows));
   Reports.Put_Number ("longest stand-still of a processor",
                       1.0E6 * Float (Standstills.Longest), "us");
   Reports.Put_Number
     ("longest way of a byte through another pseudo-terminal",
      1.0E6 * Float (Standstills.Longest_Line), "us");
   Reports.Put_Number
     ("time that the host took", Float (Standstills.Taken_By_Host - Host),
      "s");
   Reports.Put_Members
     ("""stood_still"": "
      & To_Lower (Boolean'Image (Standstills.Has_Stood_Still (Host))));
end Report_Deadlines;
