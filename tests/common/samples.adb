--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured times of one kind, and their figures.

package body Samples is

   procedure Add (Object : in out Set; Value : Duration) is
   begin
      Object.Values.Append (Value);
   end Add;

   procedure Delete_Last (Object : in out Set) is
   begin
      Object.Values.Delete_Last;
   end Delete_Last;

   procedure Clear (Object : in out Set) is
   begin
      Object.Values.Clear;
   end Clear;

   function Last (Object : Set) return Duration is
     (Object.Values.Last_Element);

   function Count (Object : Set) return Natural is
     (Natural (Object.Values.Length));

   function Count_Above (Object : Set; Limit : Duration) return Natural is
      Result : Natural := 0;
   begin
      for Value of Object.Values loop
         if Value > Limit then
            Result := Result + 1;
         end if;
      end loop;
      return Result;
   end Count_Above;

   function Mean (Object : Set) return Duration is
      Sum : Duration := 0.0;
   begin
      for Value of Object.Values loop
         Sum := Sum + Value;
      end loop;
      return (if Object.Values.Is_Empty then 0.0 else Sum / Object.Count);
   end Mean;

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
            Part.Clear;
         end if;
      end loop;
      return Worst.Quantile (0.5);
   end Usual_Worst;

   function From_Least (Object : Set) return Set is
      Least  : constant Duration := Object.Quantile (0.0);
      Result : Set;
   begin
      for Value of Object.Values loop
         Result.Add (Value - Least);
      end loop;
      return Result;
   end From_Least;

end Samples;
