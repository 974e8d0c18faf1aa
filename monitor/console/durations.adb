--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured durations, with their statistics.

with Ada.Containers.Generic_Array_Sort;

package body Durations is

   procedure Sort is new Ada.Containers.Generic_Array_Sort
     (Positive, Duration, Values);

   procedure Add (To : in out Set; Value : Duration) is
   begin
      To.Data (To.Next) := Value;
      To.Next := To.Next mod Capacity + 1;
      To.Count := Natural'Min (To.Count + 1, Capacity);
   end Add;

   function Mean (Of_Set : Set) return Duration is
      Sum : Duration := 0.0;
   begin
      for Value of Of_Set.Data (1 .. Of_Set.Count) loop
         Sum := Sum + Value;
      end loop;
      return Sum / Of_Set.Count;
   end Mean;

   function Quantile (Of_Set : Set; Share : Long_Float) return Duration is
      Sorted : Values := Of_Set.Data (1 .. Of_Set.Count);
      Rank   : constant Natural :=
        Natural (Long_Float'Ceiling (Share * Long_Float (Of_Set.Count)));
   begin
      Sort (Sorted);
      return Sorted (Natural'Max (1, Rank));
   end Quantile;

end Durations;
