--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of what judges the faults.

with Answer_Ledgers_Tests;

package body Faults_Suite is

   Ledgers : aliased Answer_Ledgers_Tests.Test_Case;

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Result.Add_Test (Ledgers'Access);
      return Result;
   end Suite;

end Faults_Suite;
