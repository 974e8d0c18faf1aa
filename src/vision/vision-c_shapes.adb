--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.C_Shapes with SPARK_Mode is

   Micro : constant double := 1.0E6;

   function Nearest (Value : double) return Long_Long_Integer
   with Import, Convention => C, External_Name => "llround", Global => null;
   pragma Linker_Options ("-lm");
   --  Of the C library: the provers know little about the conversion of a
   --  double to an integer

   function To_Millionths
     (Value : double; Most : Micro_Pixels) return Micro_Pixels
   is (Micro_Pixels
         (Long_Long_Integer'Max
            (-Long_Long_Integer (Most),
             Long_Long_Integer'Min
               (Long_Long_Integer (Most), Nearest (Value * Micro)))))
   with
     Pre  => Most > 0 and then Value in -1.0E7 .. 1.0E7,
     Post => To_Millionths'Result in -Most .. Most;

   --  No expression functions: so proof does not look into the arithmetic
   --  where it only counts robots

   function To_Ada (P : C_Point) return Point is
   begin
      return (X => To_Millionths (P.X, Micro_Pixels'Last),
              Y => To_Millionths (P.Y, Micro_Pixels'Last));
   end To_Ada;

   function To_Ada (R : C_Robot) return Robot is
   begin
      return
        (Id        => Identifier (R.Id),
         Centre    => To_Ada (R.Centre),
         Direction => To_Ada (R.Direction),
         Angle     => Micro_Degrees (To_Millionths (R.Angle, 180_000_000)));
   end To_Ada;

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
      end loop;
   end Take_Robots;

   function To_C (P : Point) return C_Point is
     (X => double (P.X) / Micro, Y => double (P.Y) / Micro);

   function To_C (A : Arena_Corners) return C_Arena is
     (To_C (A (Top_Left)), To_C (A (Top_Right)),
      To_C (A (Bottom_Right)), To_C (A (Bottom_Left)));

   function To_C (R : Robot) return C_Robot is
     (Id        => int (R.Id),
      Centre    => To_C (R.Centre),
      Direction => To_C (R.Direction),
      Angle     => double (R.Angle) / Micro);

   function To_C (A : Area) return C_Area is
     (Centre => To_C (A.Centre), Reach => double (A.Reach) / Micro);

end Vision.C_Shapes;
