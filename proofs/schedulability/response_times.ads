--  SPDX-License-Identifier: GPL-3.0-or-later
--  Response-time analysis for fixed priorities: bounds for activities on
--  processors (pre-emptive) and for transactions on a line (they are not).

package Response_Times with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Response_Times);
   --  A claim that GNATprove checks: every subprogram ends

   Horizon : constant := 100_000_000;
   --  In microseconds: what takes longer counts as without a bound

   type Microseconds is range 0 .. 2 ** 62;

   subtype Span is Microseconds range 0 .. Horizon;
   subtype Positive_Span is Span range 1 .. Horizon;

   type Urgency is range 0 .. 255;
   --  A higher number is more urgent

   Max_Activities : constant := 64;
   subtype Activity_Count is Natural range 0 .. Max_Activities;
   subtype Activity_Index is Activity_Count range 1 .. Max_Activities;

   subtype Processor_Number is Positive range 1 .. 16;

   type Activity is record
      Processor : Processor_Number := 1;
      Priority  : Urgency          := 0;
      Period    : Positive_Span    := Horizon;
      --  between two arrivals, at least
      Jitter    : Span := 0;
      --  from an arrival to the release that it leads to, at most; Horizon:
      --  without a bound, and so is all that it delays
      Budget    : Span := 0;
      --  processor time of one release, at most
      Deferral  : Span := 0;
      --  for how long its service may be put off while less urgent ones go
      --  on: it sleeps, or the kernel has not yet woken it
      Blocking  : Span := 0;
      --  by activities of lower priority, at most
      Level     : Urgency := Urgency'Last;
      --  where lower than Priority: it shares a lock that knows no ceiling
      --  with one of this priority, and waits while others delay that one
   end record;

   type Activity_Array is array (Activity_Index range <>) of Activity;

   type Bound is record
      Exists : Boolean := False;
      Start  : Span    := 0;
      --  from the arrival to the first moment of the service; for
      --  transactions only
      Finish : Span    := 0;
      --  from the arrival to the end
      Local  : Span    := 0;
      --  from the release to the end
   end record;
   --  All 0 where none exists within the Horizon

   subtype Lateness is Microseconds range 0 .. 2 * Horizon;

   function Releases
     (Window : Span; Late : Lateness; Period : Positive_Span)
      return Microseconds
   is ((Window + Late + Period - 1) / Period)
   with Post => Releases'Result <= 4 * Horizon;
   --  How many releases fall into a window of this length, at most

   function Interferes
     (Set : Activity_Array; Who : Activity_Index; Other : Activity_Index)
      return Boolean
   is (Other /= Who
       and then Set (Other).Processor = Set (Who).Processor
       and then Set (Other).Priority >=
         Urgency'Min (Set (Who).Priority, Set (Who).Level))
   with Pre => Who in Set'Range and then Other in Set'Range;
   --  Other may run while Who waits. Equal priorities count as higher, so
   --  that the bound holds for every order of arrival

   function Interference
     (Set : Activity_Array; Who : Activity_Index; Window : Span)
      return Microseconds
   with
     Pre  => Who in Set'Range,
     Post => Interference'Result <= Set'Length * (4 * Horizon * Horizon);
   --  Processor time that others take from Who in a window, at most

   procedure Find_Window
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Demand : Span;
      Window : out Span;
      Found  : out Boolean)
   with
     Pre  => Who in Set'Range,
     Post => (if Found
              then Window = Demand + Interference (Set, Who, Window));
   --  The time in which Who is given Demand beside the interference: a
   --  fixed point of the recurrence. Not found beyond the Horizon

   procedure Pre_Emptive_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   with Pre => Who in Set'Range;
   --  Every release of the busy period is examined, so that a response may
   --  be longer than the period

   procedure Transaction_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   with Pre => Who in Set'Range;
   --  The same where nothing is interrupted: the activities are the clients
   --  of one line, Budget the length of a transaction. Processor, Deferral,
   --  Level and Blocking do not count: blocking is the longest transaction
   --  of the less urgent

   Max_Operations : constant := 32;
   subtype Operation_Index is Positive range 1 .. Max_Operations;

   type Ceiling_Array is array (Operation_Index range <>) of Urgency;

   type Section_Array is
     array (Activity_Index range <>, Operation_Index range <>) of Span;
   --  How long an activity is in an operation of a protected object; 0
   --  where it does not call it

   function Least_Ceilings
     (Set : Activity_Array; Sections : Section_Array) return Ceiling_Array
   with
     Pre  => Set'Length > 0
       and then Sections'Length (2) > 0
       and then Sections'First (1) = Set'First
       and then Sections'Last (1) = Set'Last,
     Post => Least_Ceilings'Result'First = Sections'First (2)
       and then Least_Ceilings'Result'Last = Sections'Last (2)
       and then
         (for all O in Least_Ceilings'Result'Range =>
            (for all A in Set'Range =>
               (if Sections (A, O) > 0
                then Least_Ceilings'Result (O) >= Set (A).Priority)));
   --  The highest priority among the callers

   function Ceiling_Blocking
     (Set      : Activity_Array;
      Sections : Section_Array;
      Ceilings : Ceiling_Array;
      Who      : Activity_Index) return Span
   with
     Pre  => Who in Set'Range
       and then Sections'First (1) = Set'First
       and then Sections'Last (1) = Set'Last
       and then Sections'First (2) = Ceilings'First
       and then Sections'Last (2) = Ceilings'Last,
     Post =>
       (for all A in Set'Range =>
          (for all O in Ceilings'Range =>
             (if Set (A).Processor = Set (Who).Processor
                and then Set (A).Priority < Set (Who).Priority
                and then Ceilings (O) >= Set (Who).Priority
              then Ceiling_Blocking'Result >= Sections (A, O))));
   --  The longest section of a less urgent activity on the same processor
   --  in an object whose ceiling is no lower than Who. Under the ceiling
   --  protocol one such section at most is met

end Response_Times;
