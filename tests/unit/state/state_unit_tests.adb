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
with Trace.Ring_Tests;
with Unit_Runs; use Unit_Runs;
with Vision_Queue_Tests;
with Vision_Sightings_Tests;

procedure State_Unit_Tests is
begin
   Add ("Event", Event_Tests.Add_Tests'Access);
   Add ("Vision.Frame_Store", Frame_Store_Tests.Add_Tests'Access);
   Add ("Journal", Journal_Tests.Add_Tests'Access);
   Add ("Missions.Requests", Missions_Requests_Tests.Add_Tests'Access);
   Add ("Order_Ports", Order_Ports_Tests.Add_Tests'Access);
   Add ("Monitor.Outbox", Outbox_Tests.Add_Tests'Access);
   Add ("Robot.Line", Robot_Line_Tests.Add_Tests'Access);
   Add ("Robot.Serial_Line", Serial_Line_Tests.Add_Tests'Access);
   Add ("Trace.Ring", Trace.Ring_Tests.Add_Tests'Access);
   Add ("Vision.Queue", Vision_Queue_Tests.Add_Tests'Access);
   Add ("Vision.Sightings", Vision_Sightings_Tests.Add_Tests'Access);
   Run;
end State_Unit_Tests;
