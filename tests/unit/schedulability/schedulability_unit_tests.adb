--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the response-time analysis: all, or those whose
--  names are its arguments.

with Response_Times_Tests;
with Supervisor_Model_Tests;
with Unit_Runs; use Unit_Runs;

procedure Schedulability_Unit_Tests is
begin
   Group ("Response_Times", Response_Times_Tests'Access);
   Group ("Supervisor_Model", Supervisor_Model_Tests'Access);
   Finish;
end Schedulability_Unit_Tests;
