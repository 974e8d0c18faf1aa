--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line through a pair of radios (destijl_emulator --radio).
--  Without retries an exchange takes less than 50 ms.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Expectations;          use Expectations;
with Monitor_Clients;       use Monitor_Clients;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;

procedure Radio_Tests is

   No_Retries : constant String := "--radio-retries 0";

   procedure Some_Lost (R : in out Rig) is
      --  Commands and answers: each command is answered, and all works after
      Not_Received : Natural := 0;
   begin
      for Number in 1 .. 100 loop
         R.Monitor.Send_Line ("RGST");
         Check_Label (R.Monitor.Next_Answer ("RGST"), "RCST ATIM", "RGST");
      end loop;
      for Item of R.Emulator.Journal loop
         Not_Received := Not_Received + Boolean'Pos (Item.Answer = "-");
      end loop;
      Check (Not_Received > 0
             and then R.Emulator.Status_Number ("spoilt") > Not_Received,
             "not in both directions:" & Not_Received'Image);
      Play (R, "tell mend, RGST RCST:0, RGBT RBLV:2, RSOW AACK, RGFW AACK");
   end Some_Lost;

   procedure Bursts_Of_Retries (R : in out Rig) is
      --  Half of all attempts are repeated: some answers come after the
      --  time-out, and none is taken for the next
      Late : Natural := 0;

      procedure Ask (Command, Answer : String) is
         Item : Message;
      begin
         R.Monitor.Send_Line (Command);
         Item := R.Monitor.Next_Answer (Command);
         Late := Late + Boolean'Pos (Item.Label = "ATIM");
         Check (Item.Label = "ATIM"
                or else Item.Label & To_String (Item.Data) = Answer,
                Command & ": " & Item.Label & To_String (Item.Data));
      end Ask;

   begin
      for Number in 1 .. 30 loop
         Ask ("RGST", "RCST0");
         Ask ("RGBT", "RBLV1");
      end loop;
      Check (Late > 0, "none is late");
      Play (R, "unsaid robot lost, tell mend, RGST RCST:0, RSOW AACK");
   end Bursts_Of_Retries;

   procedure Add_Driving (Name, Options : String; Missed : Natural) is
      --  20 s while the robot drives, Missed reloads at most; no deadline is
      --  guaranteed without real-time priorities, but it keeps driving

      procedure Run (R : in out Rig) is
         Commands : constant Natural := Natural (R.Emulator.Journal.Length);
         Reloads  : constant Natural := R.Emulator.Count_Of ("w");
      begin
         Note (Reloads'Image & " reloads," & Commands'Image
               & " commands in 20 s");
         --  of 39 ms each, a short one: a quarter of the line's time
         Check_In_Time
           (Commands <= 150, "so much for others:" & Commands'Image);
         Check_In_Time (Reloads in 18 .. 22, Reloads'Image & " reloads");
         if R.Supervisor.Says ("real-time priorities: FIFO") then
            Check_In_Time (R.Emulator.Status_Number ("missed_total") <= Missed,
                           "missed" & R.Emulator.Status ("missed_total"));
         end if;
         Play (R, "status disabled_count 0, status moving 1,"
               & " unsaid robot lost, RSTP AACK, status moving 0");
      end Run;

   begin
      Script ("F11_Radio_Watchdog_Kept_" & Name,
              Guarded & ", RGFW AACK, clear, wait 20", Run'Access,
              Emulator_Options => Options, Timed => True);
   end Add_Driving;

begin
   Add_Driving ("For_20_s", No_Retries, Missed => 0);
   Add_Driving ("With_Retries", "--radio", Missed => 2);
   --  A reload whose answer is late because of two retries may cost the next
   Script ("F08_Radio_Some_Packets_Lost",
           "ROPN AACK, clear, tell radio-losses 5", Some_Lost'Access,
           Emulator_Options => No_Retries);
   Script ("F09_Radio_All_Packets_Lost",
           Forward & ","
           & " tell radio-losses 100, comes ATIM, log robot lost, seen M=0,"
           & " status moving 1, tell mend, " & Works_Again
           & ", status moving 0, RRST AACK",
           Emulator_Options => No_Retries, Times => 2);
   --  The last stop is lost as well
   Script ("F08_Radio_Bursts_Of_Retries", "ROPN AACK, tell radio-bursts 100",
           Bursts_Of_Retries'Access,
           Emulator_Options => No_Retries & " --battery 1",
           Supervisor_Options => "--answer-timeout 200");
   Script ("F08_Radio_Late_Answers",
           "ROPN AACK, RPIN AACK, tell radio-retries 100, RPIN ATIM,"
           & " tell radio-retries 0, wait 1.0, RGBT RBLV:1, RGST RCST:0,"
           & " unsaid robot lost",
           Emulator_Options => No_Retries & " --battery 1", Times => 3);
   --  8 retries in each direction: half a second
   Script
     ("F07_F12_Radio_Driven",
      "ROPN AACK, RSWW AACK, clear, RGFW AACK, status moving 1, RGST RCST:1,"
      & " RGBT RBLV:2, RSTP AACK, status moving 0, RTRN:90 AACK,"
      & " RMOV:32767 AACK, wire M=32767 M=0 T=90 M=32767, clear, RCLS AACK,"
      & " seen M=0, status moving 0, unsaid robot lost",
      Emulator_Options => No_Retries, Times => 3);
   Script ("F05_Radio_Stopped_At_The_End",
           Forward & ", close, seen M=0, status moving 0,"
           & " log ready for a new monitor, connect",
           Emulator_Options => No_Retries, Times => 3);
   Script ("F05_Radio_Stopped_By_Sigterm",
           Forward & ", signal 15, seen M=0, status moving 0",
           Emulator_Options => No_Retries);
   --  The stop is on its way when the line is closed
end Radio_Tests;
