--  SPDX-License-Identifier: GPL-3.0-or-later
--  What vision_c has found, as far as it is sound. Not in Vision.C_Shapes, so
--  that the proof here needs no arithmetic of numbers with a fraction.

with Vision.C_Shapes; use Vision.C_Shapes;
with Vision.Shapes;   use Vision.Shapes;

package Vision.Findings with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.Findings);

   procedure Take_Arena
     (Found : C_Arena; Arena : out Arena_Corners; Usable : out Boolean)
   with
     Post => Usable = Is_Sound (Found)
       and then
         (if Usable
          then (for all C in Corner => Arena (C) = To_Ada (Found (C)))
          else Arena = No_Arena);

   procedure Take_Robots
     (Found  : C_Robots;
      Total  : Robot_Count;
      Robots : out Robot_Array;
      Count  : out Robot_Count)
   with
     Post => Count <= Total
       and then (Count > 0) =
         (for some K in 1 .. Total => Is_Sound (Found (K)))
       and then
         (if (for all K in 1 .. Total => Is_Sound (Found (K)))
          then Count = Total
            and then
              (for all K in 1 .. Total => Robots (K) = To_Ada (Found (K))));
   --  The sound ones of Found (1 .. Total), in their order

end Vision.Findings;
