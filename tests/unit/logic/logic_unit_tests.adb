--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the pure packages: all, or those whose names
--  are its arguments.

with Authentication_Tests;
with Base64_Tests;
with Command_Lines_Tests;
with Commands_Tests;
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
with Processor_Sets_Tests;
with Robot_Protocol_Tests;
with Robot_Session_Tests;
with Send_Order_Tests;
with Session_Stages_Tests;
with Tcp_Infos_Tests;
with Texts_Tests;
with Vision_Mode_Tests;
with Unit_Runs; use Unit_Runs;

procedure Logic_Unit_Tests is
begin
   Add ("Admission.Authentication", Authentication_Tests.Add_Tests'Access);
   Add ("Base64", Base64_Tests.Add_Tests'Access);
   Add ("Command_Lines", Command_Lines_Tests.Add_Tests'Access);
   Add ("Commands", Commands_Tests.Add_Tests'Access);
   Add ("Decimals", Decimals_Tests.Add_Tests'Access);
   Add ("Admission.Networks", Networks_Tests.Add_Tests'Access);
   Add ("Vision.Image_Cycle", Image_Cycle_Tests.Add_Tests'Access);
   Add ("Vision.Image_Grid", Image_Grid_Tests.Add_Tests'Access);
   Add ("Processor_Sets", Processor_Sets_Tests.Add_Tests'Access);
   Add ("Robot.Protocol", Robot_Protocol_Tests.Add_Tests'Access);
   Add ("Monitor.Protocol", Monitor_Protocol_Tests.Add_Tests'Access);
   Add ("Robot.Health", Line_Health_Tests.Add_Tests'Access);
   Add ("Monitor.Mailboxes", Mailboxes_Tests.Add_Tests'Access);
   Add ("Missions.Paths", Missions_Paths_Tests.Add_Tests'Access);
   Add ("Missions.Texts", Missions_Texts_Tests.Add_Tests'Access);
   Add ("Missions.Arenas", Mission_Arenas_Tests.Add_Tests'Access);
   Add ("Missions.Grounds", Mission_Grounds_Tests.Add_Tests'Access);
   Add ("Missions.Runs", Mission_Runs_Tests.Add_Tests'Access);
   Add ("Monitor.Link", Monitor_Link_Tests.Add_Tests'Access);
   Add ("Robot.Session", Robot_Session_Tests.Add_Tests'Access);
   Add ("Monitor.Send_Order", Send_Order_Tests.Add_Tests'Access);
   Add ("Monitor.Session_Stages", Session_Stages_Tests.Add_Tests'Access);
   Add ("Monitor.Tcp_Infos", Tcp_Infos_Tests.Add_Tests'Access);
   Add ("Texts", Texts_Tests.Add_Tests'Access);
   Add ("Vision.Mode", Vision_Mode_Tests.Add_Tests'Access);
   Run;
end Logic_Unit_Tests;
