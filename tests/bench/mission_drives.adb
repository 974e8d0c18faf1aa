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

   function Random_Path (Points : Positive) return String;
   --  The order of a mission

   function Random_Path (Points : Positive) return String is
      Text : Unbounded_String := To_Unbounded_String ("MPCM");
   begin
      for Number in 1 .. Points loop
         Append
           (Text,
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
      R.Monitor.Skip_To_Now;
      Check
        (R.Monitor.Ask ("CASA", Within => 5.0).Label = "CIMG", "no arena");
      delay 0.3;
      R.Monitor.Send_Line ("CACO");
      for Number in 1 .. 4 loop
         Unused := R.Monitor.Next_Of ("CPOS", Within => 5.0);
      end loop;
   end Prepare;

   procedure Drive (R : in out Rig; For_Time : Duration) is
      Start  : constant Instant := Now;
      Number : Natural := 0;
      Ends   : Natural := 0;
      --  that are expected, of this monitor

      function Answer_To (Question : String) return Message_Label;

      procedure Ask (Question : String; Wanted : Message_Label);

      procedure Ask_For_Another;
      --  Rejected while one is under way; where that has just ended, not

      procedure Expect_End (Wanted : String);

      procedure Drive_One (By_Hand : Boolean);

      function Answer_To (Question : String) return Message_Label is
         Item : constant Message := R.Monitor.Ask (Question, Within => 5.0);
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
      begin
         if Answer_To (Random_Path (Most_Points)) = "AACK" then
            Ends := Ends + 1;
            Ask ("RSTP", "AACK");
         end if;
      end Ask_For_Another;

      procedure Expect_End (Wanted : String) is
         Place : Natural := R.Monitor.Count;
      begin
         while R.Monitor.Element (Place).Label /= "MEND" loop
            Place := Place - 1;
         end loop;
         Check
           (R.Monitor.Element (Place).Data = Wanted,
            "a mission ends with "
            & To_String (R.Monitor.Element (Place).Data));
      end Expect_End;

      procedure Drive_One (By_Hand : Boolean) is
         Begun : constant Instant := Now;
         Turn  : Natural := 0;
      begin
         Ask (Random_Path (Points => 3), "AACK");
         Ends := Ends + 1;
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
         if By_Hand then
            Expect_End ("aborted;order by hand");
         elsif Ends = Number then
            Expect_End ("done");
         else
            --  the end that came last is that of another
            Number := Ends;
         end if;
      end Drive_One;

   begin
      Reset (Source, 1919);
      loop
         Number := Number + 1;
         Drive_One (By_Hand => Number mod 3 = 0);
         exit when Now - Start >= For_Time;
      end loop;
   end Drive;

   procedure Measure_Tasks is
      R    : Rig;
      Load : Busy_Loops.Load;
   begin
      Assemble
        (R, Camera => True, Emulator_Options => "--baud 9600",
         Supervisor_Options => Service_Starts.Options,
         Launcher => Service_Starts.Launcher,
         Program => Service_Starts.Program);
      Prepare (R);
      Load.Start;
      Task_Times.Start (R.Supervisor.Pid);
      Drive (R, Duration (Bench_Settings.Short_Seconds));
      Task_Times.Stop;
   end Measure_Tasks;

end Mission_Drives;
