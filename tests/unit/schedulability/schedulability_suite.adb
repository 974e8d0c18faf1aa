--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the response-time analysis.

with Response_Times_Tests;
with Supervisor_Model_Tests;

package body Schedulability_Suite is

   Published : aliased Response_Times_Tests.Test_Case;
   Model     : aliased Supervisor_Model_Tests.Test_Case;

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Result.Add_Test (Published'Access);
      Result.Add_Test (Model'Access);
      return Result;
   end Suite;

end Schedulability_Suite;
