--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the emulator's core, and of what judges missions by
--  it: all, or those whose names are its arguments.

with Answer_Faults_Tests;
with Mission_Judges_Tests;
with Robot_Core_Tests;
with Robot_Motion_Tests;
with Robot_Pasts_Tests;
with Unit_Runs;

procedure Emulator_Unit is
begin
   Unit_Runs.Add (new Robot_Core_Tests.Test_Case);
   Unit_Runs.Add (new Robot_Motion_Tests.Test_Case);
   Unit_Runs.Add (new Robot_Pasts_Tests.Test_Case);
   Unit_Runs.Add (new Answer_Faults_Tests.Test_Case);
   Unit_Runs.Add (new Mission_Judges_Tests.Test_Case);
   Unit_Runs.Run;
end Emulator_Unit;
