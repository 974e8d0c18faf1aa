--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a program of unit tests.

with Ada.Command_Line;      use Ada.Command_Line;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;
with Ada_Containers;        use type Ada_Containers.Count_Type;

with AUnit.Options;
with AUnit.Reporter.Text;
with AUnit.Simple_Test_Cases;
with AUnit.Test_Results;

package body Unit_Runs is

   Results   : AUnit.Test_Results.Result;
   Group_Now : Unbounded_String;

   Known : array (1 .. Argument_Count) of Boolean := (others => False);
   --  arguments that are the name of a group

   procedure Group (Name : String; Tests : not null access procedure) is
      Wanted : Boolean := Argument_Count = 0;
   begin
      for Number in Known'Range loop
         if Argument (Number) = Name then
            Known (Number) := True;
            Wanted := True;
         end if;
      end loop;
      if Wanted then
         Group_Now := To_Unbounded_String (Name);
         Tests.all;
      end if;
   end Group;

   procedure Run_Test (Title : String; Action : not null access procedure) is

      type Unit_Test is
        new AUnit.Simple_Test_Cases.Test_Case with null record;

      overriding function Name (Item : Unit_Test)
        return AUnit.Message_String
      is (AUnit.Format (To_String (Group_Now) & " : " & Title));

      overriding procedure Run_Test (Item : in out Unit_Test);

      overriding procedure Run_Test (Item : in out Unit_Test) is
         pragma Unreferenced (Item);
      begin
         Action.all;
      end Run_Test;

      Item   : aliased Unit_Test;
      Unused : AUnit.Status;
   begin
      Run (Item'Unchecked_Access, AUnit.Options.Default_Options, Results,
           Unused);
   end Run_Test;

   function Split
     (Table : String; Bar : Character := '|') return Line_Vectors.Vector
   is
      First  : Positive := Table'First;
      Result : Line_Vectors.Vector;
   begin
      for Place in Table'Range loop
         if Table (Place) = Bar then
            Result.Append (Table (First .. Place - 1));
            First := Place + 1;
         end if;
      end loop;
      Result.Append (Table (First .. Table'Last));
      return Result;
   end Split;

   procedure Run_Scripts
     (Play : not null access procedure (Script : String); Table : String) is
   begin
      for Row of Split (Table) loop
         declare
            Colon : constant Positive := Index (Row, ": ");

            procedure Play_Row is
            begin
               Play (Row (Colon + 2 .. Row'Last));
            end Play_Row;
         begin
            Run_Test (Row (Row'First .. Colon - 1), Play_Row'Access);
         end;
      end loop;
   end Run_Scripts;

   procedure Finish is
      Reporter : AUnit.Reporter.Text.Text_Reporter;
   begin
      Reporter.Report (Results, AUnit.Options.Default_Options);
      Ada.Text_IO.Put_Line (Results.Success_Count'Image & " passed,"
                            & Ada_Containers.Count_Type'Image
                              (Results.Failure_Count + Results.Error_Count)
                            & " failed");
      for Number in Known'Range loop
         if not Known (Number) then
            Ada.Text_IO.Put_Line (Ada.Text_IO.Standard_Error,
                                  "no tests are called " & Argument (Number));
         end if;
      end loop;
      Set_Exit_Status (if Results.Test_Count > 0 and then Results.Successful
                         and then (for all Is_Known of Known => Is_Known)
                       then Success else Failure);
   end Finish;

end Unit_Runs;
