--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random missions.

with Ada.Numerics.Long_Elementary_Functions;
use Ada.Numerics.Long_Elementary_Functions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Plain_Numbers;
with Random_Numbers;        use Random_Numbers;

package body Mission_Plans is

   use Robot_Motion;

   Tenth : constant := 100;
   --  of a millimetre, in micrometres

   function Centimetres (Value : Micro) return String is
      --  With two decimals
      Part : constant Natural := Natural (Value / Tenth mod 100);
   begin
      return Plain_Numbers.Image (Natural (Value / (100 * Tenth)))
        & (if Part < 10 then ".0" else ".") & Plain_Numbers.Image (Part);
   end Centimetres;

   function Order (P : Plan) return String is
      Text : Unbounded_String := To_Unbounded_String ("MPCM:");
   begin
      for K in 1 .. P.Count loop
         Append
           (Text, (if K = 1 then "" else ";") & Centimetres (P.Points (K).X)
            & ";" & Centimetres (P.Points (K).Y));
      end loop;
      return To_String (Text);
   end Order;

   function Exact_Time (P : Plan) return Duration is
      Speed     : constant Long_Float :=
        Long_Float (Wheel_Speed * P.Wheels.Speed) / 100.0 * 1_000.0;
      Turning   : constant Long_Float :=
        Long_Float (Turn_Rate * P.Wheels.Turn_Speed) / 100.0;
      --  Micrometres and degrees a second
      Heading   : Long_Float := Long_Float (P.Start.Angle) / 1.0E6;
      From      : Place := (P.Start.X, P.Start.Y);
      Dx, Dy    : Long_Float;
      Direction : Long_Float;
      Angle     : Long_Float;
      Result    : Long_Float := 0.0;
   begin
      for K in 1 .. P.Count loop
         Dx := Long_Float (P.Points (K).X - From.X);
         Dy := Long_Float (P.Points (K).Y - From.Y);
         if Dx /= 0.0 or else Dy /= 0.0 then
            Direction := Arctan (Dy, Dx, Cycle => 360.0);
            Angle := abs (Direction - Heading);
            while Angle > 360.0 loop
               Angle := Angle - 360.0;
            end loop;
            Result := Result
              + Long_Float'Min (Angle, 360.0 - Angle) / Turning
              + Sqrt (Dx ** 2 + Dy ** 2) / Speed;
            Heading := Direction;
            From := P.Points (K);
         end if;
      end loop;
      return Duration (Result);
   end Exact_Time;

   function Read (Pose, Order : String) return Plan is
      Label  : constant String := "MPCM:";
      Result : Plan;
      First  : Positive;

      function Next (Text : String; Mark : Character) return Micro is
         --  The number from First to Mark or the end, in millionths of the
         --  unit; First goes behind
         Stop : constant Natural := Index (Text & Mark, (1 => Mark), First);
         Last : constant Natural := Stop - 1;
      begin
         return Value : constant Micro :=
           Micro (Long_Float'Value (Text (First .. Last)) * 1.0E6)
         do
            First := Stop + 1;
         end return;
      end Next;

   begin
      First := Pose'First;
      Result.Start.X := Next (Pose, ',') / 100;
      Result.Start.Y := Next (Pose, ',') / 100;
      Result.Start.Angle := Next (Pose, ',');
      if Index (Order, Label) /= Order'First then
         raise Bad_Plan with Label & " is expected";
      end if;
      First := Order'First + Label'Length;
      while First <= Order'Last loop
         Result.Count := Result.Count + 1;
         Result.Points (Result.Count).X := Next (Order, ';') / 100;
         Result.Points (Result.Count).Y := Next (Order, ';') / 100;
      end loop;
      return Result;
   exception
      when Constraint_Error =>
         raise Bad_Plan with "a pose and points in the arena are expected";
   end Read;

   function Random
     (Seed : Natural; Number : Positive; Least : Point_Number := 5) return Plan
   is
      Source : Generator;
      Result : Plan;

      function Between (Low, High : Micro) return Micro is
        (Micro (Whole
           (Source, Integer (Low) / Tenth, Integer (High) / Tenth)) * Tenth);

      function Any_X return Micro is
        (Between (Margin, Arena_Width - Margin));

      function Any_Y return Micro is
        (Between (Margin, Arena_Height - Margin));

   begin
      Start (Source, Seed, "mission" & Number'Image);
      Result.Number := Number;
      Result.Start :=
        (X     => Any_X,
         Y     => Any_Y,
         Angle => Micro (Whole (Source, 0, 359)) * 1_000_000);
      Result.Count := Whole (Source, Least, 12);
      for K in 1 .. Result.Count loop
         Result.Points (K) := (Any_X, Any_Y);
      end loop;
      Result.Faulty := Number mod 2 = 0;
      if Result.Faulty then
         Result.Wheels :=
           (Speed      => Whole (Source, 70, 130),
            Turn_Speed => Whole (Source, 70, 130),
            Overshoot  => Whole
              (Source, Overshoot_Percent'First, Overshoot_Percent'Last),
            Pull       => Whole
              (Source, Pull_Angle'First, Pull_Angle'Last));
      end if;
      return Result;
   end Random;

end Mission_Plans;
