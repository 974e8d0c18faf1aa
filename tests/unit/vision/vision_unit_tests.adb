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
   Group ("vision_c", Vision_C_Tests'Access);
   Group ("arena", Vision_Arena_Tests'Access);
   Group ("robots", Vision_Robot_Tests'Access);
   Group ("sources", Vision_Source_Tests'Access);
   Group ("the camera's own JPEG", Vision_Jpeg_Tests'Access);
   Group ("following", Following_Tests'Access);
   Group ("Ada side of the vision", Vision_Tests'Access);
   Finish;
end Vision_Unit_Tests;
