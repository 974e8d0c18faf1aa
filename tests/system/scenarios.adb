--  SPDX-License-Identifier: GPL-3.0-or-later
--  System tests, each in a process of its own.

with Ada.Command_Line;
with Ada.Containers.Vectors;
with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;
with Interfaces.C;          use type Interfaces.C.int;
with System.Multiprocessors;

with Child_Processes;       use Child_Processes;
with Expectations;
with Instants;              use Instants;
with Libc;
with Network_Links;
with Option_Readers;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Samples;
with Supervisors;

package body Scenarios is

   --  How the process of a test ends

   Passed_Status  : constant := 0;
   Failed_Status  : constant := 1;
   Skipped_Status : constant := 77;

   Skipping  : constant String := "   skipped: ";
   Failing   : constant String := "   FAILED: ";
   Repeating : constant String := "   one of three: ";

   Timed_Name : constant String := "_In_Time";

   Longest_Test : constant Duration := 300.0;
   --  Some last a minute

   Jobs : Positive :=
     (if Own_Process.Real_Time_Allowed then 3 else 2)
     * Positive (System.Multiprocessors.Number_Of_CPUs);
   --  Most tests wait most of the time, but what waits without priority is
   --  disturbed by the others

   Known      : Arguments;
   Together   : Arguments;
   Apart      : Arguments;
   --  Names of all tests, and of those to run
   Filters    : Arguments;
   Only_Timed : Boolean := False;
   The_One    : Unbounded_String;

   procedure Say (Line : String) is
   begin
      Put_Line (Line);
      Flush;
   exception
      when Device_Error =>
         --  as in system_tests | head: no test could tell its result
         Programs.Give_Up ("nobody reads what the tests have to say");
   end Say;

   procedure Read_Options is
   begin
      while Option_Readers.Next loop
         if Programs.Read_Option then
            null;
         elsif Option_Readers.Name = "--timed" then
            Only_Timed := True;
         elsif Option_Readers.Name = "--jobs" then
            Jobs := Option_Readers.Number (1, 64);
         elsif Option_Readers.Name = "--one" then
            The_One := To_Unbounded_String (Option_Readers.Value);
         elsif Index (Option_Readers.Name, "-") = 1 then
            Option_Readers.Refuse;
         else
            Filters.Append (Option_Readers.Name);
         end if;
      end loop;
   end Read_Options;

   function Is_Named (Name, Text : String) return Boolean is
     (Index (Name, Text) > 0
      and then (Only_Timed or else Index (Text, Timed_Name) > 0
                or else Index (Name, Timed_Name) = 0));

   function Is_Selected (Name : String; Timed : Boolean) return Boolean is
     (if Filters.Is_Empty then Timed = Only_Timed
      else (Timed or else not Only_Timed)
        and then (for some Text of Filters => Is_Named (Name, Text)));

   procedure Measure_Floor is
      --  By how much this process wakes up too late
      Late : Samples.Set;
      Due  : Instant;
   begin
      for Number in 1 .. 50 loop
         Due := Now + 0.001;
         delay 0.001;
         Late.Add (Now - Due);
      end loop;
      Expectations.Own_Time := Late.Quantile (0.99);
   end Measure_Floor;

   procedure Run_Timed (Action : not null access procedure) is
      --  Passes if two of three runs do, and none fails but by its time
      Passed : Natural := 0;
      Failed : Natural := 0;
   begin
      Libc.Nice (-10);
      --  if it is root's, it and the programs it starts go first
      while Passed < 2 loop
         begin
            Measure_Floor;
            Action.all;
            Passed := Passed + 1;
         exception
            when Occurrence : Expectations.Too_Late =>
               Failed := Failed + 1;
               if Failed = 2 then
                  raise;
               end if;
               Say (Repeating & Exception_Message (Occurrence));
         end;
      end loop;
   end Run_Timed;

   procedure Run_One (Action : not null access procedure; Timed : Boolean) is
      Status : Integer := Failed_Status;
   begin
      begin
         if Timed then
            Run_Timed (Action);
         else
            Supervisors.Patient := True;
            Expectations.Ignore_Times := True;
            Action.all;
         end if;
         Say ("   ok");
         Status := Passed_Status;
      exception
         when Occurrence : Expectations.Skipped =>
            Say (Skipping & Exception_Message (Occurrence));
            Status := Skipped_Status;
         when Occurrence : others =>
            Say (Failing
                 & (if Exception_Identity (Occurrence)
                      in Expectations.Failed'Identity
                       | Expectations.Too_Late'Identity
                    then Exception_Message (Occurrence)
                    else Exception_Information (Occurrence)));
            Print_Last_Lines;
      end;
      Programs.Remove_Temporary_Folder;
      GNAT.OS_Lib.OS_Exit (Status);
   end Run_One;

   procedure Add
     (Name           : String;
      Run            : not null access procedure;
      Timed, In_Time : Boolean := False) is
   begin
      if Name = The_One then
         Run_One (Run, Timed);
      end if;
      Known.Append (Name);
      if not Is_Selected (Name, Timed) then
         null;
      elsif Timed then
         Apart.Append (Name);
      else
         Together.Append (Name);
      end if;
      if In_Time then
         Add (Name & Timed_Name, Run, Timed => True);
      end if;
   end Add;

   procedure Script
     (Name               : String;
      Steps              : String   := "";
      Run                : access procedure (R : in out Rig) := null;
      Emulator_Options   : String   := "";
      Supervisor_Options : String   := "";
      Launcher           : String   := "";
      Camera             : Boolean  := False;
      Connected          : Boolean  := True;
      Terminal           : Boolean  := False;
      Times              : Positive := 1;
      Each               : String   := "";
      Timed, In_Time     : Boolean  := False)
   is

      procedure Assemble_And_Run is
         R : Rig;
      begin
         Assemble (R, Camera, Emulator_Options, Supervisor_Options, Launcher,
                   Connected => Connected, Terminal => Terminal);
         Play (R, Steps, Times, Each);
         if Run /= null then
            Run (R);
         end if;
      end Assemble_And_Run;

   begin
      Add (Name, Assemble_And_Run'Access, Timed, In_Time);
   end Script;

   --  The run of all

   type Duration_Of_Test is record
      Title : Unbounded_String;
      Taken : Duration;
   end record;

   function Longer (Left, Right : Duration_Of_Test) return Boolean is
     (Left.Taken > Right.Taken);

   package Duration_Vectors is
     new Ada.Containers.Vectors (Positive, Duration_Of_Test);
   package Sorting is new Duration_Vectors.Generic_Sorting (Longer);

   procedure Run (All_Passed : out Boolean) is

      type Job is limited record
         Process : Child;
         Busy    : Boolean := False;
         Since   : Instant := Never;
         Title   : Unbounded_String;
      end record;

      All_Jobs                : array (1 .. Jobs) of Job;
      Durations               : Duration_Vectors.Vector;
      Passed, Failed, Skipped : Natural := 0;
      Failures, Repeats       : Unbounded_String;

      procedure Start (J : in out Job; From : in out Arguments) is
         Options : Arguments;
      begin
         for Number in 1 .. Ada.Command_Line.Argument_Count loop
            Options.Append (Ada.Command_Line.Argument (Number));
         end loop;
         J.Title := To_Unbounded_String (From.First_Element);
         Options.Append ("--one");
         Options.Append (From.First_Element);
         J.Process.Launch (Programs.Beside ("system_tests"), Options,
                           Name => From.First_Element);
         From.Delete_First;
         J.Since := Now;
         J.Busy := True;
      end Start;

      procedure Finish (J : in out Job) is
         Taken  : constant Duration := Now - J.Since;
         Title  : constant String := To_String (J.Title);
         Hangs  : constant Boolean := J.Process.Is_Running;
         Result : Integer := Failed_Status;
         Reason : Unbounded_String;
      begin
         J.Busy := False;
         if Hangs then
            J.Process.Stop;
            Network_Links.Remove_Left (J.Process.Pid);
            Programs.Remove_Left (J.Process.Pid);
         else
            Result := J.Process.Exit_Status;
         end if;
         Durations.Append ((J.Title, Taken));
         Say (Title & ", " & Milliseconds (Taken));
         for From in Stream loop
            for Number in 1 .. J.Process.Count (From) loop
               declare
                  Text : constant String :=
                    To_String (J.Process.Element (From, Number).Text);
               begin
                  Say (Text);
                  if Index (Text, Repeating) = 1 then
                     Append (Repeats,
                             "REPEATED " & Title & ": "
                             & Text (Repeating'Length + 1 .. Text'Last)
                             & ASCII.LF);
                  end if;
                  for Word of Words (Skipping & "|" & Failing, '|') loop
                     if Index (Text, Word) = 1 then
                        Reason := To_Unbounded_String
                          (Text (Word'Length + 1 .. Text'Last));
                     end if;
                  end loop;
               end;
            end loop;
         end loop;
         if Hangs then
            Reason := To_Unbounded_String ("it has not ended");
            Say (Failing & To_String (Reason));
         end if;
         if Result = Passed_Status then
            Passed := Passed + 1;
         elsif Result = Skipped_Status then
            Skipped := Skipped + 1;
            Say ("SKIPPED " & Title & ": " & To_String (Reason));
         else
            Failed := Failed + 1;
            Append (Failures,
                    "FAILED " & Title & ": " & Reason & ASCII.LF);
         end if;
      end Finish;

      function Is_Busy return Boolean is
        (for some J of All_Jobs => J.Busy);

   begin
      if The_One /= "" then
         Programs.Give_Up ("no test is called " & To_String (The_One));
      end if;
      for Text of Filters loop
         if not (for some Name of Known => Is_Named (Name, Text)) then
            Programs.Give_Up ("no test has " & Text & " in its name");
         end if;
      end loop;

      loop
         for J of All_Jobs loop
            if J.Busy
              and then (not J.Process.Is_Running
                        or else Now - J.Since > Longest_Test)
            then
               Finish (J);
            end if;
            if not J.Busy then
               if not Together.Is_Empty then
                  Start (J, Together);
               elsif not Is_Busy and then not Apart.Is_Empty then
                  Start (J, Apart);
               end if;
            end if;
         end loop;
         exit when not Is_Busy;
         delay 0.01;
      end loop;

      Sorting.Sort (Durations);
      for Number in 1 .. Integer'Min (10, Durations.Last_Index) loop
         --  as pytest has it
         Say (Rounded (Float (Durations (Number).Taken)) & "s call  "
              & To_String (Durations (Number).Title));
      end loop;
      Put (To_String (Repeats & Failures));
      Say (Image (Skipped) & " skipped");
      Say (Image (Passed) & " passed, " & Image (Failed) & " failed");
      All_Passed := Failed = 0 and then Passed > 0;
   end Run;

end Scenarios;
