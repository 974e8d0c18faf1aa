--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Paths with SPARK_Mode is

   function Place_Of
     (Mark : Character; Line : String; First : Positive; Last : Natural)
      return Positive is
   begin
      for I in First .. Last loop
         if Line (I) = Mark then
            return I;
         end if;
         pragma Loop_Invariant (for all J in First .. I => Line (J) /= Mark);
      end loop;
      return Last + 1;
   end Place_Of;

   procedure Parse
     (Line    : String;
      First   : Positive;
      Measure : Unit;
      Most    : Point_Number;
      P       : out Path;
      Valid   : out Boolean)
   is
      Next : Positive := First;
   begin
      P := (Measure => Measure, others => <>);
      Valid := Is_Path (Line, First, Most);
      if Valid then
         loop
            P.Count := P.Count + 1;
            P.Points (P.Count) := Point_At (Line, Next);
            exit when Point_End (Line, Next) = Line'Last;
            Next := Point_End (Line, Next) + 2;
            pragma Loop_Invariant (Is_Slice (Line, Next, Line'Last));
            pragma Loop_Invariant (P.Measure = Measure);
            pragma Loop_Invariant (P.Count in 1 .. Most - 1);
            pragma Loop_Invariant (Is_Path (Line, Next, Most - P.Count));
            pragma Loop_Variant (Increases => P.Count);
         end loop;
      end if;
   end Parse;

end Monitor.Paths;
