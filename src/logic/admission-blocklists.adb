--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Blocklists with SPARK_Mode is

   procedure Clear (H : out History) is
   begin
      H := (others => <>);
   end Clear;

   function Count_Of
     (H : History; S : Admission.Networks.Source) return Arrival_Count
   with
     Refined_Post =>
       (Count_Of'Result > 0) =
         (for some I in 1 .. H.Count => H.Items (I) = S)
   is
      Result : Arrival_Count := 0;
   begin
      for I in 1 .. H.Count loop
         if H.Items (I) = S then
            Result := Result + 1;
         end if;
         pragma Loop_Invariant (Result <= I);
         pragma Loop_Invariant
           ((Result > 0) = (for some J in 1 .. I => H.Items (J) = S));
      end loop;
      return Result;
   end Count_Of;

   procedure Extend (L : in out List; H : History; Grown : out Boolean) is
      Before : constant Source_Count := L.Count;
   begin
      for I in 1 .. H.Count loop
         exit when L.Count = Max_Sources;
         if not Contains (L, H.Items (I))
           and then Count_Of (H, H.Items (I)) >= Threshold
         then
            L.Count := L.Count + 1;
            L.Items (L.Count) := H.Items (I);
         end if;
         pragma Loop_Invariant (L.Count >= Before);
         pragma Loop_Invariant
           (for all J in 1 .. Before =>
              L.Items (J) = L.Items'Loop_Entry (J));
         pragma Loop_Invariant
           (for all J in Before + 1 .. L.Count =>
              Count_Of (H, L.Items (J)) >= Threshold);
      end loop;
      Grown := L.Count > Before;
   end Extend;

   procedure Note (H : in out History; S : Admission.Networks.Source) is
   begin
      H.Last := (if H.Last = Max_Arrivals then 1 else H.Last + 1);
      H.Items (H.Last) := S;
      H.Count := Arrival_Count'Max (H.Count, H.Last);
   end Note;

   procedure Remove_Oldest (L : in out List) is
   begin
      L.Items (1 .. L.Count - 1) := L.Items (2 .. L.Count);
      L.Count := L.Count - 1;
   end Remove_Oldest;

end Admission.Blocklists;
