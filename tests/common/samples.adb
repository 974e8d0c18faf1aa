--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured times of one kind, and their figures.

package body Samples is

   procedure Add (Object : in out Set; Value : Duration) is
   begin
      Object.Values.Append (Value);
   end Add;

   function Count (Object : Set) return Natural is
     (Natural (Object.Values.Length));

   function Element (Object : Set; Place : Positive) return Duration is
     (Object.Values (Place));

   function Last (Object : Set) return Duration is
     (Object.Values.Last_Element);

   function Quantile (Object : Set; Share : Float) return Duration is
      Sorted : Vectors.Vector := Object.Values;
      Place  : constant Natural :=
        Natural (Float'Ceiling (Share * Float (Object.Count)));
   begin
      if Sorted.Is_Empty then
         return 0.0;
      end if;
      Sorting.Sort (Sorted);
      return Sorted (Integer'Max (1, Integer'Min (Place, Object.Count)));
   end Quantile;

   function Usual_Worst (Object : Set; Run : Positive) return Duration is
      Worst : Set;
      Part  : Set;
   begin
      for Value of Object.Values loop
         Part.Add (Value);
         if Part.Count = Run then
            Worst.Add (Part.Quantile (1.0));
            Part := None;
         end if;
      end loop;
      return Worst.Quantile (0.5);
   end Usual_Worst;

end Samples;
