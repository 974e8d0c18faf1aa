--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of what judges the faults: all, or those whose names
--  are its arguments.

with Answer_Ledgers_Tests;
with Unit_Runs;

procedure Faults_Unit is
begin
   Unit_Runs.Add (new Answer_Ledgers_Tests.Test_Case);
   Unit_Runs.Run;
end Faults_Unit;
