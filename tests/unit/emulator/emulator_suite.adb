--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the emulator's core.

with Answer_Faults_Tests;
with Robot_Core_Tests;
with Robot_Motion_Tests;

package body Emulator_Suite is

   Core   : aliased Robot_Core_Tests.Test_Case;
   Motion : aliased Robot_Motion_Tests.Test_Case;
   Faults : aliased Answer_Faults_Tests.Test_Case;

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Result.Add_Test (Core'Access);
      Result.Add_Test (Motion'Access);
      Result.Add_Test (Faults'Access);
      return Result;
   end Suite;

end Emulator_Suite;
