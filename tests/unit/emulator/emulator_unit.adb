--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the emulator's core, and of what judges missions by
--  it: all, or those whose names are its arguments.

with Answer_Faults_Tests;
with Mission_Judges_Tests;
with Radio_Links_Tests;
with Reload_Times_Tests;
with Robot_Core_Tests;
with Robot_Motion_Tests;
with Robot_Pasts_Tests;
with Unit_Runs; use Unit_Runs;

procedure Emulator_Unit is
begin
   Add ("Robot_Core", Robot_Core_Tests.Add_Tests'Access);
   Add ("Robot_Motion", Robot_Motion_Tests.Add_Tests'Access);
   Add ("Robot_Pasts", Robot_Pasts_Tests.Add_Tests'Access);
   Add ("Answer_Faults", Answer_Faults_Tests.Add_Tests'Access);
   Add ("Radio_Links", Radio_Links_Tests.Add_Tests'Access);
   Add ("Reload_Times", Reload_Times_Tests.Add_Tests'Access);
   Add ("Mission_Judges", Mission_Judges_Tests.Add_Tests'Access);
   Run;
end Emulator_Unit;
