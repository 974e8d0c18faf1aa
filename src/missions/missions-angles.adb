--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Angles with SPARK_Mode is

   Quarter_Turn : constant := 90 * Million;

   subtype Quarter is Microdegrees range 0 .. Quarter_Turn;
   subtype Positive_Part is Part range 0 .. Million;

   --  Sine and arc tangent are odd polynomials of an argument of at most one,
   --  in millionths, whose coefficients make the largest error small

   subtype Coefficient is Wide range -4 * Million .. 4 * Million;

   function Times (A : Coefficient; B : Positive_Part) return Part is
     (Within (A * B / Million, -Million, Million));

   function Quarter_Sine (Angle : Quarter) return Positive_Part is
      X : constant Positive_Part := Wide (Angle) / 90;
      S : constant Positive_Part := X * X / Million;
   begin
      return Wide'Max
        (0,
         Times
           (1_570_794
            - Times (645_921 - Times (79_488 - Times (4_361, S), S), S),
            X));
   end Quarter_Sine;

   function Folded (Angle : Bearing) return Quarter is
     (if Angle <= Quarter_Turn then Angle else Half_Turn - Angle)
   with Pre => Angle >= 0;
   --  The angle in the first quarter with the same sine

   function Half_Quarter (Tangent : Positive_Part) return Quarter is
      --  The angle, up to half a quarter turn
      Radian : constant := 57_295_780;  --  microdegrees
      S      : constant Positive_Part := Tangent * Tangent / Million;
      Fourth : constant Part :=
        Times (116_433 - Times (52_653 - Times (11_721, S), S), S);
   begin
      return Microdegrees
        (Wide'Max
           (0,
            Times
              (999_977 - Times (332_623 - Times (193_543 - Fourth, S), S),
               Tangent))
         * Radian / Million);
   end Half_Quarter;

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
      Less  : constant Wide := Wide'Min (abs Wide (X), abs Wide (Y));
      More  : constant Wide := Wide'Max (abs Wide (X), abs Wide (Y));
      Half  : constant Quarter :=
        (if More = 0 then 0 else Half_Quarter (Less * Million / More));
      Acute : constant Quarter :=
        (if abs X >= abs Y then Half else Quarter_Turn - Half);
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
