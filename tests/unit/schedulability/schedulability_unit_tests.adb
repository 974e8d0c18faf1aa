--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the response-time analysis: all, or those whose
--  names are its arguments.

with Response_Times_Tests;
with Supervisor_Model_Tests;
with Unit_Runs; use Unit_Runs;

procedure Schedulability_Unit_Tests is
begin
   Add ("Response_Times", Response_Times_Tests.Add_Tests'Access);
   Add ("Supervisor_Model", Supervisor_Model_Tests.Add_Tests'Access);
   Run;
end Schedulability_Unit_Tests;
