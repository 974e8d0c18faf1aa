--  SPDX-License-Identifier: GPL-3.0-or-later
--  System tests as AUnit test cases.

with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with AUnit.Assertions;

with Child_Processes;
with Expectations;
with Instants;              use Instants;
with Programs;

package body Scenarios is

   type Scenario_Access is access Scenario;

   Filter        : Unbounded_String;
   Count_Run     : Natural := 0;
   Count_Failed  : Natural := 0;
   Count_Skipped : Natural := 0;

   ----------
   -- Name --
   ----------

   overriding function Name
     (Test : Scenario) return AUnit.Message_String
   is (AUnit.Format (Test.Title.all));

   --------------
   -- Run_Test --
   --------------

   overriding procedure Run_Test (Test : in out Scenario) is
      Start : constant Instant := Now;

      procedure Say (Line : String);

      procedure Report (Result : String);

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

   begin
      Count_Run := Count_Run + 1;
      Child_Processes.Forget_Last_Lines;
      Say (Test.Title.all);
      Test.Action.all;
      Report ("   ok");
   exception
      when Occurrence : Expectations.Skipped =>
         Count_Skipped := Count_Skipped + 1;
         Report ("   skipped: " & Exception_Message (Occurrence));
      when Occurrence : others =>
         Count_Failed := Count_Failed + 1;
         Report ("   FAILED: " & Exception_Message (Occurrence));
         Child_Processes.Print_Last_Lines;
         if Exception_Identity (Occurrence) = Expectations.Failed'Identity
         then
            AUnit.Assertions.Assert
              (False, Exception_Message (Occurrence));
         else
            raise;
         end if;
   end Run_Test;

   ----------------
   -- Set_Filter --
   ----------------

   procedure Set_Filter (Text : String) is
   begin
      Filter := To_Unbounded_String (Text);
   end Set_Filter;

   ---------
   -- Add --
   ---------

   procedure Add
     (Suite : AUnit.Test_Suites.Access_Test_Suite;
      Name  : String;
      Run   : not null Routine)
   is
      Test : Scenario_Access;
   begin
      if Filter = "" or else Index (Name, To_String (Filter)) > 0 then
         Test := new Scenario;
         Test.Title := new String'(Name);
         Test.Action := Run;
         Suite.Add_Test (Test);
      end if;
   end Add;

   function Run_Count return Natural is (Count_Run);
   function Failed_Count return Natural is (Count_Failed);
   function Skipped_Count return Natural is (Count_Skipped);

end Scenarios;
