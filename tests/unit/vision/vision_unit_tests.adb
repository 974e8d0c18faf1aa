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
with Unit_Runs; use Unit_Runs;

procedure Vision_Unit_Tests is
begin
   Add ("vision_c", Vision_C_Tests.Add_Tests'Access);
   Add ("arena", Vision_Arena_Tests.Add_Tests'Access);
   Add ("robots", Vision_Robot_Tests.Add_Tests'Access);
   Add ("sources", Vision_Source_Tests.Add_Tests'Access);
   Add ("the camera's own JPEG", Vision_Jpeg_Tests.Add_Tests'Access);
   Add ("following", Following_Tests.Add_Tests'Access);
   Add ("Ada side of the vision", Vision_Tests.Add_Tests'Access);
   Run;
end Vision_Unit_Tests;
