--  SPDX-License-Identifier: GPL-3.0-or-later
--  One supervisor for half an hour: sessions with all features, and random
--  faults in between. Compares the end with the beginning.

with Ada.Containers.Vectors;
with Ada.Exceptions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;
with Interfaces.C;          use Interfaces.C;

with Expectations;          use Expectations;
with Fault_List;
with Faults;                use Faults;
with Host_Time;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Option_Readers;        use Option_Readers;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Random_Numbers;        use Random_Numbers;
with Soak_Records;
with Standstills;
with Trials;
with Worlds;

procedure Destijl_Soak is

   Shortest : constant := 2;
   --  minutes: a tenth must have several calm stretches
   Longest  : constant := 24 * 60;

   Longest_Fault : constant Duration := 12.0;
   --  Longer ones would leave no time for others

   package Number_Vectors is new Ada.Containers.Vectors (Positive, Positive);

   Minutes  : Positive := 30;
   Seed     : Natural  := 0;
   Csv_Path : Unbounded_String;

   Source     : Generator;
   Eligible   : Number_Vectors.Vector;
   --  faults that leave the supervisor running
   Violations : Natural := 0;
   Late_Answers : Natural := 0;
   --  of the robot, in calm sessions

   Answer_Time_Out : constant Duration := 0.08;
   --  The robot's answer may take so long; with that much time stolen by the
   --  host it may be late without an error of the supervisor

   LF    : Character renames ASCII.LF;
   Usage : constant String :=
     "usage: destijl_soak [OPTION ...]" & LF
     & "   --minutes N   how long (30)" & LF
     & "   --seed N      of everything random (from the clock)" & LF
     & "   --csv FILE    write a line for each second" & LF
     & "   --supervisor PATH, --emulator PATH" & LF
     & "                 instead of those beside this one" & LF
     & "Exit status: 0 all is in the end as in the beginning," & LF
     & "1 not so, 2 bad usage.";

   procedure Read_Command_Line is
   begin
      Seed := Natural (Long_Long_Integer (Now) / 1000 mod 1_000_000);
      while Option_Readers.Next loop
         if Name = "--minutes" then
            Minutes := Number (Shortest, Longest);
         elsif Name = "--seed" then
            Seed := Number (Low => 0);
         elsif Name = "--csv" then
            Csv_Path := To_Unbounded_String (Value);
         else
            Programs.Read_Option (Usage);
         end if;
      end loop;
   end Read_Command_Line;

   procedure Choose_Faults is
      use type Worlds.Plan;
   begin
      Fault_List.Register;
      for Number in 1 .. Faults.Count loop
         declare
            P : Worlds.Plan;
         begin
            Element (Number).Prepare (P);
            P.Terminal := False;
            if P = (others => <>)
              and then Element (Number).Ends /= Supervisor_Ends
              and then Element (Number).Cost <= Longest_Fault
            then
               Eligible.Append (Number);
            end if;
         end;
      end loop;
   end Choose_Faults;

   procedure Complain (Text : String) is
   begin
      Violations := Violations + 1;
      Put_Line ("VIOLATION: " & Text);
      Flush;
   end Complain;

   procedure Stay_Calm (For_Time : Duration) is
      --  A session with all features, which is measured
      Monitor : Client;
      Amount  : Natural := 0;
      First   : Positive;
      Last    : Instant := Never;
      Start   : Instant;
      Unused  : Message;
      Taken   : constant Duration := Host_Time.Taken;

      function Is_Explained return Boolean is
        (Duration'Max (Standstills.Longest, Standstills.Longest_Line)
           >= Standstills.Too_Long
         or else Host_Time.Taken - Taken >= Answer_Time_Out);
      --  Caused by the kernel, or by the host of this machine

      procedure Ask (Command : String; Own : Boolean) is
         Item : Message;
         Time : Instant;
      begin
         Monitor.Skip_To_Now;
         Time := Now;
         Monitor.Send_Line (Command);
         Item := Monitor.Next_Answer (Command => Command);
         if Own then
            Check (Item.Label = "ACER", Command & ": " & Item.Label);
            Soak_Records.Add_Answer (Item.Time, Item.Time - Time);
         elsif Item.Label in "ATIM" | "ACRJ" and then Is_Explained then
            --  of an answer or of a reload
            Late_Answers := Late_Answers + 1;
         else
            Check (Item.Label = "AACK", Command & ": " & Item.Label);
         end if;
      end Ask;

      procedure Note_Images is
      begin
         for Number in First .. Monitor.Count loop
            declare
               Item : constant Message := Monitor.Element (Number);
            begin
               if Item.Label = "CIMG" then
                  if Last /= Never then
                     Soak_Records.Add_Image (Item.Time, Item.Time - Last);
                  end if;
                  Last := Item.Time;
               end if;
            end;
         end loop;
      end Note_Images;

   begin
      Standstills.Forget;
      Monitor.Connect (Trials.Port);
      Monitor.Expect ("ROPN", "AACK");
      Monitor.Expect ("RSWW", "AACK");
      Monitor.Expect ("COPN", "AACK");
      Monitor.Expect ("CPCO", "AACK");
      Unused := Monitor.Next_Of ("CPOS");
      Unused := Monitor.Next_Of ("CIMG");
      delay 0.5;
      First := Monitor.Count + 1;
      Own_Process.Prefer_Real_Time (True);
      Soak_Records.Set_Calm (True);
      Start := Now;
      while Now - Start < For_Time loop
         Amount := Amount + 1;
         Ask ("what", Own => True);
         delay Span (Source, 0.02, 0.06);
         if Amount mod 4 = 0 then
            Ask ((case Whole (Source, 1, 6) is
                     when 1      => "RGFW",
                     when 2      => "RGRI",
                     when 3      => "RMOV:-120",
                     when 4      => "RTRN:45",
                     when others => "RSTP"), Own => False);
         end if;
      end loop;
      Soak_Records.Set_Calm (False);
      Own_Process.Prefer_Real_Time (False);
      Note_Images;
      Check (Monitor.Broken_Images = 0, "broken images");
      Monitor.Close;
   exception
      when Occurrence : Failed =>
         Soak_Records.Set_Calm (False);
         Own_Process.Prefer_Real_Time (False);
         if Is_Explained then
            --  such as a start spoilt by the robot's silence
            Late_Answers := Late_Answers + 1;
         else
            Complain
              ("in a calm session: "
               & Ada.Exceptions.Exception_Message (Occurrence));
         end if;
   end Stay_Calm;

   procedure Inject_Fault (Number : Positive; Repetition : Positive) is
      use type Trials.Outcome;
      Result : Trials.Result;
   begin
      Trials.Run
        (First      => Number,
         Second     => 0,
         Seed       => Seed,
         Repetition => Repetition,
         Outcome    => Result);
      if Result.Ends_As = Trials.Violated then
         Complain
           (Trials.Name (Number, 0) & ASCII.LF & To_String (Result.Account));
      end if;
   end Inject_Fault;

   procedure Warm_Up is
      --  Resources allocated with the first images, and the first of each
      --  size, are not counted as growth
   begin
      Stay_Calm (5.0);
      for Number of Eligible loop
         if Element (Number).Group = Camera then
            Inject_Fault (Number, Repetition => 1);
         end if;
      end loop;
   end Warm_Up;

   procedure Soak (Good : out Boolean) is
      Start      : Instant;
      Process    : int;
      Chosen     : Positive;
      Repetition : Positive := 2;
      --  1 is that of the warm-up
      Figures    : Boolean;
   begin
      Trials.Build;
      Process := Trials.Process;
      Warm_Up;
      Soak_Records.Begin_Recording (Process);
      Start := Now;
      while Now - Start < Duration (60 * Minutes)
        and then Trials.Process = Process
      loop
         Stay_Calm (Span (Source, 3.0, 8.0));
         exit when Now - Start >= Duration (60 * Minutes);
         Chosen := Eligible (Whole (Source, 1, Natural (Eligible.Length)));
         Soak_Records.Count_Fault (To_String (Element (Chosen).Name));
         Inject_Fault (Chosen, Repetition);
         Repetition := Repetition + 1;
      end loop;
      Soak_Records.End_Recording;

      Put_Line
        (Image (Minutes) & " minutes," & Soak_Records.Faults'Image
         & " faults of" & Natural (Eligible.Length)'Image & " kinds, seed"
         & Seed'Image
         & (if Late_Answers = 0 then ""
            else "; the emulated line was late, or the host had taken the"
              & " processors," & Late_Answers'Image & " times"));
      Soak_Records.Print_And_Judge (Figures);
      if Trials.Process /= Process then
         Complain ("it is no longer the same supervisor");
      end if;
      if Csv_Path /= "" then
         Soak_Records.Write_Csv (To_String (Csv_Path));
      end if;
      Good := Figures and then Violations = 0;
      Put_Line
        ((if Good then "in the end as in the beginning, "
          else "NOT in the end as in the beginning, ")
         & Image (Violations) & " violations");
      Trials.Finish;
   end Soak;

   Good : Boolean;

begin
   --  the supervisor may close a connection while something is sent
   Own_Process.Ignore_Broken_Pipes;
   Read_Command_Line;
   Put_Line ("seed" & Seed'Image);
   Flush;
   Start (Source, Seed, "soak");
   Choose_Faults;
   Standstills.Watch (Lines => True);
   Soak (Good);
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit (if Good then 0 else 1);
exception
   when Occurrence : others =>
      Programs.Give_Up (Occurrence);
end Destijl_Soak;
