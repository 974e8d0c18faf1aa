--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the vision.

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
   begin
      Result.Add_Test (Wrapper'Access);
      Result.Add_Test (Arena'Access);
      Result.Add_Test (Robots'Access);
      Result.Add_Test (Sources'Access);
      Result.Add_Test (Jpeg'Access);
      Result.Add_Test (Followed'Access);
      Result.Add_Test (Ada_Side'Access);
      return Result;
   end Suite;

end Vision_Suite;
