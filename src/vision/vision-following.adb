--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Following with SPARK_Mode is

   procedure Begin_Anew
     (S : out State; Robots : Robot_Array; Found : Robot_Count) is
   begin
      S := (Robots, Found, Age => 0);
   end Begin_Anew;

   procedure Forget (S : out State) is
   begin
      S := (others => <>);
   end Forget;

   function Length (Item : Robot) return Distance is
      X : constant Micro_Pixels'Base := abs (Item.Direction.X - Item.Centre.X);
      Y : constant Micro_Pixels'Base := abs (Item.Direction.Y - Item.Centre.Y);
   begin
      return Micro_Pixels'Base'Min
        (Furthest,
         Micro_Pixels'Base'Max (X, Y) + Micro_Pixels'Base'Min (X, Y) / 2);
   end Length;

   procedure Plan
     (S      : State;
      Marker : Options.Marker_Kind;
      Gap    : Milliseconds;
      Areas  : out Area_Array;
      Number : out Robot_Count) is
   begin
      Areas := (others => <>);
      Number := (if May_Follow (S, Gap) then S.Count else 0);
      for K in 1 .. Number loop
         Areas (K) :=
           (S.Robots (K).Centre, Reach (S.Robots (K), Marker, Gap));
         pragma Loop_Invariant
           (for all L in 1 .. K =>
              Areas (L) = (S.Robots (L).Centre,
                           Reach (S.Robots (L), Marker, Gap)));
      end loop;
   end Plan;

   procedure Settle
     (S      : in out State;
      Gap    : Milliseconds;
      Robots : Robot_Array;
      Found  : Robot_Count;
      Done   : out Boolean) is
   begin
      Done := Has_All (S, Robots, Found);
      if Done then
         S := (Robots, Found, S.Age + Gap);
      else
         S.Count := 0;
      end if;
   end Settle;

end Vision.Following;
