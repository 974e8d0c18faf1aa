--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.C_Shapes with SPARK_Mode is

   Micro : constant double := 1.0E6;

   function Is_Pixels (Value : double) return Boolean is
     (Value in -1.0E7 .. 1.0E7);

   function Is_Degrees (Value : double) return Boolean is
     (Value in -180.0 .. 180.0);

   function Nearest (Value : double) return Long_Long_Integer
   with Import, Convention => C, External_Name => "llround", Global => null;
   pragma Linker_Options ("-lm");
   --  Of the C library: the provers know little about the conversion of a
   --  double to an integer

   function To_Millionths
     (Value : double; First, Last : Micro_Pixels) return Micro_Pixels
   is (Micro_Pixels
         (Long_Long_Integer'Max
            (Long_Long_Integer (First),
             Long_Long_Integer'Min
               (Long_Long_Integer (Last), Nearest (Value * Micro)))))
   with
     Pre  => First < Last and then Value in -1.0E7 .. 1.0E7,
     Post => To_Millionths'Result in First .. Last;
   --  Rounded

   function Is_Sound (P : C_Point) return Boolean is
     (Is_Pixels (P.X) and then Is_Pixels (P.Y));

   function Is_Sound (R : C_Robot) return Boolean is
     (R.Id in int (Identifier'First) .. int (Identifier'Last)
      and then Is_Sound (R.Centre) and then Is_Sound (R.Direction)
      and then Is_Degrees (R.Angle));

   function To_Pixels (Value : double) return Micro_Pixels is
     (To_Millionths (Value, Micro_Pixels'First, Micro_Pixels'Last))
   with Pre => Is_Pixels (Value);

   --  No expression functions: so proof does not look into the arithmetic
   --  where it only counts robots

   function To_Ada (P : C_Point) return Point is
   begin
      return (X => To_Pixels (P.X), Y => To_Pixels (P.Y));
   end To_Ada;

   function To_Ada (R : C_Robot) return Robot is
   begin
      return
        (Id        => Identifier (R.Id),
         Centre    => To_Ada (R.Centre),
         Direction => To_Ada (R.Direction),
         Angle     => Micro_Degrees
           (To_Millionths (R.Angle, -180_000_000, 180_000_000)));
   end To_Ada;

   function To_C (P : Point) return C_Point is
     (X => double (P.X) / Micro, Y => double (P.Y) / Micro);

   function To_C (R : Robot) return C_Robot is
     (Id        => int (R.Id),
      Centre    => To_C (R.Centre),
      Direction => To_C (R.Direction),
      Angle     => double (R.Angle) / Micro);

   function To_C (A : Area) return C_Area is
     (Centre => To_C (A.Centre), Reach => double (A.Reach) / Micro);

   procedure Take_Arena
     (Found : C_Arena; Arena : out Arena_Corners; Usable : out Boolean) is
   begin
      Arena := No_Arena;
      Usable := Is_Sound (Found);
      if Usable then
         for C in Corner loop
            Arena (C) := To_Ada (Found (C));
            pragma Loop_Invariant
              (for all D in Corner'First .. C =>
                 Arena (D) = To_Ada (Found (D)));
         end loop;
      end if;
   end Take_Arena;

   procedure Take_Robots
     (Found  : C_Robots;
      Total  : Robot_Count;
      Robots : out Robot_Array;
      Count  : out Robot_Count) is
   begin
      Robots := (others => <>);
      Count := 0;
      for K in 1 .. Total loop
         if Is_Sound (Found (K)) then
            Count := Count + 1;
            Robots (Count) := To_Ada (Found (K));
         end if;
         pragma Loop_Invariant (Count <= K);
         pragma Loop_Invariant
           ((Count > 0) = (for some L in 1 .. K => Is_Sound (Found (L))));
         pragma Loop_Invariant
           (if (for all L in 1 .. K => Is_Sound (Found (L)))
            then Count = K
              and then
                (for all L in 1 .. K => Robots (L) = To_Ada (Found (L))));
      end loop;
   end Take_Robots;

end Vision.C_Shapes;
