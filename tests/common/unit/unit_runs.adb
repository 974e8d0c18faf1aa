--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a program of unit tests.

with Ada.Command_Line;      use Ada.Command_Line;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;
with Ada_Containers;

with AUnit.Reporter.Text;
with AUnit.Run;
with AUnit.Simple_Test_Cases;
with AUnit.Test_Results;
with AUnit.Test_Suites;

package body Unit_Runs is

   use type Ada_Containers.Count_Type;

   type Unit_Test (Action : Routine) is
     new AUnit.Simple_Test_Cases.Test_Case with record
      Title : AUnit.Message_String;
   end record;

   overriding function Name (Test : Unit_Test) return AUnit.Message_String is
     (Test.Title);

   overriding procedure Run_Test (Test : in out Unit_Test) is
   begin
      Test.Action.all;
   end Run_Test;

   type Unit_Test_Access is access Unit_Test;

   All_Tests : constant AUnit.Test_Suites.Access_Test_Suite :=
     AUnit.Test_Suites.New_Suite;

   Group_Now : Unbounded_String;

   Known : array (1 .. Argument_Count) of Boolean := (others => False);
   --  arguments that are the name of a group

   function Suite return AUnit.Test_Suites.Access_Test_Suite is (All_Tests);

   procedure Run_Suite is new AUnit.Run.Test_Runner_With_Results (Suite);

   procedure Add (Group : String; Add_Tests : Routine) is
      Wanted : Boolean := Argument_Count = 0;
   begin
      for Number in Known'Range loop
         if Argument (Number) = Group then
            Known (Number) := True;
            Wanted := True;
         end if;
      end loop;
      if Wanted then
         Group_Now := To_Unbounded_String (Group);
         Add_Tests.all;
      end if;
   end Add;

   procedure Add_Test (Name : String; Test : Routine) is
      Item : constant Unit_Test_Access := new Unit_Test'
        (AUnit.Simple_Test_Cases.Test_Case with
         Test, AUnit.Format (To_String (Group_Now) & " : " & Name));
   begin
      All_Tests.Add_Test (Item);
   end Add_Test;

   procedure Run is
      Reporter : AUnit.Reporter.Text.Text_Reporter;
      Results  : AUnit.Test_Results.Result;
   begin
      Set_Exit_Status (Failure);
      Run_Suite (Reporter, Results);
      Ada.Text_IO.Put_Line
        (Results.Success_Count'Image & " passed,"
         & Ada_Containers.Count_Type'Image
           (Results.Failure_Count + Results.Error_Count)
         & " failed");
      for Number in Known'Range loop
         if not Known (Number) then
            Ada.Text_IO.Put_Line
              (Ada.Text_IO.Standard_Error,
               "no tests are called " & Argument (Number));
         end if;
      end loop;
      if Results.Test_Count > 0 and then Results.Successful
        and then (for all Is_Known of Known => Is_Known)
      then
         Set_Exit_Status (Success);
      end if;
   end Run;

end Unit_Runs;
