--  SPDX-License-Identifier: GPL-3.0-or-later
--  The loads, and how the supervisor is started for them.

with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Bench_Settings;
with Budgets;
with Busy_Loops;
with Child_Processes; use Child_Processes;
with Expectations; use Expectations;
with Instants; use Instants;
with Monitor_Clients; use Monitor_Clients;
with Own_Process;
with Plain_Numbers; use Plain_Numbers;
with Programs;
with Reports;

package body Loads is

   function Launcher return String is
      Raised : constant String := "prlimit --memlock=unlimited:unlimited";
   begin
      return
        (if Status_Of (Raised & " true") = 0
         then Raised & " " & Programs.As_Service
         else Programs.As_Service ("+sys_nice,+ipc_lock"));
   end Launcher;

   procedure Assemble
     (R                  : in out Rig;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Connected          : Boolean := True)
   is
      As_Service : Boolean renames Bench_Settings.As_Service;
   begin
      Rigs.Assemble
        (R, Camera => True, Emulator_Options => Emulator_Options,
         Supervisor_Options =>
           (if As_Service then "--cpu auto " else "") & Supervisor_Options,
         Launcher  => (if As_Service then Launcher else ""),
         Program   =>
           (if As_Service then Programs.Copied_Supervisor else ""),
         Connected => Connected);
      if As_Service then
         Check (R.Supervisor.Says ("deadlines: as analysed", Patience),
                R.Supervisor.Text);
         Reports.Put_Note ("as the service; its deadlines, it says, are as"
                           & " analysed");
      end if;
   end Assemble;

   procedure Drive (R : in out Rig; For_Time : Duration) is
      Pause  : constant Duration :=
        Duration (Budgets.Command_Interval) / 1_000_000;
      Start  : constant Instant := Now;
      Number : Natural := 0;
      Unused : Message;
   begin
      while Now - Start < For_Time loop
         Number := Number + 1;
         Unused := R.Monitor.Ask ((case Number mod 4 is
                                      when 0 => "RMOV:-100",
                                      when 1 => "RTRN:90",
                                      when 2 => "RSTP",
                                      when others => "RGST"));
         delay Pause;
      end loop;
   end Drive;

   Question_Interval : constant Duration :=
     Duration (Budgets.Question_Interval) / 1_000_000;

   Most_Points : constant := 64;

   Source : Generator;

   function Place (Side : Positive) return String is
     (Image (10 + Natural (Random (Source) * Float (Side - 20))) & ".25");
   --  Centimetres, not too near to the edges

   function Random_Path (Points : Positive) return String is
      --  The order of a mission
      Text : Unbounded_String := To_Unbounded_String ("MPCM");
   begin
      for Number in 1 .. Points loop
         Append (Text,
                 (if Number = 1 then ":" else ";") & Place (80) & ";"
                 & Place (60));
      end loop;
      return To_String (Text);
   end Random_Path;

   procedure Drive_Missions (R : in out Rig; For_Time : Duration) is
      Start : constant Instant := Now;
      Count : Natural := 0;
      Wrong : Natural := 0;
      Ends  : Natural := R.Monitor.Count_Of ("MEND");
      --  with that of the mission under way

      function Last_End return Unbounded_String is
         --  What the monitor has been told last
         Place : Natural := R.Monitor.Count;
      begin
         while R.Monitor.Element (Place).Label /= "MEND" loop
            Place := Place - 1;
         end loop;
         return R.Monitor.Element (Place).Data;
      end Last_End;

      function Answer_To (Question : String) return Message_Label is
         Item : constant Message := R.Monitor.Ask (Question);
      begin
         delay Question_Interval;
         return Item.Label;
      end Answer_To;

      procedure Ask (Question : String; Wanted : Message_Label) is
         Label : constant Message_Label := Answer_To (Question);
      begin
         Check (Label = Wanted, Question & " is answered by " & Label);
      end Ask;

      procedure Ask_For_Another is
         --  Rejected while one is under way; where that has just ended, not
      begin
         if Answer_To (Random_Path (Most_Points)) = "AACK" then
            Ends := Ends + 1;
            Ask ("RSTP", "AACK");
         end if;
      end Ask_For_Another;

      procedure Drive_One (By_Hand : Boolean; As_Meant : out Boolean) is
         Begun : constant Instant := Now;
         Own   : constant Positive := Ends + 1;
         Turn  : Natural := 0;
      begin
         As_Meant := Answer_To (Random_Path (Points => 3)) = "AACK";
         if not As_Meant then
            return;
         end if;
         Ends := Own;
         while R.Monitor.Count_Of ("MEND") < Ends loop
            Turn := Turn + 1;
            if By_Hand and then Now - Begun > 1.0 then
               Ask ("RSTP", "AACK");
            elsif Turn mod 4 = 0 then
               Ask_For_Another;
            elsif Turn mod 4 = 1 then
               Ask ("what", "ACER");
            else
               Ask ("RGST", "RCST");
            end if;
            Check (Now - Begun < 120.0, "a mission does not end");
         end loop;
         As_Meant := Ends > Own
           or else Last_End =
             (if By_Hand then "aborted;order by hand" else "done");
      end Drive_One;

      As_Meant : Boolean;
   begin
      Reset (Source, 1919);
      loop
         Count := Count + 1;
         Drive_One (By_Hand => Count mod 3 = 0, As_Meant => As_Meant);
         Wrong := Wrong + Boolean'Pos (not As_Meant);
         exit when Now - Start >= For_Time;
      end loop;
      Reports.Put_Number ("missions", Float (Count));
      Reports.Put_Number ("missions that did not end as meant", Float (Wrong));
   end Drive_Missions;

   procedure Carry_Out
     (R        : in out Rig;
      Missions : Boolean;
      Options  : String := "";
      Begun    : access procedure := null)
   is
      For_Time : constant Duration := Duration (Bench_Settings.Short_Seconds);
      Load     : Busy_Loops.Load;
      Unused   : Message;
   begin
      --  the analysis has such a camera beside missions
      Assemble (R, (if Missions then "--camera-fps 30" else ""), Options);
      Play (R, Guarded);
      Play (R, With_Positions);
      if Missions then
         Play (R, Arena_Searched);
         R.Monitor.Send_Line ("CACO");
         for Number in 1 .. 4 loop
            Unused := R.Monitor.Next_Of ("CPOS");
         end loop;
      end if;
      Load.Start;
      Own_Process.Prefer_Real_Time (True);
      if Begun /= null then
         Begun.all;
      end if;
      if Missions then
         Drive_Missions (R, For_Time);
      else
         Drive (R, For_Time);
      end if;
      Own_Process.Prefer_Real_Time (False);
      Load.Stop;
   end Carry_Out;

end Loads;
