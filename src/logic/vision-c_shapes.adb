--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.C_Shapes with SPARK_Mode is

   Pixel_Limit  : constant double := 1.0E7;
   Degree_Limit : constant double := 180.0;
   Micro        : constant double := 1.0E6;

   function Is_Sound (P : C_Point) return Boolean is
     (P.X in -Pixel_Limit .. Pixel_Limit
      and then P.Y in -Pixel_Limit .. Pixel_Limit);

   function Is_Sound (R : C_Robot) return Boolean is
     (R.Id in int (Identifier'First) .. int (Identifier'Last)
      and then Is_Sound (R.Centre) and then Is_Sound (R.Direction)
      and then R.Angle in -Degree_Limit .. Degree_Limit);

   function To_Ada (P : C_Point) return Point is
     (X => Micro_Pixels (P.X * Micro), Y => Micro_Pixels (P.Y * Micro));

   function To_Ada (R : C_Robot) return Robot is
     (Id        => Identifier (R.Id),
      Centre    => To_Ada (R.Centre),
      Direction => To_Ada (R.Direction),
      Angle     => Micro_Degrees (R.Angle * Micro));

   function To_C (P : Point) return C_Point is
     (X => double (P.X) / Micro, Y => double (P.Y) / Micro);

   function To_C (R : Robot) return C_Robot is
     (Id        => int (R.Id),
      Centre    => To_C (R.Centre),
      Direction => To_C (R.Direction),
      Angle     => double (R.Angle) / Micro);

   function To_C (A : Area) return C_Area is
     (Centre => To_C (A.Centre), Reach => double (A.Reach) / Micro);

end Vision.C_Shapes;
