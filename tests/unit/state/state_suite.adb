--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the protected state.

with Frame_Store_Tests;
with Journal_Tests;
with Order_Ports_Tests;
with Outbox_Tests;
with Robot_Line_Tests;
with Trace_Rings_Tests;
with Vision_Queue_Tests;

package body State_Suite is

   Frames : aliased Frame_Store_Tests.Test_Case;
   Log    : aliased Journal_Tests.Test_Case;
   Ports  : aliased Order_Ports_Tests.Test_Case;
   Box    : aliased Outbox_Tests.Test_Case;
   Line   : aliased Robot_Line_Tests.Test_Case;
   Rings  : aliased Trace_Rings_Tests.Test_Case;
   Turns  : aliased Vision_Queue_Tests.Test_Case;

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Result.Add_Test (Frames'Access);
      Result.Add_Test (Log'Access);
      Result.Add_Test (Ports'Access);
      Result.Add_Test (Box'Access);
      Result.Add_Test (Line'Access);
      Result.Add_Test (Rings'Access);
      Result.Add_Test (Turns'Access);
      return Result;
   end Suite;

end State_Suite;
