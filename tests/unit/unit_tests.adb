--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of what needs no OpenCV: all, or those whose names are
--  its arguments.

with Admission_Tests;
with Answer_Faults_Tests;
with Base64_Tests;
with Command_Lines_Tests;
with Event_Tests;
with Frames_Tests;
with Image_Grid_Tests;
with Journal_Tests;
with Mailboxes_Tests;
with Mission_Arenas_Tests;
with Mission_Grounds_Tests;
with Mission_Judges_Tests;
with Mission_Runs_Tests;
with Missions_Requests_Tests;
with Monitor_Link_Tests;
with Monitor_Protocol_Tests;
with Networks_Tests;
with Outbox_Tests;
with Radio_Links_Tests;
with Reload_Times_Tests;
with Response_Times_Tests;
with Robot_Core_Tests;
with Robot_Line_Tests;
with Robot_Motion_Tests;
with Robot_Pasts_Tests;
with Robot_Protocol_Tests;
with Robot_Session_Tests;
with Serial_Line_Tests;
with Supervisor_Model_Tests;
with Texts_Tests;
with Trace.Ring_Tests;
with Unit_Runs; use Unit_Runs;
with Vision_State_Tests;
with Vision_Turns_Tests;

procedure Unit_Tests is
begin
   --  What decides
   Group ("Admission", Admission_Tests'Access);
   Group ("Base64", Base64_Tests'Access);
   Group ("Command_Lines", Command_Lines_Tests'Access);
   Group ("Networks", Networks_Tests'Access);
   Group ("Robot.Protocol", Robot_Protocol_Tests'Access);
   Group ("Monitor.Protocol", Monitor_Protocol_Tests'Access);
   Group ("Monitor.Mailboxes", Mailboxes_Tests'Access);
   Group ("Missions.Arenas", Mission_Arenas_Tests'Access);
   Group ("Missions.Grounds", Mission_Grounds_Tests'Access);
   Group ("Missions.Runs", Mission_Runs_Tests'Access);
   Group ("Monitor.Link", Monitor_Link_Tests'Access);
   Group ("Robot.Session", Robot_Session_Tests'Access);
   Group ("Texts", Texts_Tests'Access);

   --  What tasks share
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

   --  The emulator's core, and what judges missions by it
   Group ("Robot_Core", Robot_Core_Tests'Access);
   Group ("Robot_Motion", Robot_Motion_Tests'Access);
   Group ("Robot_Pasts", Robot_Pasts_Tests'Access);
   Group ("Answer_Faults", Answer_Faults_Tests'Access);
   Group ("Radio_Links", Radio_Links_Tests'Access);
   Group ("Reload_Times", Reload_Times_Tests'Access);
   Group ("Mission_Judges", Mission_Judges_Tests'Access);

   --  The response-time analysis
   Group ("Response_Times", Response_Times_Tests'Access);
   Group ("Supervisor_Model", Supervisor_Model_Tests'Access);
   Finish;
end Unit_Tests;
