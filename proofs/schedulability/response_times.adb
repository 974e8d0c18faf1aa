--  SPDX-License-Identifier: GPL-3.0-or-later
--  Response-time analysis for fixed priorities: bounds for activities on
--  processors (pre-emptive) and for transactions on a line (they are not).

package body Response_Times with SPARK_Mode is

   Max_Rounds : constant := 10_000;
   --  of one recurrence; each that does not end it lengthens the window

   Max_Instances : constant := 1_000;
   --  releases of one activity in one busy period

   Most : constant := 4 * Horizon * Horizon;
   --  of the demand of one activity in a window

   Too_Much : constant := Horizon + 1;

   function Demand_Of (Item : Activity; Window : Span) return Microseconds is
     (if Item.Budget = 0 then 0
      elsif Item.Jitter = Horizon then Too_Much
      else Releases (Window, Item.Jitter + Item.Deferral, Item.Period)
        * Item.Budget)
   with Post => Demand_Of'Result <= Most;

   function Queued_Of (Item : Activity; Window : Span) return Microseconds is
     (if Item.Budget = 0 then 0
      elsif Item.Jitter = Horizon then Too_Much
      else ((Window + Item.Jitter) / Item.Period + 1) * Item.Budget)
   with Post => Queued_Of'Result <= Most;
   --  An arrival at the very end of the window goes before a transaction
   --  that has not begun

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
         pragma Loop_Invariant
           (Sum <= Microseconds (I - Set'First + 1) * Most);
      end loop;
      return Sum;
   end Interference;

   procedure Find_Window
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Demand : Span;
      Window : out Span;
      Found  : out Boolean)
   is
      Next : Microseconds;
   begin
      Window := Demand;
      for Round in 1 .. Max_Rounds loop
         Next := Demand + Interference (Set, Who, Window);
         Found := Next = Window;
         exit when Found or else Next > Horizon;
         Window := Next;
      end loop;
   end Find_Window;

   procedure Pre_Emptive_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   is
      Item   : constant Activity := Set (Who);
      Demand : Microseconds;
      Window : Span;
      Found  : Boolean;
      Ended  : Microseconds;
      Worst  : Microseconds := 0;
      Local  : Span := 0;
   begin
      Result := (others => <>);
      for Before in Microseconds range 0 .. Max_Instances - 1 loop
         Demand := Item.Blocking + (Before + 1) * Item.Budget;
         exit when Demand > Horizon;
         Find_Window (Set, Who, Demand, Window, Found);
         exit when not Found;
         Ended := Window + Item.Jitter;
         if Ended > Before * Item.Period then
            Worst := Microseconds'Max (Worst, Ended - Before * Item.Period);
         end if;
         exit when Worst > Horizon;
         if Before * Item.Period <= Item.Jitter then
            --  it may have been released with the first
            Local := Span'Max (Local, Window);
         elsif Ended > Before * Item.Period then
            Local := Span'Max (Local, Ended - Before * Item.Period);
         end if;
         if Ended <= (Before + 1) * Item.Period then
            --  done before the next one comes: the busy period is over
            Result := (Exists => True,
                       Start  => 0,
                       Finish => Worst,
                       Local  => Local);
            exit;
         end if;
      end loop;
   end Pre_Emptive_Bound;

   procedure Transaction_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   is
      Item : constant Activity := Set (Who);

      function Longest_Lower return Span
      with Global => (Input => (Set, Who)), Pre => Who in Set'Range;
      --  The transaction that has just begun

      procedure Find_Busy (Length : out Span; Found : out Boolean)
      with
        Global => (Input => (Set, Who)),
        Pre    => Who in Set'Range;
      --  The longest time without rest for Who and the more urgent ones

      procedure Find_Start
        (Demand : Span; Length : out Span; Found : out Boolean)
      with
        Global => (Input => (Set, Who)),
        Pre    => Who in Set'Range;
      --  When a transaction before which Demand is due may begin

      function Longest_Lower return Span is
         Longest : Span := 0;
      begin
         for I in Set'Range loop
            if Set (I).Priority < Set (Who).Priority then
               Longest := Span'Max (Longest, Set (I).Budget);
            end if;
         end loop;
         return Longest;
      end Longest_Lower;

      procedure Find_Busy (Length : out Span; Found : out Boolean) is
         Blocking : constant Span := Longest_Lower;
         Next     : Microseconds;
      begin
         Length := Span'Max (1, Set (Who).Budget);
         for Round in 1 .. Max_Rounds loop
            Next := Blocking;
            for I in Set'Range loop
               if Set (I).Priority >= Set (Who).Priority then
                  Next := Next + Demand_Of (Set (I), Length);
               end if;
               pragma Loop_Invariant
                 (Next <= Horizon
                    + Microseconds (I - Set'First + 1) * Most);
            end loop;
            Found := Next <= Length;
            exit when Found or else Next > Horizon;
            Length := Next;
         end loop;
      end Find_Busy;

      procedure Find_Start
        (Demand : Span; Length : out Span; Found : out Boolean)
      is
         Next : Microseconds;
      begin
         Length := Demand;
         for Round in 1 .. Max_Rounds loop
            Next := Demand;
            for I in Set'Range loop
               if I /= Who and then Set (I).Priority >= Set (Who).Priority
               then
                  Next := Next + Queued_Of (Set (I), Length);
               end if;
               pragma Loop_Invariant
                 (Next <= Horizon
                    + Microseconds (I - Set'First + 1) * Most);
            end loop;
            Found := Next = Length;
            exit when Found or else Next > Horizon;
            Length := Next;
         end loop;
      end Find_Start;

      Blocking : constant Span := Longest_Lower;
      Busy     : Span;
      Count    : Microseconds;
      Demand   : Microseconds;
      Wait     : Span;
      Found    : Boolean;
      Begun    : Microseconds;
      Start    : Microseconds := 0;
      Finish   : Microseconds := 0;
      Local    : Span := 0;
   begin
      Result := (others => <>);
      Find_Busy (Busy, Found);
      if not Found then
         return;
      end if;
      Count := Releases (Busy, Item.Jitter, Item.Period);
      if Count not in 1 .. Max_Instances then
         return;
      end if;
      for Before in 0 .. Count - 1 loop
         Demand := Blocking + Before * Item.Budget;
         if Demand > Horizon then
            return;
         end if;
         Find_Start (Demand, Wait, Found);
         if not Found then
            return;
         end if;
         Begun := Wait + Item.Jitter;
         if Begun > Before * Item.Period then
            Start := Microseconds'Max (Start, Begun - Before * Item.Period);
         end if;
         if Begun + Item.Budget > Before * Item.Period then
            Finish := Microseconds'Max
              (Finish, Begun + Item.Budget - Before * Item.Period);
         end if;
         if Start > Horizon or else Finish > Horizon then
            return;
         end if;
         if Before * Item.Period > Item.Jitter then
            Wait := Span'Min (Wait, Start);
         end if;
         if Wait + Item.Budget > Horizon then
            return;
         end if;
         Local := Span'Max (Local, Wait + Item.Budget);
         pragma Loop_Invariant (Start <= Horizon and then Finish <= Horizon);
      end loop;
      Result := (Exists => True,
                 Start  => Start,
                 Finish => Finish,
                 Local  => Local);
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
