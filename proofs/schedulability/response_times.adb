--  SPDX-License-Identifier: GPL-3.0-or-later
--  Response-time analysis for fixed priorities: bounds for activities on
--  processors (pre-emptive) and for transactions on a line (they are not).

package body Response_Times with SPARK_Mode is

   pragma Assertion_Policy
     (Ghost => Ignore, Assert => Ignore, Loop_Invariant => Ignore);

   Max_Rounds : constant := 10_000;
   --  of one recurrence; each that does not end it lengthens the window

   function Interference
     (Set : Activity_Array; Who : Activity_Index; Window : Span)
      return Microseconds
   is
      Sum : Microseconds := 0;
   begin
      for I in Set'Range loop
         if Interferes (Set, Who, I) then
            Sum := Sum + Demand_Of (Set (I), Window);
         end if;
         pragma Loop_Invariant (Sum = Interference_To (Set, Who, Window, I));
      end loop;
      return Sum;
   end Interference;

   function Window_Of
     (Set : Activity_Array; Who : Activity_Index; Before : Release_Index)
      return Window_Bound
   is
      Demand : constant Microseconds := Own_Demand (Set (Who), Before);
      Window : Span;
      Next   : Microseconds;
   begin
      if Demand <= Horizon then
         Window := Demand;
         for Round in 1 .. Max_Rounds loop
            Next := Demand + Interference (Set, Who, Window);
            if Next = Window then
               return (Found => True, Length => Window);
            end if;
            exit when Next > Horizon;
            Window := Next;
         end loop;
      end if;
      return (Found => False, Length => 0);
   end Window_Of;

   procedure Pre_Emptive_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   is
      Item   : constant Activity := Set (Who);
      Window : Window_Bound;
      Finish : Lateness := 0;
      Local  : Lateness := 0;
   begin
      Result := (others => <>);
      for Before in Release_Index loop
         Window := Window_Of (Set, Who, Before);
         exit when not Window.Found;
         Finish := Lateness'Max
           (Finish, From_Arrival (Item, Window.Length, Before));
         Local := Lateness'Max
           (Local, From_Release (Item, Window.Length, Before));
         exit when Finish > Horizon or else Local > Horizon;
         pragma Loop_Invariant
           (not Result.Exists and then Window = Window_Of (Set, Who, Before));
         pragma Loop_Invariant (Finish <= Horizon and then Local <= Horizon);
         pragma Loop_Invariant
           (for all B in 0 .. Before =>
              Is_Covered (Item, Window_Of (Set, Who, B), B, Finish, Local));
         if Is_Last (Item, Window, Before) then
            Result := (Exists   => True,
                       Start    => 0,
                       Finish   => Finish,
                       Local    => Local,
                       Releases => Before + 1);
            exit;
         end if;
      end loop;
   end Pre_Emptive_Bound;

   function Longest_Lower
     (Set : Activity_Array; Who : Activity_Index) return Span
   is
      Longest : Span := 0;
   begin
      for I in Set'Range loop
         if Set (I).Priority < Set (Who).Priority then
            Longest := Span'Max (Longest, Set (I).Budget);
         end if;
         pragma Loop_Invariant
           (for all J in Set'First .. I =>
              (if Set (J).Priority < Set (Who).Priority
               then Longest >= Set (J).Budget));
      end loop;
      return Longest;
   end Longest_Lower;

   function Busy_Period
     (Set : Activity_Array; Who : Activity_Index) return Window_Bound
   is
      Blocking : constant Span := Longest_Lower (Set, Who);
      Length   : Span := Span'Max (1, Set (Who).Budget);
      Sum      : Microseconds;
   begin
      for Round in 1 .. Max_Rounds loop
         Sum := 0;
         for I in Set'Range loop
            if Set (I).Priority >= Set (Who).Priority then
               Sum := Sum + Carried_Of (Set (I), Length);
            end if;
            pragma Loop_Invariant (Sum = Carried_To (Set, Who, Length, I));
         end loop;
         if Blocking + Sum <= Length then
            return (Found => True, Length => Length);
         end if;
         exit when Blocking + Sum > Horizon;
         Length := Blocking + Sum;
      end loop;
      return (Found => False, Length => 0);
   end Busy_Period;

   function Wait_Of
     (Set : Activity_Array; Who : Activity_Index; Before : Release_Index)
      return Window_Bound
   is
      Demand : constant Microseconds :=
        Longest_Lower (Set, Who) + Before * Set (Who).Budget;
      Length : Span;
      Sum    : Microseconds;
   begin
      if Demand <= Horizon then
         Length := Demand;
         for Round in 1 .. Max_Rounds loop
            Sum := 0;
            for I in Set'Range loop
               if I /= Who and then Set (I).Priority >= Set (Who).Priority
               then
                  Sum := Sum + Queued_Of (Set (I), Length);
               end if;
               pragma Loop_Invariant (Sum = Queued_To (Set, Who, Length, I));
            end loop;
            if Demand + Sum = Length then
               return (Found => True, Length => Length);
            end if;
            exit when Demand + Sum > Horizon;
            Length := Demand + Sum;
         end loop;
      end if;
      return (Found => False, Length => 0);
   end Wait_Of;

   procedure Transaction_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   is
      Item   : constant Activity := Set (Who);
      Busy   : constant Window_Bound := Busy_Period (Set, Who);
      Count  : Microseconds;
      Wait   : Window_Bound;
      Start  : Lateness := 0;
      Finish : Lateness := 0;
      Local  : Lateness := 0;
   begin
      Result := (others => <>);
      Count := Releases (Busy.Length, Item.Jitter, Item.Period);
      if not Busy.Found or else Count not in 1 .. Max_Releases then
         return;
      end if;
      for Before in 0 .. Count - 1 loop
         Wait := Wait_Of (Set, Who, Before);
         if not Wait.Found or else Wait.Length + Item.Budget > Horizon then
            return;
         end if;
         Start := Lateness'Max
           (Start, From_Arrival (Item, Wait.Length, Before));
         Finish := Lateness'Max
           (Finish, From_Arrival (Item, Wait.Length + Item.Budget, Before));
         Local := Lateness'Max
           (Local, From_Release (Item, Wait.Length + Item.Budget, Before));
         if Start > Horizon or else Finish > Horizon or else Local > Horizon
         then
            return;
         end if;
         pragma Assert
           (Is_Carried (Item, Wait, Before, Start, Finish, Local));
         pragma Assert
           (for all B in 0 .. Before - 1 =>
              Is_Carried
                (Item, Wait_Of (Set, Who, B), B, Start, Finish, Local));
         pragma Loop_Invariant
           (Start <= Horizon and then Finish <= Horizon
            and then Local <= Horizon);
         pragma Loop_Invariant
           (for all B in 0 .. Before =>
              Is_Carried
                (Item, Wait_Of (Set, Who, B), B, Start, Finish, Local));
      end loop;
      Result := (Exists   => True,
                 Start    => Start,
                 Finish   => Finish,
                 Local    => Local,
                 Releases => Count);
   end Transaction_Bound;

   function Least_Ceilings
     (Set : Activity_Array; Sections : Section_Array) return Ceiling_Array
   is
      Result : Ceiling_Array (Sections'Range (2)) := (others => 0);
   begin
      for O in Result'Range loop
         for A in Set'Range loop
            if Sections (A, O) > 0 then
               Result (O) := Urgency'Max (Result (O), Set (A).Priority);
            end if;
            pragma Loop_Invariant
              (for all B in Set'First .. A =>
                 (if Sections (B, O) > 0
                  then Result (O) >= Set (B).Priority));
            pragma Loop_Invariant
              (for all P in Result'First .. O - 1 =>
                 (for all B in Set'Range =>
                    (if Sections (B, P) > 0
                     then Result (P) >= Set (B).Priority)));
         end loop;
         pragma Loop_Invariant
           (for all P in Result'First .. O =>
              (for all B in Set'Range =>
                 (if Sections (B, P) > 0
                  then Result (P) >= Set (B).Priority)));
      end loop;
      return Result;
   end Least_Ceilings;

   function Ceiling_Blocking
     (Set      : Activity_Array;
      Sections : Section_Array;
      Ceilings : Ceiling_Array;
      Who      : Activity_Index) return Span
   is
      Longest : Span := 0;
   begin
      for A in Set'Range loop
         if Set (A).Processor = Set (Who).Processor
           and then Set (A).Priority < Set (Who).Priority
         then
            for O in Ceilings'Range loop
               if Ceilings (O) >= Set (Who).Priority then
                  Longest := Span'Max (Longest, Sections (A, O));
               end if;
               pragma Loop_Invariant (Longest >= Longest'Loop_Entry);
               pragma Loop_Invariant
                 (for all P in Ceilings'First .. O =>
                    (if Ceilings (P) >= Set (Who).Priority
                     then Longest >= Sections (A, P)));
            end loop;
         end if;
         pragma Loop_Invariant
           (for all B in Set'First .. A =>
              (for all O in Ceilings'Range =>
                 (if Set (B).Processor = Set (Who).Processor
                    and then Set (B).Priority < Set (Who).Priority
                    and then Ceilings (O) >= Set (Who).Priority
                  then Longest >= Sections (B, O))));
      end loop;
      return Longest;
   end Ceiling_Blocking;

end Response_Times;
