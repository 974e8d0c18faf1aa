--  SPDX-License-Identifier: GPL-3.0-or-later
--  System tests, each in a process of its own.

with Ada.Command_Line;
with Ada.Containers.Vectors;
with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with AUnit.Assertions;
with AUnit.Options;
with AUnit.Test_Results;
with AUnit.Test_Suites;
with GNAT.OS_Lib;

with Child_Processes;       use Child_Processes;
with Expectations;
with Instants;              use Instants;
with Network_Links;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Standstills;

package body Scenarios is

   type Scenario_Access is access Scenario;

   package Scenario_Vectors is
     new Ada.Containers.Vectors (Positive, Scenario_Access);

   --  How the process of a test ends

   Passed_Status  : constant := 0;
   Failed_Status  : constant := 1;
   Late_Status    : constant := 4;
   Skipped_Status : constant := 77;

   Skipping : constant String := "   skipped: ";

   Longest_Test  : constant Duration := 240.0;
   --  Some last a minute
   Most_Attempts : constant := 3;

   Known    : Scenario_Vectors.Vector;
   Filters  : Arguments;
   Inverted : Boolean := False;
   Status   : Integer := Failed_Status;

   overriding function Name
     (Test : Scenario) return AUnit.Message_String
   is (AUnit.Format (Test.Title.all));

   procedure Say (Line : String) is
   begin
      Put_Line (Line);
      Flush;
   exception
      when Device_Error =>
         --  as in system_tests | head: no test could tell its result
         Programs.Give_Up ("nobody reads what the tests have to say");
   end Say;

   overriding procedure Run_Test (Test : in out Scenario) is
   begin
      Expectations.Limit_Time (Longest_Test);
      Standstills.Watch (Real_Time => False);
      Test.Action.all;
      Status := Passed_Status;
      Say ("   ok");
   exception
      when Occurrence : Expectations.Skipped =>
         Status := Skipped_Status;
         Say (Skipping & Exception_Message (Occurrence));
      when Occurrence : others =>
         Say ("   FAILED: " & Exception_Message (Occurrence));
         Child_Processes.Print_Last_Lines;
         if Exception_Identity (Occurrence) /= Expectations.Failed'Identity
         then
            raise;
         end if;
         if Expectations.Time_Ran_Out
           and then not Child_Processes.Any_Has_Failed
           and then (Child_Processes.Any_Was_Late
                     or else Standstills.Longest >= Standstills.Too_Long)
         then
            Status := Late_Status;
            Say ("      late meanwhile: a processor by "
                 & Milliseconds (Standstills.Longest)
                 & (if Child_Processes.Any_Was_Late
                    then ", its own line" else ""));
         end if;
         AUnit.Assertions.Assert (False, Exception_Message (Occurrence));
   end Run_Test;

   procedure Add_Filter (Text : String) is
   begin
      Filters.Append (Text);
   end Add_Filter;

   procedure Invert_Filters is
   begin
      Inverted := True;
   end Invert_Filters;

   procedure Add
     (Name : String; Run : not null Routine; Alone : Boolean := False)
   is
      Test : constant Scenario_Access := new Scenario;
   begin
      Test.Title := new String'(Name);
      Test.Action := Run;
      Test.Alone := Alone;
      Known.Append (Test);
   end Add;

   procedure Run_One (Title : String) is
      Suite   : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
      Result  : AUnit.Test_Results.Result;
      Outcome : AUnit.Status;
   begin
      for Test of Known loop
         if Test.Title.all = Title then
            Suite.Add_Test (Test);
         end if;
      end loop;
      AUnit.Test_Suites.Run
        (Suite, AUnit.Options.Default_Options, Result, Outcome);
      Programs.Remove_Temporary_Folder;
      GNAT.OS_Lib.OS_Exit (Status);
   end Run_One;

   --  The run of all

   type Attempt is record
      Test   : Positive;
      Number : Positive := 1;
   end record;

   package Attempt_Vectors is new Ada.Containers.Vectors (Positive, Attempt);

   type Duration_Of_Test is record
      Test  : Positive;
      Taken : Duration;
   end record;

   function Longer (Left, Right : Duration_Of_Test) return Boolean is
     (Left.Taken > Right.Taken);

   package Duration_Vectors is
     new Ada.Containers.Vectors (Positive, Duration_Of_Test);
   package Sorting is new Duration_Vectors.Generic_Sorting (Longer);

   procedure Run (Jobs : Positive; Program : String; All_Passed : out Boolean)
   is

      type Job is limited record
         Process : Child;
         Busy    : Boolean := False;
         Since   : Instant := Never;
         What    : Attempt;
      end record;

      All_Jobs : array (1 .. Jobs) of Job;
      Together, Apart : Attempt_Vectors.Vector;
      Durations       : Duration_Vectors.Vector;
      Passed, Failed, Skipped, Repeated : Natural := 0;
      Failures                          : Unbounded_String;

      function Title (What : Attempt) return String is
        (Known (What.Test).Title.all);

      procedure Start (J : in out Job; From : in out Attempt_Vectors.Vector) is
         Options : Arguments;
      begin
         for Number in 1 .. Ada.Command_Line.Argument_Count loop
            Options.Append (Ada.Command_Line.Argument (Number));
         end loop;
         J.What := From.First_Element;
         From.Delete_First;
         Options.Append ("--one");
         Options.Append (Title (J.What));
         J.Process.Start (Program, Options, Title (J.What));
         J.Since := Now;
         J.Busy := True;
      end Start;

      procedure Finish (J : in out Job) is
         Taken  : constant Duration := Now - J.Since;
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
            Result := J.Process.Exit_Status (Within => 1.0);
         end if;
         Durations.Append ((J.What.Test, Taken));
         Say (Title (J.What) & ", " & Milliseconds (Taken));
         for From in Stream loop
            for Number in 1 .. J.Process.Count (From) loop
               declare
                  Text : constant String :=
                    To_String (J.Process.Element (From, Number).Text);
               begin
                  Say (Text);
                  if Index (Text, Skipping) = 1 then
                     Reason := To_Unbounded_String
                       (Text (Skipping'Length + 1 .. Text'Last));
                  end if;
               end;
            end loop;
         end loop;
         if Hangs then
            Say ("   FAILED: it has not ended");
         end if;
         if Result = Late_Status and then J.What.Number < Most_Attempts then
            Repeated := Repeated + 1;
            Say ("REPEATED " & Title (J.What)
                 & ": a limit of time missed, line or processor late");
            Apart.Append ((J.What.Test, J.What.Number + 1));
         elsif Result = Passed_Status then
            Passed := Passed + 1;
         elsif Result = Skipped_Status then
            Skipped := Skipped + 1;
            Say ("SKIPPED " & Title (J.What) & ": " & To_String (Reason));
         else
            Failed := Failed + 1;
            Append (Failures, ASCII.LF & "   " & Title (J.What));
         end if;
      end Finish;

      function Is_Busy return Boolean is
        (for some J of All_Jobs => J.Busy);

   begin
      for Text of Filters loop
         if not (for some Test of Known => Index (Test.Title.all, Text) > 0)
         then
            Programs.Give_Up ("no test has " & Text & " in its name");
         end if;
      end loop;
      for Test in 1 .. Known.Last_Index loop
         if Filters.Is_Empty
           or else (for some Text of Filters =>
                      Index (Known (Test).Title.all, Text) > 0) /= Inverted
         then
            if Known (Test).Alone then
               Apart.Append ((Test, 1));
            else
               Together.Append ((Test, 1));
            end if;
         end if;
      end loop;

      loop
         for J of All_Jobs loop
            if J.Busy
              and then (not J.Process.Is_Running
                        or else Now - J.Since > Longest_Test + 10.0)
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
              & Known (Durations (Number).Test).Title.all);
      end loop;
      if Failed > 0 then
         Say ("failed:" & To_String (Failures));
      end if;
      Say (Image (Skipped) & " skipped, " & Image (Repeated) & " repeated");
      Say (Image (Passed) & " passed, " & Image (Failed) & " failed");
      All_Passed := Failed = 0 and then Passed > 0;
   end Run;

end Scenarios;
