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
   Group ("Robot_Core", Robot_Core_Tests'Access);
   Group ("Robot_Motion", Robot_Motion_Tests'Access);
   Group ("Robot_Pasts", Robot_Pasts_Tests'Access);
   Group ("Answer_Faults", Answer_Faults_Tests'Access);
   Group ("Radio_Links", Radio_Links_Tests'Access);
   Group ("Reload_Times", Reload_Times_Tests'Access);
   Group ("Mission_Judges", Mission_Judges_Tests'Access);
   Finish;
end Emulator_Unit;
