--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.C_Shapes with SPARK_Mode is

   Micro : constant double := 1.0E6;

   function Is_Pixels (Value : double) return Boolean is
     (Value in -1.0E7 .. 1.0E7);

   function Is_Degrees (Value : double) return Boolean is
     (Value in -180.0 .. 180.0);

   function Rounded (Millionths : double) return Micro_Pixels is
     (if Millionths <= -1.0E13 then Micro_Pixels'First
      elsif Millionths >= 1.0E13 then Micro_Pixels'Last
      else Micro_Pixels (Millionths));

   function Rounded (Millionths : double) return Micro_Degrees is
     (if Millionths <= -1.8E8 then Micro_Degrees'First
      elsif Millionths >= 1.8E8 then Micro_Degrees'Last
      else Micro_Degrees (Millionths));
   --  Apart from the product, for the provers: from that of a sound number no
   --  limit is exceeded

   function Is_Sound (P : C_Point) return Boolean is
     (Is_Pixels (P.X) and then Is_Pixels (P.Y));

   function Is_Sound (R : C_Robot) return Boolean is
     (R.Id in int (Identifier'First) .. int (Identifier'Last)
      and then Is_Sound (R.Centre) and then Is_Sound (R.Direction)
      and then Is_Degrees (R.Angle));

   function To_Ada (P : C_Point) return Point is
     (X => Rounded (P.X * Micro), Y => Rounded (P.Y * Micro));

   function To_Ada (R : C_Robot) return Robot is
     (Id        => Identifier (R.Id),
      Centre    => To_Ada (R.Centre),
      Direction => To_Ada (R.Direction),
      Angle     => Rounded (R.Angle * Micro));

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
