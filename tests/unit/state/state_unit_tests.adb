--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the protected state: all, or those whose names
--  are its arguments.

with Event_Tests;
with Frame_Store_Tests;
with Journal_Tests;
with Missions_Requests_Tests;
with Order_Ports_Tests;
with Outbox_Tests;
with Robot_Line_Tests;
with Serial_Line_Tests;
with Trace.Rings_Tests;
with Unit_Runs;
with Vision_Queue_Tests;
with Vision_Sightings_Tests;

procedure State_Unit_Tests is
begin
   Unit_Runs.Add (new Event_Tests.Test_Case);
   Unit_Runs.Add (new Frame_Store_Tests.Test_Case);
   Unit_Runs.Add (new Journal_Tests.Test_Case);
   Unit_Runs.Add (new Missions_Requests_Tests.Test_Case);
   Unit_Runs.Add (new Order_Ports_Tests.Test_Case);
   Unit_Runs.Add (new Outbox_Tests.Test_Case);
   Unit_Runs.Add (new Robot_Line_Tests.Test_Case);
   Unit_Runs.Add (new Serial_Line_Tests.Test_Case);
   Unit_Runs.Add (new Trace.Rings_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Queue_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Sightings_Tests.Test_Case);
   Unit_Runs.Run;
end State_Unit_Tests;
