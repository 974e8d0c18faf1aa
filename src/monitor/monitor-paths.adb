--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Paths with SPARK_Mode is

   function Cut_At (Line : String; First : Positive) return Cut is
      Result : Cut;
      Next   : Positive := First;
   begin
      while Is_Point (Line, Next) loop
         Result.Count := Result.Count + 1;
         Result.Starts (Result.Count) := Next;
         Result.Whole := Point_End (Line, Next) = Line'Last;
         exit when Result.Whole or else Result.Count = Max_Points;
         Next := Point_End (Line, Next) + 2;
         pragma Loop_Invariant (Next > First);
         pragma Loop_Invariant (not Result.Whole);
         pragma Loop_Invariant (Result.Count in 1 .. Max_Points - 1);
         pragma Loop_Invariant
           (for all I in 1 .. Result.Count =>
              Result.Starts (I) >= First
              and then Is_Point (Line, Result.Starts (I))
              and then (if I = 1 then Result.Starts (I) = First)
              and then Point_End (Line, Result.Starts (I)) < Line'Last
              and then
                (if I < Result.Count then
                    Result.Starts (I + 1) =
                      Point_End (Line, Result.Starts (I)) + 2));
         pragma Loop_Invariant
           (Next = Point_End (Line, Result.Starts (Result.Count)) + 2);
         pragma Loop_Variant (Increases => Result.Count);
      end loop;
      return Result;
   end Cut_At;

   function Field_End (Line : String; First : Positive) return Natural is
   begin
      for I in First .. Line'Last loop
         if Line (I) = Field_Separator then
            return I - 1;
         end if;
         pragma Loop_Invariant
           (for all J in First .. I => Line (J) /= Field_Separator);
      end loop;
      return Line'Last;
   end Field_End;

   procedure Parse
     (Line    : String;
      First   : Positive;
      Measure : Unit;
      Single  : Boolean;
      P       : out Path;
      Valid   : out Boolean)
   is
      Pieces : constant Cut := Cut_At (Line, First);
   begin
      P := (Measure => Measure, others => <>);
      Valid := Pieces.Whole and then (if Single then Pieces.Count = 1);
      if Valid then
         P.Count := Pieces.Count;
         for I in 1 .. Pieces.Count loop
            P.Points (I) := Point_At (Line, Pieces.Starts (I));
            pragma Loop_Invariant
              (for all J in 1 .. I =>
                 P.Points (J) = Point_At (Line, Pieces.Starts (J)));
         end loop;
      end if;
   end Parse;

   function Whole_End
     (Line : String; First : Positive; Last : Natural) return Natural is
   begin
      for I in First .. Last loop
         if not Numbers.Is_Digit (Line (I)) then
            return I - 1;
         end if;
         pragma Loop_Invariant (Numbers.Are_Digits (Line, First, I));
      end loop;
      return Last;
   end Whole_End;

end Monitor.Paths;
