--  SPDX-License-Identifier: GPL-3.0-or-later
--  The analysis on published examples whose answers are known.

with Response_Times;   use Response_Times;
with Unit_Runs; use Unit_Runs;

procedure Response_Times_Tests is

   Unbounded : constant := -1;

   type Answer_Array is array (Activity_Index range <>) of Integer;

   function Item
     (Priority : Urgency; Period, Budget : Span; Jitter : Span := 0)
      return Activity
   is ((Priority => Priority, Period => Period, Budget => Budget,
        Jitter => Jitter, others => <>));

   function Sleeper
     (Priority : Urgency; Period, Budget, Suspension : Span) return Activity
   is ((Priority => Priority, Period => Period, Budget => Budget,
        Suspension => Suspension, others => <>));

   procedure Compare
     (Who : Activity_Index; Result : Bound; Answer : Integer) is
   begin
      if Answer = Unbounded then
         Assert (not Result.Exists, "no bound expected of" & Who'Image);
      else
         Assert (Result.Exists and then Result.Finish = Span (Answer),
                 Who'Image & ":" & Result.Finish'Image & " instead of"
                 & Answer'Image);
      end if;
   end Compare;

   procedure Check (Set : Activity_Array; Answers : Answer_Array) is
      --  Pre-emptive responses
      Result : Bound;
   begin
      for I in Set'Range loop
         Pre_Emptive_Bound (Set, I, Result);
         Compare (I, Result, Answers (I));
      end loop;
   end Check;

   procedure Check_Sleepers (Set : Activity_Array; Answers : Answer_Array) is
      --  The same where some sleep: most urgent first, as the bound of one is
      --  needed for the next
      Known  : Activity_Array := Set;
      Result : Bound;
   begin
      for I in Known'Range loop
         Pre_Emptive_Bound (Known, I, Result);
         Compare (I, Result, Answers (I));
         Known (I).Deferral := Put_Off (Known (I), Result);
      end loop;
   end Check_Sleepers;

   procedure Check_Line (Set : Activity_Array; Answers : Answer_Array) is
      --  The same of a line
      Result : Bound;
   begin
      for I in Set'Range loop
         Transaction_Bound (Set, I, Result);
         Compare (I, Result, Answers (I));
      end loop;
   end Check_Line;

   procedure Test_Published is
   begin
      --  C. L. Liu, J. W. Layland, Scheduling Algorithms for Multi-
      --  programming in a Hard-Real-Time Environment, JACM 20 (1973),
      --  section 4: T1 = 2, T2 = 5, C1 = C2 = 1. The shorter period first:
      --  feasible, and C2 can be raised to 2 but no further (3 would be
      --  more than the processor has)
      Check ((Item (2, 2, 1), Item (1, 5, 1)), (1, 2));
      Check ((Item (2, 2, 1), Item (1, 5, 2)), (1, 4));
      Check ((Item (2, 2, 1), Item (1, 5, 3)), (1, Unbounded));
      --  the other way round neither can be raised: here C2 = 2
      Check ((Item (1, 2, 1), Item (2, 5, 1)), (2, 1));
      Check ((Item (1, 2, 1), Item (2, 5, 2)), (3, 2));

      --  A. Burns, A. Wellings, Real-Time Systems and Programming Languages,
      --  the chapter on scheduling: of the utilisation-based test, set A
      --  fails it at 0.82, and task a misses its deadline of 50; B passes at
      --  0.775; C at 1.0, and yet all deadlines are met, the last at 80 of
      --  80. D is worked in the text: 3, 6, and 20 after 5, 11, 14, 17
      Check ((Item (1, 50, 12), Item (2, 40, 10), Item (3, 30, 10)),
             (52, 20, 10));
      Check ((Item (1, 80, 32), Item (2, 40, 5), Item (3, 16, 4)), (58, 9, 4));
      Check ((Item (1, 80, 40), Item (2, 40, 10), Item (3, 20, 5)),
             (80, 15, 5));
      Check ((Item (3, 7, 3), Item (2, 12, 3), Item (1, 20, 5)), (3, 6, 20));

      --  L. Sha, J. B. Goodenough, Real-Time Scheduling Theory and Ada,
      --  IEEE Computer 23 (1990): with C1 = 40 beyond the bound for three
      --  tasks, but the third ends at 300, before its period of 350
      Check ((Item (3, 100, 40), Item (2, 150, 40), Item (1, 350, 100)),
             (40, 80, 300));

      --  J. P. Lehoczky, Fixed Priority Scheduling of Periodic Task Sets
      --  with Arbitrary Deadlines, RTSS 1990: the releases of task 2 take
      --  114, 102, 116, 104, 118, 106, 94; not the first is the worst
      Check ((Item (2, 70, 26), Item (1, 100, 62)), (26, 118));

      --  R. I. Davis, A. Burns, R. J. Bril, J. J. Lukkien, Controller Area
      --  Network (CAN) schedulability analysis: refuted, revisited and
      --  revised, Real-Time Systems 35 (2007): three messages of 1 ms. The
      --  second instance of the third takes 3.5 ms, where the analysis
      --  that they refute gives 3
      Check_Line ((Item (3, 2_500, 1_000), Item (2, 3_500, 1_000),
                   Item (1, 3_500, 1_000)),
                  (2_000, 3_000, 3_500));
   end Test_Published;

   procedure Test_Ceilings is

      procedure Check_Blocking
        (Uses     : Section_Array;
         Ceilings : Ceiling_Array;
         Expected : Answer_Array)
      is
         --  Of activities, the most urgent first
         Set : Activity_Array (Uses'Range (1));
      begin
         for I in Set'Range loop
            Set (I) := Item (Urgency (1 + Set'Last - I), 1, 0);
         end loop;
         Assert (Least_Ceilings (Set, Uses) = Ceilings, "ceilings");
         for I in Set'Range loop
            Assert (Ceiling_Blocking (Set, Uses, Ceilings, I)
                    = Span (Expected (I)), "blocking of" & I'Image);
         end loop;
      end Check_Blocking;

   begin
      --  Burns and Wellings, the exercise on the priority ceiling protocol:
      --  tasks a to e, resources R1 to R6 of 50, 150, 75, 300, 250, 175 ms;
      --  a uses R3, b R1 and R2, c R3, R4 and R5, d R1, R5 and R6, e R2
      --  and R6
      Check_Blocking (((0, 0, 75, 0, 0, 0),
                       (50, 150, 0, 0, 0, 0),
                       (0, 0, 75, 300, 250, 0),
                       (50, 0, 0, 0, 250, 175),
                       (0, 150, 0, 0, 0, 175)),
                      (4, 4, 5, 3, 3, 2), (75, 150, 250, 175, 0));

      --  G. Buttazzo, Hard Real-Time Computing Systems, the chapter on
      --  resource access: four tasks, three semaphores, under the priority
      --  ceiling protocol
      Check_Blocking (((1, 2, 0), (0, 9, 3), (8, 7, 0), (6, 5, 4)),
                      (4, 4, 3), (9, 8, 6, 0));
   end Test_Ceilings;

   procedure Test_Jitter is
      Result : Bound;
   begin
      --  by hand: releases of the first may be 8 apart, so two of them meet
      --  the second: 3 + 2 x 4
      Check ((Item (2, 12, 4, Jitter => 4), Item (1, 30, 5)), (8, 13));
      Check ((Item (2, 12, 4), Item (1, 30, 5)), (4, 9));
      --  two releases at once and the third 2 later: this ends at 12, 10
      --  after its release
      Pre_Emptive_Bound ((1 => Item (1, 10, 4, Jitter => 18)), 1, Result);
      Assert (Result.Finish = 22, Result.Finish'Image);
      Assert (Result.Local = 10, Result.Local'Image);
   end Test_Jitter;

   procedure Test_Blocking is
      Set   : Activity_Array :=
        (Item (3, 7, 3), Item (2, 12, 3), Item (1, 20, 5));
      First : Activity := Item (2, 10, 4);
   begin
      --  the first on another processor
      Set (1).Processor := 2;
      Check (Set, (3, 3, 8));
      Set (1).Processor := 1;

      --  set D of Burns and Wellings with sections of 2 below: 3 + 2, and
      --  3 + 2 + 2 x 3, for the window goes beyond 7
      Set (1).Blocking := 2;
      Set (2).Blocking := 2;
      Check (Set, (5, 11, 20));

      --  by hand: 3 of the release before and a whole one, then 3
      First.Tail := 3;
      Check ((First, Item (1, 50, 3)), (4, 10));
   end Test_Blocking;

   procedure Test_Dynamic_Suspension is
   begin
      --  J.-J. Chen, G. Nelissen, W.-H. Huang, A Unifying Response Time
      --  Analysis Framework for Dynamic Self-Suspending Tasks, ECRTS 2016,
      --  and the review of 2019, example 6: R1 - C1 = 5, R2 - C2 = 9. By
      --  hand: 4 + 5; 6 + 1 + 2 x 4; and 4 + 5 x 4 + 3 x 6, for 42 + 5 is
      --  no more than 5 x 10 and 42 + 9 no more than 3 x 19
      Check_Sleepers ((Sleeper (3, 10, 4, 5), Sleeper (2, 19, 6, 1),
                       Sleeper (1, 50, 4, 0)),
                      (9, 15, 42));
      --  without a bound of its own it leaves the others none
      Check_Sleepers ((Sleeper (2, 10, 4, 7), Sleeper (1, 50, 4, 0)),
                      (Unbounded, Unbounded));
   end Test_Dynamic_Suspension;

   procedure Test_Suspension_As_Jitter is
      Set : Activity_Array :=
        (Sleeper (3, 2, 1, 0), Sleeper (2, 20, 5, 5),
         Sleeper (1, 1_000, 1, 0));
   begin
      --  J.-J. Chen and others, Many Suspensions, Many Problems, Real-Time
      --  Systems 55 (2019), on suspensions taken for jitter of their own
      --  length: that gives 1 + 6 + 5 = 12 for the third. But let the first
      --  run in each even unit of time, and the second, released at 0 and
      --  20, sleep in 1, 3, .. 9, work in 11, 13, .. 19, and then in 21,
      --  23, .. 29. The third, released at 10, runs in 31, and ends 22 later
      Check_Sleepers (Set, (1, 20, 22));
      Set (2).Deferral := Set (2).Suspension;
      Set (2).Suspension := 0;
      Check_Sleepers (Set, (1, 10, 12));
   end Test_Suspension_As_Jitter;

   procedure Test_Own_Suspension is
      Item   : Activity := Sleeper (1, 10, 4, 3);
      Result : Bound;
   begin
      --  by hand: two releases at once and the third 2 later; each works 4
      --  and sleeps 3, so the third ends at 21, 19 after its release
      Item.Jitter := 18;
      Pre_Emptive_Bound ((1 => Item), 1, Result);
      Assert (Result.Finish = 25, Result.Finish'Image);
      Assert (Result.Local = 19, Result.Local'Image);
   end Test_Own_Suspension;

   procedure Test_Overload is
      Result : Bound;
   begin
      Check ((Item (2, 10, 6), Item (1, 20, 9)), (6, Unbounded));
      Transaction_Bound
        (Activity_Array'(Item (2, 10, 6), Item (1, 20, 9)), 2, Result);
      Assert (not Result.Exists, "a line that never rests has no bound");
      --  a full load leaves a bound
      Check ((Item (2, 10, 5), Item (1, 20, 10)), (5, 20));
   end Test_Overload;

   procedure Test_No_Jitter_Known is
      Early : constant Activity := Item (3, 10_000, 1);
      Late  : Activity := Item (2, 10_000, 1, Jitter => Horizon);
      Last  : constant Activity := Item (1, 10_000, 2);
   begin
      Check ((Early, Late, Last), (1, Unbounded, Unbounded));
      Check_Line ((Early, Late, Last), (3, Unbounded, Unbounded));
      Late.Budget := 0;
      Check ((Early, Last, Late), (1, 3, Unbounded));
   end Test_No_Jitter_Known;

begin
   Run_Test ("published examples", Test_Published'Access);
   Run_Test ("Burns and Wellings, ceilings", Test_Ceilings'Access);
   Run_Test ("release jitter", Test_Jitter'Access);
   Run_Test ("blocking, two processors, a tail", Test_Blocking'Access);
   Run_Test ("Chen, Nelissen and Huang 2016, suspensions",
             Test_Dynamic_Suspension'Access);
   Run_Test ("Chen and others 2019, suspensions are no jitter",
             Test_Suspension_As_Jitter'Access);
   Run_Test ("each release of the busy period sleeps",
             Test_Own_Suspension'Access);
   Run_Test ("overload has no bound", Test_Overload'Access);
   Run_Test ("nor has what waits for something without one",
             Test_No_Jitter_Known'Access);
end Response_Times_Tests;
