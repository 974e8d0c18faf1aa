--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the vision, or those that the command line names.

with Ada.Command_Line; use Ada.Command_Line;

with AUnit.Test_Cases;

with Following_Tests;
with Vision_Arena_Tests;
with Vision_C_Tests;
with Vision_Jpeg_Tests;
with Vision_Robot_Tests;
with Vision_Source_Tests;
with Vision_Tests;

package body Vision_Suite is

   Followed : aliased Following_Tests.Test_Case;
   Jpeg     : aliased Vision_Jpeg_Tests.Test_Case;
   Wrapper  : aliased Vision_C_Tests.Test_Case;
   Arena    : aliased Vision_Arena_Tests.Test_Case;
   Robots   : aliased Vision_Robot_Tests.Test_Case;
   Sources  : aliased Vision_Source_Tests.Test_Case;
   Ada_Side : aliased Vision_Tests.Test_Case;

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;

      procedure Add (Tests : not null access AUnit.Test_Cases.Test_Case'Class);
      --  If its name, such as arena, is an argument, or none is

      procedure Add
        (Tests : not null access AUnit.Test_Cases.Test_Case'Class) is
      begin
         if Argument_Count = 0
           or else (for some Number in 1 .. Argument_Count =>
                      Argument (Number) = Tests.Name.all)
         then
            Result.Add_Test (Tests);
         end if;
      end Add;
   begin
      Add (Wrapper'Access);
      Add (Arena'Access);
      Add (Robots'Access);
      Add (Sources'Access);
      Add (Jpeg'Access);
      Add (Followed'Access);
      Add (Ada_Side'Access);
      return Result;
   end Suite;

end Vision_Suite;
