--  SPDX-License-Identifier: GPL-3.0-or-later
--  A run: the injections, and the processes that perform them.

with Ada.Containers.Vectors;
with Ada.Strings;         use Ada.Strings;
with Ada.Strings.Fixed;   use Ada.Strings.Fixed;
with Ada.Text_IO;         use Ada.Text_IO;
with GNAT.OS_Lib;

with Child_Processes;     use Child_Processes;
with Fault_Records;
with Fault_Tables;
with Faults;              use Faults;
with Instants;            use Instants;
with Network_Links;
with Programs;
with Random_Numbers;
with Standstills;
with Trials;              use Trials;

package body Fault_Runs is

   Injection_Limit : constant Duration := 600.0;
   --  A process not finished by then hangs: that is a violation

   Long : constant Duration := 4.0;
   --  Injections this long are started first, after the heavy ones

   type Injection is record
      First      : Positive := 1;
      Second     : Natural := 0;
      Repetition : Positive := 1;
   end record;

   package Injection_Vectors is new Ada.Containers.Vectors
     (Positive, Injection);

   function Cost (Item : Injection) return Duration is
     (Element (Item.First).Cost
      + (if Item.Second = 0 then 0.0 else Element (Item.Second).Cost));

   Most_Heavy : constant := 2;

   function Is_Heavy (Item : Injection) return Boolean is
     (Element (Item.First).Heavy
      or else (Item.Second > 0 and then Element (Item.Second).Heavy));

   function Key (Item : Injection) return String is
     (Name (Item.First, Item.Second) & "," & Item.Repetition'Image);
   --  In the record of a run

   function Goes_Before (Left, Right : Injection) return Boolean;

   package Sorting is new Injection_Vectors.Generic_Sorting (Goes_Before);

   function Is_Wanted (S : Scope; Item : Injection) return Boolean is
     ((S.Only = Null_Unbounded_String
       or else Index
         (Name (Item.First, Item.Second), To_String (S.Only)) > 0)
      and then (S.At_Repetition = 0
                or else S.At_Repetition = Item.Repetition));

   type Counts is array (Positive range <>) of Natural;

   function Worlds_Key (Item : Injection) return String is
      --  Injections with the same key share a world
      P : Plan;
   begin
      Element (Item.First).Prepare (P);
      if Item.Second > 0 then
         Element (Item.Second).Prepare (P);
      end if;
      return To_String
        (P.Launcher & P.Program & P.Options & P.Emulator_Options & P.Camera)
        & P.Through_Link'Image & P.Fresh'Image & P.Receive_Buffer'Image
        & P.Log_Is_Read'Image & P.Terminal'Image;
   end Worlds_Key;

   function Goes_Before (Left, Right : Injection) return Boolean is
      Left_Cost  : constant Duration := Cost (Left);
      Right_Cost : constant Duration := Cost (Right);
   begin
      if Is_Heavy (Left) /= Is_Heavy (Right) then
         return Is_Heavy (Left);
      elsif Left_Cost >= Long or else Right_Cost >= Long then
         return Left_Cost > Right_Cost;
      else
         return Worlds_Key (Left) < Worlds_Key (Right);
      end if;
   end Goes_Before;

   procedure Draw_Pair
     (Source        : in out Random_Numbers.Generator;
      Fault         : Positive;
      Used          : Counts;
      Limit         : Positive;
      First, Second : out Natural)
   is
      --  Fault and a second one, if possible in fewer pairs than Limit; 0 if
      --  it can be combined with none
      Attempts : constant := 2_000;
      Fair     : constant := 1_000;
      --  so long the other one must be short of pairs, too
      Other    : Positive;
   begin
      for Attempt in 1 .. Attempts loop
         Other := Random_Numbers.Whole (Source, 1, Faults.Count);
         if Attempt > Fair or else Used (Other) < Limit then
            First := Fault;
            Second := Other;
            if Random_Numbers.Chance (Source, 2) then
               First := Other;
               Second := Fault;
            end if;
            if Go_Together (Element (First).all, Element (Second).all) then
               return;
            end if;
         end if;
      end loop;
      First := 0;
      Second := 0;
   end Draw_Pair;

   procedure Add_Pairs
     (Queue : in out Injection_Vectors.Vector; S : Scope)
   is
      First, Second : Natural;
      Number        : Natural := 0;
      Used          : Counts (1 .. Faults.Count) := (others => 0);
      Source        : Random_Numbers.Generator;
   begin
      Random_Numbers.Start (Source, S.Seed, "pairs");
      --  round by round: the first are the same, however many there are
      for Round in 1 .. S.Pairs loop
         for Fault in Used'Range loop
            if Used (Fault) < Round and then not Element (Fault).Alone then
               Draw_Pair (Source, Fault, Used, Round, First, Second);
               if First > 0 then
                  Used (First) := Used (First) + 1;
                  Used (Second) := Used (Second) + 1;
                  Number := Number + 1;
                  if Is_Wanted (S, (First, Second, Number)) then
                     Queue.Append ((First, Second, Number));
                  end if;
               end if;
            end if;
         end loop;
      end loop;
   end Add_Pairs;

   procedure Run
     (S        : Scope;
      Jobs     : Positive;
      Program  : String;
      Figures  : out Figure_Set)
   is

      type Job is limited record
         Process : Child;
         Busy    : Boolean := False;
         Item    : Injection;
         Since   : Instant := Never;
         Seen    : Natural := 0;
         --  lines of its output
      end record;

      All_Jobs : array (1 .. Jobs) of Job;
      Queue    : Injection_Vectors.Vector;
      Left     : Natural;
      Done     : Natural := 0;
      Shown    : Instant := Now;

      procedure Begin_Job (J : in out Job) is
         Options : Arguments;
      begin
         Options.Append ("--supervisor");
         Options.Append (Programs.Supervisor);
         Options.Append ("--emulator");
         Options.Append (Programs.Emulator);
         Options.Append ("--work");
         Options.Append (Trim (S.Seed'Image, Both));
         J.Process.Start (Program, Options, "job");
         J.Seen := 0;
      end Begin_Job;

      procedure Give (J : in out Job) is
         --  The next injection, if there is one for it
         Heavy : Natural := 0;
         --  under way
      begin
         for Other of All_Jobs loop
            if Other.Busy and then Is_Heavy (Other.Item) then
               Heavy := Heavy + 1;
            end if;
         end loop;
         for Number in 1 .. Queue.Last_Index loop
            if Heavy < Most_Heavy or else not Is_Heavy (Queue (Number)) then
               J.Item := Queue (Number);
               Queue.Delete (Number);
               J.Busy := True;
               J.Since := Now;
               J.Process.Put_Line
                 (J.Item.First'Image & J.Item.Second'Image
                  & J.Item.Repetition'Image);
               return;
            end if;
         end loop;
      end Give;

      procedure Report (J : Job; Text : String) is
         --  A violation, and how to repeat it
      begin
         Put_Line ("VIOLATION: " & Name (J.Item.First, J.Item.Second));
         Put (Text);
         Put_Line
           ("   again: --seed" & S.Seed'Image & " --only """
            & Name (J.Item.First, J.Item.Second) & """ --at"
            & J.Item.Repetition'Image);
         Flush;
      end Report;

      procedure Count (Item : Injection; Result : String) is
         --  Result: as a job prints it
         Parts : constant Arguments := Words (Result);
         Word  : constant String := Parts.Element (1);
      begin
         Figures := Worst
           (Figures,
            (Repeated     => Natural'Value (Parts.Element (2)),
             Interrupted  => Natural'Value (Parts.Element (3)),
             Stops        => Natural'Value (Parts.Element (4)),
             Late_Stops   => Natural'Value (Parts.Element (5)),
             Slowest_Stop => Duration'Value (Parts.Element (6)),
             Growth       => Natural'Value (Parts.Element (7))));
         if Word = "impossible" then
            Fault_Tables.Count_Impossible (Item.First, Item.Second);
         else
            Fault_Tables.Count (Item.First, Item.Second, Word = "violated");
         end if;
      end Count;

      procedure Finish_One (J : in out Job; Result, Text : String) is
         Word : constant String := Words (Result).Element (1);
      begin
         J.Busy := False;
         Left := Left - 1;
         Done := Done + 1;
         Count (J.Item, Result);
         Fault_Records.Write (Key (J.Item), Result);
         if Word = "impossible" then
            if J.Item.Second = 0 and then J.Item.Repetition = 1 then
               Put_Line
                 (Name (J.Item.First, 0) & " is not possible here:");
               Put ("   " & Text);
            end if;
         elsif Word = "violated" then
            Report (J, Text);
         elsif Text /= "" then
            Put_Line
              ("held: " & Name (J.Item.First, J.Item.Second));
            Put (Text);
            Flush;
         end if;
      end Finish_One;

      procedure Look (J : in out Job) is
         --  Takes what it says
         Word : constant Natural := J.Seen + 1;
         Last : Natural;
         Text : Unbounded_String;
      begin
         if not J.Busy then
            return;
         end if;
         Last := J.Process.Awaited (Output, "--- end", 0.0, J.Seen);
         if Last > 0 then
            for Number in Word + 1 .. Last - 1 loop
               Append
                 (Text, J.Process.Element (Output, Number).Text & ASCII.LF);
            end loop;
            J.Seen := Last;
            Finish_One
              (J, To_String (J.Process.Element (Output, Word).Text),
               To_String (Text));
         elsif not J.Process.Is_Running
           or else Now - J.Since > Injection_Limit
         then
            for Number in Word .. J.Process.Count (Output) loop
               Append
                 (Text, J.Process.Element (Output, Number).Text & ASCII.LF);
            end loop;
            for Number in Integer'Max (1, J.Process.Count (Errors) - 9)
              .. J.Process.Count (Errors)
            loop
               Append
                 (Text, "   | "
                  & J.Process.Element (Errors, Number).Text & ASCII.LF);
            end loop;
            Finish_One
              (J, "violated 0 0 0 0 0.0 0",
               "   it has not come to an end" & ASCII.LF
               & To_String (Text));
            J.Process.Stop;
            Network_Links.Remove_Left (J.Process.Pid);
            Programs.Remove_Left (J.Process.Pid);
            Begin_Job (J);
         end if;
      end Look;

   begin
      Figures := (others => <>);
      for Number in 1 .. Faults.Count loop
         for Repetition in 1 .. S.Times loop
            if Is_Wanted (S, (Number, 0, Repetition)) then
               Queue.Append ((Number, 0, Repetition));
            end if;
         end loop;
      end loop;
      Add_Pairs (Queue, S);
      Sorting.Sort (Queue);
      if S.Record_File /= "" then
         Fault_Records.Open (To_String (S.Record_File), S.Seed);
         for Number in reverse 1 .. Queue.Last_Index loop
            declare
               Result : constant String :=
                 Fault_Records.Result_Of (Key (Queue (Number)));
            begin
               if Result /= "" then
                  Count (Queue (Number), Result);
                  Queue.Delete (Number);
                  Done := Done + 1;
               end if;
            end;
         end loop;
      end if;
      Left := Natural (Queue.Length);

      for J of All_Jobs loop
         Begin_Job (J);
         Give (J);
      end loop;

      while Left > 0 loop
         for J of All_Jobs loop
            Look (J);
            if not J.Busy then
               Give (J);
            end if;
         end loop;
         if Now - Shown > 60.0 then
            Shown := Now;
            Put_Line
              (Trim (Done'Image, Both) & " of"
               & Natural'Image (Done + Left) & " injections,"
               & Fault_Tables.Violations'Image & " violations so far");
            Flush;
         end if;
         delay 0.01;
      end loop;

      for J of All_Jobs loop
         if J.Process.Is_Running then
            J.Process.Close_Input;
         end if;
      end loop;
      for J of All_Jobs loop
         for Attempt in 1 .. 1_000 loop
            exit when not J.Process.Is_Running;
            delay 0.01;
         end loop;
         J.Process.Stop;
      end loop;
   end Run;

   procedure Work (Seed : Natural) is
      Outcome : Result;
   begin
      Standstills.Watch (Lines => True);
      while not End_Of_File loop
         declare
            Parts : constant Arguments := Words (Get_Line);
         begin
            Trials.Run
              (First      => Positive'Value (Parts.Element (1)),
               Second     => Natural'Value (Parts.Element (2)),
               Seed       => Seed,
               Repetition => Positive'Value (Parts.Element (3)),
               Outcome    => Outcome);
            Put_Line
              ((case Outcome.Ends_As is
                   when Held            => "held",
                   when Violated        => "violated",
                   when Impossible_Here => "impossible")
               & Outcome.Figures.Repeated'Image
               & Outcome.Figures.Interrupted'Image
               & Outcome.Figures.Stops'Image
               & Outcome.Figures.Late_Stops'Image
               & Outcome.Figures.Slowest_Stop'Image
               & Outcome.Figures.Growth'Image);
            Put (To_String (Outcome.Account));
            if Outcome.Ends_As = Impossible_Here then
               New_Line;
            end if;
            Put_Line ("--- end");
            Flush;
         end;
      end loop;
      Trials.Finish;
      Programs.Remove_Temporary_Folder;
      GNAT.OS_Lib.OS_Exit (0);
   end Work;

end Fault_Runs;
