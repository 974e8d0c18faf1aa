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

   function Quantiles (Object : Set; Shares : Share_Array)
     return Value_Array
   is
      Sorted : Vectors.Vector := Object.Values;
      Result : Value_Array (Shares'Range) := (others => 0.0);
      Place  : Natural;
   begin
      if not Sorted.Is_Empty then
         Sorting.Sort (Sorted);
         for I in Shares'Range loop
            Place := Natural
              (Float'Ceiling (Shares (I) * Float (Object.Count)));
            Result (I) := Sorted
              (Integer'Max (1, Integer'Min (Place, Object.Count)));
         end loop;
      end if;
      return Result;
   end Quantiles;

   function Quantile (Object : Set; Share : Float) return Duration is
     (Object.Quantiles ((1 => Share)) (1));

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
