--  SPDX-License-Identifier: GPL-3.0-or-later
--  The measurements of a soak test.

with Ada.Containers.Indefinite_Vectors;
with Ada.Containers.Vectors;
with Ada.Strings.Fixed;   use Ada.Strings.Fixed;
with Ada.Text_IO;         use Ada.Text_IO;
with System.Multiprocessors;

with Host_Time;
with Plain_Numbers;       use Plain_Numbers;
with Process_Facts;
with Samples;

package body Soak_Records is

   --  How much worse the last tenth may be than the first. A leak of a
   --  kilobyte per second adds 1600 between the middles of the two tenths of
   --  half an hour; the other margins are for a shared machine.
   Memory_Margin : constant Natural := 1024;  --  kilobytes, of the median
   Median_Factor : constant Float := 1.5;
   Median_Margin : constant Duration := 0.000_5;
   Tail_Factor   : constant Float := 1.5;
   Tail_Margin   : constant Duration := 0.002;
   Worst_Margin  : constant Duration := 0.010;
   Rate_Margin   : constant Float := 0.01;  --  of the images a second

   Most_Stolen   : constant Float := 1.0;
   --  Stolen percent of the processors in a judged second: two steps of 10 ms
   --  on two processors

   type Second is record
      Time        : Duration := 0.0;
      --  since the recording began
      Memory      : Natural := 0;
      Descriptors : Natural := 0;
      Threads     : Natural := 0;
      Calm        : Boolean := False;
      Faults      : Natural := 0;
      --  so far
      Stolen      : Float := 0.0;
      --  by the host of a virtual machine: percent of the processors
   end record;

   type Event is record
      Time  : Duration := 0.0;
      Value : Duration := 0.0;
   end record;

   package Second_Vectors is new Ada.Containers.Vectors (Positive, Second);
   package Event_Vectors is new Ada.Containers.Vectors (Positive, Event);
   package Name_Vectors is new Ada.Containers.Indefinite_Vectors
     (Positive, String);

   Start   : Instant := Never;
   Seconds : Second_Vectors.Vector;
   Answers : Event_Vectors.Vector;
   Images  : Event_Vectors.Vector;
   Names   : Name_Vectors.Vector;
   --  of faults

   protected State is
      procedure Set_Calm (Value : Boolean);
      procedure Count_Fault;
      procedure Take_Second (Was_Calm : out Boolean);
      function Faults return Natural;
   private
      Calm      : Boolean := False;
      Disturbed : Boolean := True;
      --  since the last second
      Count     : Natural := 0;
   end State;

   task Sampler is
      entry Start_With (Process : Interfaces.C.int);
      entry Stop;
   end Sampler;

   function Last_Time return Duration is
     (if Seconds.Is_Empty then 0.0 else Seconds.Last_Element.Time);

   function In_Ms (Value : Duration) return String is
     (Rounded (Float (Value) * 1000.0));

   protected body State is

      procedure Set_Calm (Value : Boolean) is
      begin
         Calm := Value;
         if not Value then
            Disturbed := True;
         end if;
      end Set_Calm;

      procedure Count_Fault is
      begin
         Count := Count + 1;
      end Count_Fault;

      procedure Take_Second (Was_Calm : out Boolean) is
      begin
         Was_Calm := Calm and then not Disturbed;
         Disturbed := not Calm;
      end Take_Second;

      function Faults return Natural is (Count);

   end State;

   task body Sampler is
      Processors : constant Positive :=
        Positive (System.Multiprocessors.Number_Of_CPUs);
      Taken      : Duration := 0.0;
      Now_Taken  : Duration;
      Watched : Interfaces.C.int := 0;
      Next    : Second;
      Calm    : Boolean;
      Stopped : Boolean := False;
   begin
      select
         accept Start_With (Process : Interfaces.C.int) do
            Watched := Process;
            Start := Now;
         end Start_With;
         Taken := Host_Time.Taken;
      or
         terminate;
      end select;
      while not Stopped loop
         select
            accept Stop do
               Stopped := True;
            end Stop;
         or
            delay 1.0 * (Natural (Seconds.Length) + 1) - (Now - Start);
            State.Take_Second (Calm);
            Next :=
              (Time        => Now - Start,
               Memory      => Process_Facts.Resident_Kilobytes (Watched),
               Descriptors => Process_Facts.Descriptors (Watched),
               Threads     => Process_Facts.Threads (Watched),
               Calm        => Calm,
               Faults      => State.Faults,
               Stolen      => 0.0);
            Now_Taken := Host_Time.Taken;
            Next.Stolen := 100.0 * Float (Now_Taken - Taken)
              / Float (Processors);
            Taken := Now_Taken;
            Seconds.Append (Next);
         end select;
      end loop;
   end Sampler;

   procedure Begin_Recording (Process : Interfaces.C.int) is
   begin
      Sampler.Start_With (Process);
   end Begin_Recording;

   procedure End_Recording is
   begin
      Sampler.Stop;
   end End_Recording;

   procedure Set_Calm (Value : Boolean) is
   begin
      State.Set_Calm (Value);
   end Set_Calm;

   procedure Count_Fault (Name : String) is
   begin
      Names.Append (Name);
      State.Count_Fault;
   end Count_Fault;

   procedure Add_Answer (Time : Instant; Latency : Duration) is
   begin
      if Start /= Never then
         Answers.Append ((Time - Start, Latency));
      end if;
   end Add_Answer;

   procedure Add_Image (Time : Instant; Interval : Duration) is
   begin
      if Start /= Never then
         Images.Append ((Time - Start, Interval));
      end if;
   end Add_Image;

   function Faults return Natural is (State.Faults);

   function Is_Quiet (Time : Duration) return Boolean is
      --  The host stole little time in the second of Time and in the one
      --  before, whose work may have been delayed to this one
      Number : constant Positive := 1 + Natural (Float'Floor (Float (Time)));
   begin
      return
        (for all Near in Positive'Max (1, Number - 1)
           .. Natural'Min (Number, Natural (Seconds.Length)) =>
           Seconds (Near).Stolen <= Most_Stolen);
   end Is_Quiet;

   function Between
     (From : Event_Vectors.Vector; First, Last : Duration;
      Only_Quiet : Boolean := False) return Samples.Set
   is
      Result : Samples.Set;
   begin
      for Item of From loop
         if Item.Time >= First and then Item.Time < Last
           and then (not Only_Quiet or else Is_Quiet (Item.Time))
         then
            Result.Add (Item.Value);
         end if;
      end loop;
      return Result;
   end Between;

   function Rate (Intervals : Samples.Set) return Float is
      --  A second
      Mean : constant Float := Float (Intervals.Mean);
   begin
      return (if Mean > 0.0 then 1.0 / Mean else 0.0);
   end Rate;

   procedure Print_And_Judge (Good : out Boolean) is
      Tenth : constant Duration := Last_Time / 10;

      type Figures is record
         Calm, Taken : Natural := 0;
         --  seconds, and how many of them the host disturbed
         Answers     : Natural := 0;
         Median, Tail, Rarest, Worst : Duration := 0.0;
         Memory      : Natural := 0;
         Descriptors : Natural := 0;
         Threads     : Natural := 0;
         --  medians of the calm seconds
         Images      : Natural := 0;
         Rate        : Float := 0.0;
      end record;

      function Figures_Of (First, Last : Duration) return Figures is
         Result      : Figures;
         Latencies   : constant Samples.Set :=
           Between (Answers, First, Last, Only_Quiet => True);
         Intervals   : constant Samples.Set :=
           Between (Images, First, Last, Only_Quiet => True);
         Memory, Descriptors, Threads : Samples.Set;
      begin
         for Item of Seconds loop
            if Item.Calm and then Item.Time >= First and then Item.Time < Last
            then
               Result.Calm := Result.Calm + 1;
               if not Is_Quiet (Item.Time - 0.5) then
                  Result.Taken := Result.Taken + 1;
               end if;
               Memory.Add (Duration (Item.Memory));
               Descriptors.Add (Duration (Item.Descriptors));
               Threads.Add (Duration (Item.Threads));
            end if;
         end loop;
         Result.Memory := Natural (Memory.Quantile (0.5));
         Result.Descriptors := Natural (Descriptors.Quantile (0.5));
         Result.Threads := Natural (Threads.Quantile (0.5));
         Result.Answers := Latencies.Count;
         Result.Median := Latencies.Quantile (0.5);
         Result.Tail := Latencies.Quantile (0.99);
         Result.Rarest := Latencies.Quantile (0.999);
         Result.Worst := Latencies.Quantile (1.0);
         Result.Images := Intervals.Count;
         Result.Rate := Rate (Intervals);
         return Result;
      end Figures_Of;

      A : constant Figures := Figures_Of (0.0, Tenth);
      Z : constant Figures := Figures_Of (Last_Time - Tenth, Duration'Last);

      procedure Line (Name, First, Last, Limit : String; Met : Boolean) is
      begin
         Put_Line
           ("| " & Head (Name, 24) & " | " & Tail (First, 9) & " | "
            & Tail (Last, 9) & " | " & Head (Limit, 26) & " | "
            & (if Met then "yes" else "NO ") & " |");
         Good := Good and then Met;
      end Line;

      Median_Limit : constant Duration :=
        Duration (Median_Factor * Float (A.Median)) + Median_Margin;
      Tail_Limit   : constant Duration :=
        Duration (Tail_Factor * Float (A.Tail)) + Tail_Margin;
      Rarest_Limit : constant Duration :=
        Duration (Tail_Factor * Float (A.Rarest)) + Tail_Margin;
      Worst_Limit  : constant Duration :=
        Duration (Tail_Factor * Float (A.Worst)) + Worst_Margin;

   begin
      Good := True;
      Put_Line
        ("| " & Head ("", 24) & " | 1st tenth |last tenth | "
         & Head ("limit", 26) & " | met |");
      Put_Line ("|---|---|---|---|---|");
      Line ("calm seconds", Image (A.Calm), Image (Z.Calm), "> 0",
            A.Calm > 0 and then Z.Calm > 0);
      Line ("not judged: the host's", Image (A.Taken), Image (Z.Taken),
            "not all", A.Taken < A.Calm and then Z.Taken < Z.Calm);
      Line ("answers", Image (A.Answers), Image (Z.Answers), "> 0",
            A.Answers > 0 and then Z.Answers > 0);
      Line ("answer, median, ms", In_Ms (A.Median), In_Ms (Z.Median),
            "<= " & In_Ms (Median_Limit) & " (x 1.5 + 0.5)",
            Z.Median <= Median_Limit);
      Line ("answer, p99, ms", In_Ms (A.Tail), In_Ms (Z.Tail),
            "<= " & In_Ms (Tail_Limit) & " (x 1.5 + 2)",
            Z.Tail <= Tail_Limit);
      Line ("answer, p99.9, ms", In_Ms (A.Rarest), In_Ms (Z.Rarest),
            "<= " & In_Ms (Rarest_Limit) & " (x 1.5 + 2)",
            Z.Rarest <= Rarest_Limit);
      Line ("answer, maximum, ms", In_Ms (A.Worst), In_Ms (Z.Worst),
            "<= " & In_Ms (Worst_Limit) & " (x 1.5 + 10)",
            Z.Worst <= Worst_Limit);
      Line ("memory, kB", Image (A.Memory), Image (Z.Memory),
            "<= " & Image (A.Memory + Memory_Margin) & " (+ 1024)",
            Z.Memory <= A.Memory + Memory_Margin);
      Line ("descriptors", Image (A.Descriptors), Image (Z.Descriptors),
            "the same", Z.Descriptors = A.Descriptors);
      Line ("threads", Image (A.Threads), Image (Z.Threads),
            "the same", Z.Threads = A.Threads);
      Line ("images a second", Rounded (A.Rate), Rounded (Z.Rate),
            "within 1 %",
            A.Rate > 0.0
            and then abs (Z.Rate - A.Rate) <= Rate_Margin * A.Rate);
   end Print_And_Judge;

   procedure Write_Csv (Path : String) is
      File   : File_Type;
      Before : Natural := 0;
      --  faults
   begin
      Create (File, Out_File, Path);
      Put_Line
        (File,
         "second,calm,faults,stolen_percent,memory_kb,descriptors,threads,"
         & "images,answers,median_ms,p99_ms,maximum_ms,fault_begun");
      for Item of Seconds loop
         declare
            Latencies : constant Samples.Set :=
              Between (Answers, Item.Time - 1.0, Item.Time);
            Frames    : constant Natural :=
              Between (Images, Item.Time - 1.0, Item.Time).Count;
         begin
            Put_Line
              (File,
               Image (Natural (Item.Time)) & ","
               & (if Item.Calm then "1" else "0") & ","
               & Image (Item.Faults) & "," & Rounded (Item.Stolen) & ","
               & Image (Item.Memory) & ","
               & Image (Item.Descriptors) & "," & Image (Item.Threads) & ","
               & Image (Frames) & "," & Image (Latencies.Count)
               & ","
               & (if Latencies.Count = 0 then ",,"
                  else In_Ms (Latencies.Quantile (0.5)) & ","
                    & In_Ms (Latencies.Quantile (0.99)) & ","
                    & In_Ms (Latencies.Quantile (1.0)))
               & ","
               & (if Item.Faults > Before
                  then '"' & Names (Item.Faults) & '"' else ""));
            Before := Item.Faults;
         end;
      end loop;
      Close (File);
   end Write_Csv;

end Soak_Records;
