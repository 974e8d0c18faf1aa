--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the pure packages.

with Authentication_Tests;
with Base64_Tests;
with Blocklists_Tests;
with Command_Lines_Tests;
with Decimals_Tests;
with Image_Grid_Tests;
with Line_Health_Tests;
with Monitor_Link_Tests;
with Monitor_Protocol_Tests;
with Networks_Tests;
with Pending_Connections_Tests;
with Robot_Protocol_Tests;
with Robot_Session_Tests;
with Send_Order_Tests;
with Texts_Tests;
with Trace_Json_Tests;
with Vision_Mode_Tests;

package body Logic_Suite is

   Token    : aliased Authentication_Tests.Test_Case;
   Base_64  : aliased Base64_Tests.Test_Case;
   Block    : aliased Blocklists_Tests.Test_Case;
   Command  : aliased Command_Lines_Tests.Test_Case;
   Decimal  : aliased Decimals_Tests.Test_Case;
   Network  : aliased Networks_Tests.Test_Case;
   Grid     : aliased Image_Grid_Tests.Test_Case;
   Pending  : aliased Pending_Connections_Tests.Test_Case;
   Robot    : aliased Robot_Protocol_Tests.Test_Case;
   Monitor  : aliased Monitor_Protocol_Tests.Test_Case;
   Health   : aliased Line_Health_Tests.Test_Case;
   Link     : aliased Monitor_Link_Tests.Test_Case;
   Session  : aliased Robot_Session_Tests.Test_Case;
   Sending  : aliased Send_Order_Tests.Test_Case;
   Bounded  : aliased Texts_Tests.Test_Case;
   Traced   : aliased Trace_Json_Tests.Test_Case;
   Mode     : aliased Vision_Mode_Tests.Test_Case;

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Result.Add_Test (Token'Access);
      Result.Add_Test (Base_64'Access);
      Result.Add_Test (Block'Access);
      Result.Add_Test (Command'Access);
      Result.Add_Test (Decimal'Access);
      Result.Add_Test (Network'Access);
      Result.Add_Test (Grid'Access);
      Result.Add_Test (Pending'Access);
      Result.Add_Test (Robot'Access);
      Result.Add_Test (Monitor'Access);
      Result.Add_Test (Health'Access);
      Result.Add_Test (Link'Access);
      Result.Add_Test (Session'Access);
      Result.Add_Test (Sending'Access);
      Result.Add_Test (Bounded'Access);
      Result.Add_Test (Traced'Access);
      Result.Add_Test (Mode'Access);
      return Result;
   end Suite;

end Logic_Suite;
