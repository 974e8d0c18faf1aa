--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the protected state.

with Outbox_Tests;
with Robot_Line_Tests;

package body State_Suite is

   Box  : aliased Outbox_Tests.Test_Case;
   Line : aliased Robot_Line_Tests.Test_Case;

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Result.Add_Test (Box'Access);
      Result.Add_Test (Line'Access);
      return Result;
   end Suite;

end State_Suite;
