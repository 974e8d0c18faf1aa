--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of what judges the faults: all, or those whose names
--  are its arguments.

with Answer_Ledgers_Tests;
with Unit_Runs; use Unit_Runs;

procedure Faults_Unit is
begin
   Group ("Answer_Ledgers", Answer_Ledgers_Tests'Access);
   Finish;
end Faults_Unit;
