--  SPDX-License-Identifier: GPL-3.0-or-later
--  The load beside missions.

with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Strings.Unbounded;     use Ada.Strings.Unbounded;

with Bench_Settings;
with Budgets;
with Busy_Loops;
with Expectations;    use Expectations;
with Instants;        use Instants;
with Monitor_Clients; use Monitor_Clients;
with Plain_Numbers;   use Plain_Numbers;
with Reports;
with Rigs;            use Rigs;
with Service_Starts;
with Task_Times;

package body Mission_Drives is

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

   procedure Prepare (R : in out Rig) is
      Unused : Message;
   begin
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Search_Arena (R);
      R.Monitor.Send_Line ("CACO");
      for Number in 1 .. 4 loop
         Unused := R.Monitor.Next_Of ("CPOS");
      end loop;
   end Prepare;

   procedure Drive (R : in out Rig; For_Time : Duration; Count : out Tally) is
      Start : constant Instant := Now;
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
      Count := (others => <>);
      Reset (Source, 1919);
      loop
         Count.Missions := Count.Missions + 1;
         Drive_One (By_Hand => Count.Missions mod 3 = 0, As_Meant => As_Meant);
         if not As_Meant then
            Count.Otherwise := Count.Otherwise + 1;
         end if;
         exit when Now - Start >= For_Time;
      end loop;
   end Drive;

   procedure Measure_Tasks is
      R     : Rig;
      Load  : Busy_Loops.Load;
      Count : Tally;
   begin
      Service_Starts.Assemble (R, Emulator_Options);
      Prepare (R);
      Load.Start;
      Task_Times.Start (R.Supervisor.Pid);
      Drive (R, Duration (Bench_Settings.Short_Seconds), Count);
      Task_Times.Stop;
      Report (Count);
   end Measure_Tasks;

   procedure Report (Count : Tally) is
   begin
      Reports.Put_Number ("missions", Float (Count.Missions), "");
      Reports.Put_Number
        ("missions that did not end as meant", Float (Count.Otherwise), "",
         Wanted => (1 => (Reports.Value, 0.0)));
   end Report;

end Mission_Drives;
