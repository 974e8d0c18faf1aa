--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the response-time analysis: all, or those whose
--  names are its arguments.

with Response_Times_Tests;
with Supervisor_Model_Tests;
with Unit_Runs;

procedure Schedulability_Unit_Tests is
begin
   Unit_Runs.Add (new Response_Times_Tests.Test_Case);
   Unit_Runs.Add (new Supervisor_Model_Tests.Test_Case);
   Unit_Runs.Run;
end Schedulability_Unit_Tests;
