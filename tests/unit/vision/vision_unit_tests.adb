--  SPDX-License-Identifier: GPL-3.0-or-later
--  Runs the unit tests of the vision: all, or those whose names
--  are its arguments.

with Following_Tests;
with Vision_Arena_Tests;
with Vision_C_Tests;
with Vision_Jpeg_Tests;
with Vision_Robot_Tests;
with Vision_Source_Tests;
with Vision_Tests;
with Unit_Runs;

procedure Vision_Unit_Tests is
begin
   Unit_Runs.Add (new Vision_C_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Arena_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Robot_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Source_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Jpeg_Tests.Test_Case);
   Unit_Runs.Add (new Following_Tests.Test_Case);
   Unit_Runs.Add (new Vision_Tests.Test_Case);
   Unit_Runs.Run;
end Vision_Unit_Tests;
