--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of what judges the faults: all, or those whose names
--  are its arguments.

with Answer_Ledgers_Tests;
with Unit_Runs; use Unit_Runs;

procedure Faults_Unit is
begin
   Add ("Answer_Ledgers", Answer_Ledgers_Tests.Add_Tests'Access);
   Run;
end Faults_Unit;
