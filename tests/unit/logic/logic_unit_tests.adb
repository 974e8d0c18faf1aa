--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the pure packages: all, or those whose names
--  are its arguments.

with Authentication_Tests;
with Base64_Tests;
with Blocklists_Tests;
with Command_Lines_Tests;
with Decimals_Tests;
with Image_Cycle_Tests;
with Image_Grid_Tests;
with Line_Health_Tests;
with Mailboxes_Tests;
with Mission_Arenas_Tests;
with Mission_Grounds_Tests;
with Mission_Runs_Tests;
with Missions_Paths_Tests;
with Missions_Texts_Tests;
with Monitor_Link_Tests;
with Monitor_Protocol_Tests;
with Networks_Tests;
with Order_Meanings_Tests;
with Packet_Filters_Tests;
with Pending_Connections_Tests;
with Processor_Sets_Tests;
with Robot_Protocol_Tests;
with Robot_Session_Tests;
with Send_Order_Tests;
with Session_Stages_Tests;
with Socket_Addresses_Tests;
with Tcp_Infos_Tests;
with Texts_Tests;
with Trace_Json_Tests;
with Trace_Layout_Tests;
with Vision_Mode_Tests;
with Unit_Runs;

procedure Logic_Unit_Tests is
begin
   Unit_Runs.Add (new Authentication_Tests.Test_Case);
   Unit_Runs.Add (new Base64_Tests.Test_Case);
   Unit_Runs.Add (new Blocklists_Tests.Test_Case);
   Unit_Runs.Add (new Command_Lines_Tests.Test_Case);
   Unit_Runs.Add (new Decimals_Tests.Test_Case);
   Unit_Runs.Add (new Networks_Tests.Test_Case);
   Unit_Runs.Add (new Image_Cycle_Tests.Test_Case);
   Unit_Runs.Add (new Image_Grid_Tests.Test_Case);
   Unit_Runs.Add (new Packet_Filters_Tests.Test_Case);
   Unit_Runs.Add (new Pending_Connections_Tests.Test_Case);
   Unit_Runs.Add (new Processor_Sets_Tests.Test_Case);
   Unit_Runs.Add (new Robot_Protocol_Tests.Test_Case);
   Unit_Runs.Add (new Monitor_Protocol_Tests.Test_Case);
   Unit_Runs.Add (new Line_Health_Tests.Test_Case);
   Unit_Runs.Add (new Mailboxes_Tests.Test_Case);
   Unit_Runs.Add (new Missions_Paths_Tests.Test_Case);
   Unit_Runs.Add (new Missions_Texts_Tests.Test_Case);
   Unit_Runs.Add (new Order_Meanings_Tests.Test_Case);
   Unit_Runs.Add (new Mission_Arenas_Tests.Test_Case);
   Unit_Runs.Add (new Mission_Grounds_Tests.Test_Case);
   Unit_Runs.Add (new Mission_Runs_Tests.Test_Case);
   Unit_Runs.Add (new Monitor_Link_Tests.Test_Case);
   Unit_Runs.Add (new Robot_Session_Tests.Test_Case);
   Unit_Runs.Add (new Send_Order_Tests.Test_Case);
   Unit_Runs.Add (new Session_Stages_Tests.Test_Case);
   Unit_Runs.Add (new Socket_Addresses_Tests.Test_Case);
   Unit_Runs.Add (new Tcp_Infos_Tests.Test_Case);
   Unit_Runs.Add (new Texts_Tests.Test_Case);
   Unit_Runs.Add (new Trace_Json_Tests.Test_Case);
   Unit_Runs.Add (new Trace_Layout_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Mode_Tests.Test_Case);
   Unit_Runs.Run;
end Logic_Unit_Tests;
