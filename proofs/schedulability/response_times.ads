--  SPDX-License-Identifier: GPL-3.0-or-later
--  Response-time analysis for fixed priorities: bounds for activities on
--  processors (pre-emptive) and for transactions on a line (they are not).

package Response_Times with SPARK_Mode, Pure is

   pragma Assertion_Policy
     (Ghost => Ignore, Post => Ignore, Subprogram_Variant => Ignore);
   --  Proved; to check at run time too takes minutes, and of the variants
   --  GNAT 12 cannot compile it

   pragma Annotate (GNATprove, Terminating, Response_Times);
   --  A claim that GNATprove checks: every subprogram ends

   Horizon : constant := 100_000_000;
   --  In microseconds: what takes longer counts as without a bound

   Max_Releases : constant := 1_000;
   --  of one activity in one busy period; with more it has no bound

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
      Suspension : Span := 0;
      --  for how long one release sleeps before it is done, at most, with
      --  what may go before it when it wakes
      Deferral  : Span := 0;
      --  for how long its service may be put off while less urgent ones go
      --  on, as seen by others: the kernel has not yet woken it, or it
      --  sleeps (Put_Off). Horizon: without a bound
      Tail      : Span := 0;
      --  what one release may do besides in any window, at most: where the
      --  next comes a Period after a moment within it, what follows that
      Blocking  : Span := 0;
      --  by activities of lower priority and the kernel, at most, once in a
      --  busy period
   end record;

   type Activity_Array is array (Activity_Index range <>) of Activity;

   subtype Release_Count is Microseconds range 0 .. Max_Releases;

   type Bound is record
      Exists : Boolean := False;
      Start  : Span    := 0;
      --  from the arrival to the first moment of the service; for
      --  transactions only
      Finish : Span    := 0;
      --  from the arrival to the end
      Local  : Span    := 0;
      --  from the release to the end
      Releases : Release_Count := 0;
      --  in the busy period that it was found for
   end record;
   --  All 0 where none exists within the Horizon

   function Put_Off (Item : Activity; Own : Bound) return Span is
     (if Item.Suspension = 0 then Item.Deferral
      elsif not Own.Exists then Horizon
      else Span'Max (Own.Local, Item.Budget) - Item.Budget);
   --  The Deferral of an activity with this bound of its own. One that
   --  sleeps before it is done may have all of its work left when its time
   --  is nearly over, and the next release follows (Chen and others 2019)

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
       and then Set (Other).Priority >= Set (Who).Priority)
   with Pre => Who in Set'Range and then Other in Set'Range;
   --  Other may run while Who waits. Equal priorities count as higher, so
   --  that the bound holds for every order of arrival

   Most : constant := 4 * Horizon * Horizon + Horizon;
   --  of the demand of one activity in a window

   function Demand_Of (Item : Activity; Window : Span) return Microseconds is
     (if Item.Budget = 0 then 0
      elsif Item.Jitter = Horizon or else Item.Deferral = Horizon
      then Horizon + 1
      else Releases (Window, Item.Jitter + Item.Deferral, Item.Period)
        * Item.Budget + Item.Tail)
   with Post => Demand_Of'Result <= Most;

   function Interference_To
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Window : Span;
      Last   : Activity_Count) return Microseconds
   is (if Last < Set'First then 0
       else Interference_To (Set, Who, Window, Last - 1)
         + (if Interferes (Set, Who, Last)
            then Demand_Of (Set (Last), Window) else 0))
   with
     Ghost,
     Subprogram_Variant => (Decreases => Last),
     Pre  => Who in Set'Range and then Last in Set'First - 1 .. Set'Last,
     Post => Interference_To'Result
       <= Microseconds (Last - Set'First + 1) * Most;

   function Interference
     (Set : Activity_Array; Who : Activity_Index; Window : Span)
      return Microseconds
   with
     Pre  => Who in Set'Range,
     Post => Interference'Result
       = Interference_To (Set, Who, Window, Set'Last);
   --  Processor time that others take from Who in a window, at most

   type Window_Bound is record
      Found  : Boolean := False;
      Length : Span    := 0;
   end record;
   --  Not found where it is longer than the Horizon

   subtype Release_Index is Release_Count range 0 .. Max_Releases - 1;

   function Own_Demand
     (Item : Activity; Before : Release_Index) return Microseconds
   is (Item.Blocking + (Before + 1) * (Item.Budget + Item.Suspension))
   with Post => Own_Demand'Result <= (2 * Max_Releases + 1) * Horizon;
   --  Of a release and so many Before it: it sleeps in each

   function Window_Of
     (Set : Activity_Array; Who : Activity_Index; Before : Release_Index)
      return Window_Bound
   with
     Pre  => Who in Set'Range,
     Post =>
       (if Window_Of'Result.Found
        then Window_Of'Result.Length = Own_Demand (Set (Who), Before)
          + Interference (Set, Who, Window_Of'Result.Length));
   --  From the beginning of the busy period to the end of a release with so
   --  many Before it: a fixed point of the recurrence, and none of them is
   --  below that end

   function From_Arrival
     (Item : Activity; Window : Span; Before : Release_Index)
      return Lateness
   is (Microseconds'Max (Window + Item.Jitter, Before * Item.Period)
       - Before * Item.Period);
   --  From the arrival of that release to its end, at most

   function From_Release
     (Item : Activity; Window : Span; Before : Release_Index)
      return Lateness
   is (if Before * Item.Period <= Item.Jitter then Window
       else From_Arrival (Item, Window, Before));
   --  Where so many arrive within the jitter it may have been released with
   --  the first

   function Is_Covered
     (Item   : Activity;
      Window : Window_Bound;
      Before : Release_Index;
      Finish : Span;
      Local  : Span) return Boolean
   is (Window.Found
       and then Finish >= From_Arrival (Item, Window.Length, Before)
       and then Local >= From_Release (Item, Window.Length, Before))
   with Ghost;

   function Is_Last
     (Item : Activity; Window : Window_Bound; Before : Release_Index)
      return Boolean
   is (Window.Length + Item.Jitter <= (Before + 1) * Item.Period);
   --  It is done before the next one comes: the busy period is over

   procedure Pre_Emptive_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   with
     Pre  => Who in Set'Range,
     Post =>
       (if Result.Exists
        then Result.Releases > 0
          and then Is_Last
            (Set (Who), Window_Of (Set, Who, Result.Releases - 1),
             Result.Releases - 1)
          and then
            (for all Before in 0 .. Result.Releases - 1 =>
               Is_Covered
                 (Set (Who), Window_Of (Set, Who, Before), Before,
                  Result.Finish, Result.Local)));
   --  Every release of the busy period is examined, so that a response may
   --  be longer than the period

   --  The same where nothing is interrupted: the activities are the clients
   --  of one line, Budget the length of a transaction. Processor, Suspension,
   --  Deferral and Blocking do not count: blocking is the longest
   --  transaction of the less urgent

   function Carried_Of (Item : Activity; Window : Span) return Microseconds
   is
     (if Item.Budget = 0 then 0
      elsif Item.Jitter = Horizon then Horizon + 1
      else Releases (Window, Item.Jitter, Item.Period) * Item.Budget)
   with Post => Carried_Of'Result <= Most;

   function Queued_Of (Item : Activity; Window : Span) return Microseconds is
     (if Item.Budget = 0 then 0
      elsif Item.Jitter = Horizon then Horizon + 1
      else ((Window + Item.Jitter) / Item.Period + 1) * Item.Budget)
   with Post => Queued_Of'Result <= Most;
   --  An arrival at the very end of the window goes before a transaction
   --  that has not begun

   function Carried_To
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Window : Span;
      Last   : Activity_Count) return Microseconds
   is (if Last < Set'First then 0
       else Carried_To (Set, Who, Window, Last - 1)
         + (if Set (Last).Priority >= Set (Who).Priority
            then Carried_Of (Set (Last), Window) else 0))
   with
     Ghost,
     Subprogram_Variant => (Decreases => Last),
     Pre  => Who in Set'Range and then Last in Set'First - 1 .. Set'Last,
     Post => Carried_To'Result
       <= Microseconds (Last - Set'First + 1) * Most;

   function Queued_To
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Window : Span;
      Last   : Activity_Count) return Microseconds
   is (if Last < Set'First then 0
       else Queued_To (Set, Who, Window, Last - 1)
         + (if Last /= Who and then Set (Last).Priority >= Set (Who).Priority
            then Queued_Of (Set (Last), Window) else 0))
   with
     Ghost,
     Subprogram_Variant => (Decreases => Last),
     Pre  => Who in Set'Range and then Last in Set'First - 1 .. Set'Last,
     Post => Queued_To'Result
       <= Microseconds (Last - Set'First + 1) * Most;

   function Longest_Lower
     (Set : Activity_Array; Who : Activity_Index) return Span
   with
     Pre  => Who in Set'Range,
     Post =>
       (for all Item of Set =>
          (if Item.Priority < Set (Who).Priority
           then Longest_Lower'Result >= Item.Budget));
   --  The transaction that has just begun

   function Busy_Period
     (Set : Activity_Array; Who : Activity_Index) return Window_Bound
   with
     Pre  => Who in Set'Range,
     Post =>
       (if Busy_Period'Result.Found
        then Busy_Period'Result.Length >= Longest_Lower (Set, Who)
          + Carried_To (Set, Who, Busy_Period'Result.Length, Set'Last));
   --  The longest time without rest for Who and the more urgent ones

   function Wait_Of
     (Set : Activity_Array; Who : Activity_Index; Before : Release_Index)
      return Window_Bound
   with
     Pre  => Who in Set'Range,
     Post =>
       (if Wait_Of'Result.Found
        then Wait_Of'Result.Length
          = Longest_Lower (Set, Who) + Before * Set (Who).Budget
            + Queued_To (Set, Who, Wait_Of'Result.Length, Set'Last));
   --  From the beginning of the busy period to when a transaction with so
   --  many Before it may begin

   function Is_Carried
     (Item   : Activity;
      Wait   : Window_Bound;
      Before : Release_Index;
      Start  : Span;
      Finish : Span;
      Local  : Span) return Boolean
   is (Wait.Found
       and then Wait.Length + Item.Budget <= Horizon
       and then Start >= From_Arrival (Item, Wait.Length, Before)
       and then Finish
         >= From_Arrival (Item, Wait.Length + Item.Budget, Before)
       and then Local
         >= From_Release (Item, Wait.Length + Item.Budget, Before))
   with Ghost;

   procedure Transaction_Bound
     (Set    : Activity_Array;
      Who    : Activity_Index;
      Result : out Bound)
   with
     Pre  => Who in Set'Range,
     Post =>
       (if Result.Exists
        then Busy_Period (Set, Who).Found
          and then Result.Releases > 0
          and then Result.Releases = Releases
            (Busy_Period (Set, Who).Length, Set (Who).Jitter,
             Set (Who).Period)
          and then
            (for all Before in 0 .. Result.Releases - 1 =>
               Is_Carried
                 (Set (Who), Wait_Of (Set, Who, Before), Before,
                  Result.Start, Result.Finish, Result.Local)));

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
