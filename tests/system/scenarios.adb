--  SPDX-License-Identifier: GPL-3.0-or-later
--  System tests as AUnit test cases.

with Ada.Containers.Indefinite_Vectors;
with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with AUnit.Assertions;

with Child_Processes;
with Expectations;
with Host_Time;
with Instants;              use Instants;
with Programs;
with Standstills;

package body Scenarios is

   package Text_Vectors is
     new Ada.Containers.Indefinite_Vectors (Positive, String);

   type Scenario_Access is access Scenario;

   Longest_Test    : constant Duration := 240.0;
   --  some last a minute
   Most_Attempts   : constant := 12;
   Most_Not_Judged : constant := 8;

   Time_Left      : Duration := 1_800.0;
   --  for what is run again, and for waiting before
   Filters        : Text_Vectors.Vector;
   Inverted       : Boolean := False;
   Not_Judged     : Unbounded_String;
   Count_Unjudged : Natural := 0;
   Count_Run      : Natural := 0;
   Count_Failed   : Natural := 0;
   Count_Skipped  : Natural := 0;
   Count_Repeated : Natural := 0;

   overriding function Name
     (Test : Scenario) return AUnit.Message_String
   is (AUnit.Format (Test.Title.all));

   overriding procedure Run_Test (Test : in out Scenario) is
      Start       : Instant := Now;
      Host_Before : Duration := Host_Time.Taken;

      procedure Say (Line : String);
      procedure Report (Result : String);

      function Stood_Still return String;
      --  How, since Start; empty if too little to matter

      procedure Say (Line : String) is
      begin
         Put_Line (Line);
         Flush;
      exception
         when Device_Error =>
            --  as in system_tests | head: no test could tell its result
            Programs.Give_Up ("nobody reads what the tests have to say");
      end Say;

      procedure Report (Result : String) is
      begin
         Say (Result & ", " & Milliseconds (Now - Start));
      end Report;

      function Stood_Still return String is
         In_One_Piece : constant Duration := Standstills.Longest;
         Of_A_Byte    : constant Duration := Standstills.Longest_Line;
         Of_Host      : constant Duration := Host_Time.Taken - Host_Before;
      begin
         return
           (if In_One_Piece >= Standstills.Too_Long
              or else Of_A_Byte >= Standstills.Too_Long
              or else Of_Host >= Standstills.Too_Much
            then "stood still for " & Milliseconds (In_One_Piece)
                 & ", a byte of a pseudo-terminal for "
                 & Milliseconds (Of_A_Byte)
                 & ", its host took " & Milliseconds (Of_Host)
            else "");
      end Stood_Still;

   begin
      Count_Run := Count_Run + 1;
      Say (Test.Title.all);
      for Attempt in 1 .. Most_Attempts loop
         Child_Processes.Forget_Last_Lines;
         Expectations.Limit_Time (Longest_Test);
         Start := Now;
         Standstills.Forget;
         Host_Before := Host_Time.Taken;
         begin
            Test.Action.all;
            Report ("   ok");
            return;
         exception
            when Occurrence : Expectations.Skipped =>
               Count_Skipped := Count_Skipped + 1;
               Report ("   skipped: " & Exception_Message (Occurrence));
               return;
            when Occurrence : others =>
               declare
                  Cause   : constant String := Stood_Still;
                  Excused : constant Boolean :=
                    Cause /= "" and then not Child_Processes.Any_Has_Failed;
                  Again   : constant Boolean :=
                    Excused and then Attempt < Most_Attempts
                    and then Time_Left > 0.0;
                  Open    : constant Boolean :=
                    Excused and then not Again
                    and then Count_Unjudged < Most_Not_Judged;
               begin
                  Report ((if Again then "   again: "
                           elsif Open then "   not judged: "
                           else "   FAILED: ")
                          & Exception_Message (Occurrence));
                  if Cause /= "" then
                     Say ("      the machine " & Cause);
                  end if;
                  Child_Processes.Print_Last_Lines;
                  if Again then
                     Count_Repeated := Count_Repeated + 1;
                     Standstills.Await_Calm
                       (Limit => Duration'Min (Time_Left, 10.0 * Attempt));
                     Time_Left := Time_Left - (Now - Start);
                  elsif Open then
                     Count_Unjudged := Count_Unjudged + 1;
                     Append (Not_Judged, " " & Test.Title.all);
                     return;
                  else
                     Count_Failed := Count_Failed + 1;
                     if Exception_Identity (Occurrence)
                       = Expectations.Failed'Identity
                     then
                        AUnit.Assertions.Assert
                          (False, Exception_Message (Occurrence));
                     end if;
                     raise;
                  end if;
               end;
         end;
      end loop;
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
     (Suite : AUnit.Test_Suites.Access_Test_Suite;
      Name  : String;
      Run   : not null Routine)
   is
      Test : Scenario_Access;
   begin
      if Filters.Is_Empty
        or else (for some Text of Filters => Index (Name, Text) > 0)
                /= Inverted
      then
         Test := new Scenario;
         Test.Title := new String'(Name);
         Test.Action := Run;
         Suite.Add_Test (Test);
      end if;
   end Add;

   function Run_Count return Natural is (Count_Run);
   function Failed_Count return Natural is (Count_Failed);
   function Skipped_Count return Natural is (Count_Skipped);
   function Not_Judged_Count return Natural is (Count_Unjudged);
   function Not_Judged_Names return String is (To_String (Not_Judged));
   function Repeated_Count return Natural is (Count_Repeated);

end Scenarios;
