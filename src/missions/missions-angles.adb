--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Angles with SPARK_Mode is

   Quarter_Turn : constant := 90 * Million;

   subtype Quarter is Microdegrees range 0 .. Quarter_Turn;
   subtype Positive_Part is Part range 0 .. Million;

   subtype Degree is Wide range 0 .. 90;

   Sines : constant array (Degree) of Positive_Part :=
   --  Of whole degrees
     (0, 17_452, 34_899, 52_336, 69_756, 87_156, 104_528, 121_869, 139_173,
      156_434, 173_648, 190_809, 207_912, 224_951, 241_922, 258_819,
      275_637, 292_372, 309_017, 325_568, 342_020, 358_368, 374_607,
      390_731, 406_737, 422_618, 438_371, 453_990, 469_472, 484_810,
      500_000, 515_038, 529_919, 544_639, 559_193, 573_576, 587_785,
      601_815, 615_661, 629_320, 642_788, 656_059, 669_131, 681_998,
      694_658, 707_107, 719_340, 731_354, 743_145, 754_710, 766_044,
      777_146, 788_011, 798_636, 809_017, 819_152, 829_038, 838_671,
      848_048, 857_167, 866_025, 874_620, 882_948, 891_007, 898_794,
      906_308, 913_545, 920_505, 927_184, 933_580, 939_693, 945_519,
      951_057, 956_305, 961_262, 965_926, 970_296, 974_370, 978_148,
      981_627, 984_808, 987_688, 990_268, 992_546, 994_522, 996_195,
      997_564, 998_630, 999_391, 999_848, 1_000_000);

   function Quarter_Sine (Angle : Quarter) return Positive_Part is
      Whole : constant Degree := Wide (Angle) / Million;
      Rest  : constant Wide   := Wide (Angle) mod Million;
   begin
      if Whole = 90 then
         return Million;
      end if;
      return
        (Sines (Whole) * (Million - Rest) + Sines (Whole + 1) * Rest
         + Million / 2) / Million;
   end Quarter_Sine;

   function Folded (Angle : Bearing) return Quarter is
     (if Angle <= Quarter_Turn then Angle else Half_Turn - Angle)
   with Pre => Angle >= 0;
   --  The angle in the first quarter with the same sine

   subtype Short is Wide range 0 .. 2 * Million;

   function Quarter_Direction (X, Y : Short) return Quarter is

      --  How far a direction of whole degrees is to the right of the vector,
      --  and how far the vector leads in this direction

      function Side (K : Degree) return Wide is
        (Y * Sines (90 - K) - X * Sines (K));

      function Ahead (K : Degree) return Wide is
        (X * Sines (90 - K) + Y * Sines (K));

      Radian  : constant := 57_295_780;  --  microdegrees
      Largest : constant := 10 ** 11;
      --  of one degree to the side is less

      Low  : Degree := 0;
      --  the last whole degree that is not to the left of the vector
      Rest : Wide;
   begin
      if Y = 0 then
         return 0;
      elsif X = 0 then
         return Quarter_Turn;
      end if;

      for K in Degree range 1 .. 89 loop
         exit when Side (K) < 0;
         Low := K;
      end loop;

      --  The rest is so small that it is its own tangent

      Rest := Wide'Max (0, Wide'Min (Side (Low), Largest)) * Radian
        / Wide'Max (1, Ahead (Low));
      return Quarter'Min
        (Quarter_Turn,
         Microdegrees (Low) * Million
         + Microdegrees (Wide'Min (Rest, Million)));
   end Quarter_Direction;

   function Along (X, Y : Micrometres; Towards : Bearing) return Micrometres
   is
      Sum : constant Wide :=
        (Wide (X) * Cosine (Towards) + Wide (Y) * Sine (Towards)) / Million;
   begin
      return Micrometres
        (Within
           (Sum, Wide (Micrometres'First), Wide (Micrometres'Last)));
   end Along;

   function Cosine (Angle : Bearing) return Part is
     (if abs Angle <= Quarter_Turn then Quarter_Sine (Quarter_Turn - abs Angle)
      else -Quarter_Sine (abs Angle - Quarter_Turn));

   function Direction (X, Y : Micrometres) return Bearing is
      Wide_X  : constant Wide := abs Wide (X);
      Wide_Y  : constant Wide := abs Wide (Y);
      Shorter : constant Wide :=
        Wide'Max (Wide_X, Wide_Y) / Million + 1;
      --  Both are made shorter by it, so that products are small enough; short
      --  ones longer, so that nothing is lost
      Longer  : constant Wide :=
        (if Shorter = 1
         then Million / Wide'Max (1, Wide'Max (Wide_X, Wide_Y)) else 1);
      Acute   : constant Quarter := Quarter_Direction
        (Wide'Min (Wide_X * Longer / Shorter, 2 * Million),
         Wide'Min (Wide_Y * Longer / Shorter, 2 * Million));
   begin
      if X >= 0 then
         return (if Y >= 0 then Acute else -Acute);
      else
         return (if Y >= 0 then Half_Turn - Acute else Acute - Half_Turn);
      end if;
   end Direction;

   function Sine (Angle : Bearing) return Part is
     (if Angle < 0 then -Quarter_Sine (Folded (-Angle))
      else Quarter_Sine (Folded (Angle)));

end Missions.Angles;
