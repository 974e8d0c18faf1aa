--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the pure packages: all, or those whose names
--  are its arguments.

with Admission_Tests;
with Base64_Tests;
with Command_Lines_Tests;
with Mailboxes_Tests;
with Mission_Arenas_Tests;
with Mission_Grounds_Tests;
with Mission_Runs_Tests;
with Monitor_Link_Tests;
with Monitor_Protocol_Tests;
with Networks_Tests;
with Robot_Protocol_Tests;
with Robot_Session_Tests;
with Texts_Tests;
with Unit_Runs; use Unit_Runs;

procedure Logic_Unit_Tests is
begin
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
   Finish;
end Logic_Unit_Tests;
