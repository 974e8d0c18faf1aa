--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the protected state: all, or those whose names
--  are its arguments.

with Event_Tests;
with Frames_Tests;
with Image_Grid_Tests;
with Journal_Tests;
with Missions_Requests_Tests;
with Outbox_Tests;
with Robot_Line_Tests;
with Serial_Line_Tests;
with Trace.Ring_Tests;
with Unit_Runs; use Unit_Runs;
with Vision_State_Tests;
with Vision_Turns_Tests;

procedure State_Unit_Tests is
begin
   Group ("Event", Event_Tests'Access);
   Group ("Vision.Frames", Frames_Tests'Access);
   Group ("Vision.Image_Grid", Image_Grid_Tests'Access);
   Group ("Journal", Journal_Tests'Access);
   Group ("Missions.Requests", Missions_Requests_Tests'Access);
   Group ("Monitor.Outbox", Outbox_Tests'Access);
   Group ("Robot.Line", Robot_Line_Tests'Access);
   Group ("Robot.Serial_Line", Serial_Line_Tests'Access);
   Group ("Trace.Ring", Trace.Ring_Tests'Access);
   Group ("Vision.State", Vision_State_Tests'Access);
   Group ("Vision.Turns", Vision_Turns_Tests'Access);
   Finish;
end State_Unit_Tests;
