--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Findings with SPARK_Mode is

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

end Vision.Findings;
