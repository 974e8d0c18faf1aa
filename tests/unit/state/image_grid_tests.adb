--  SPDX-License-Identifier: GPL-3.0-or-later
--  When images are sent: sources of many rates, with jitter and drift.

with Ada.Containers.Vectors;
with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Real_Time;             use Ada.Real_Time;

with Vision.Frames;             use Vision.Frames;
with Vision.Image_Grid;         use Vision.Image_Grid;
with Unit_Runs; use Unit_Runs;

procedure Image_Grid_Tests is

   package Times is new Ada.Containers.Vectors (Positive, Long_Float);
   package Sorting is new Times.Generic_Sorting;

   Period : constant Period_Time := 100_000;

   --  What follows is in milliseconds

   Length : constant Long_Float := 60_000.0;
   --  Of a run

   Settled : constant Long_Float := 3_000.0;
   --  The grid lies where it is to be

   type Source is record
      First_Rate : Long_Float;
      Last_Rate  : Long_Float;
      --  a second; in between, as of a clock that drifts
      Jitter     : Long_Float := 0.0;
      --  each image comes up to so much earlier or later
   end record;

   function Even (Rate : Long_Float; Jitter : Long_Float := 0.0)
     return Source is (Rate, Rate, Jitter);

   type Figures is record
      Sent      : Natural := 0;
      Left_Out  : Natural := 0;     --  images that came and were not sent
      Mean_Rate : Long_Float := 0.0;
      Off_99    : Long_Float := 0.0;
      --  99 of 100 intervals are not further from the mean one
      Oldest    : Long_Float := 0.0;
   end record;

   Phases : constant array (1 .. 7) of Long_Float :=
     (0.0, 0.3, 1.0, 20.0, 50.0, 70.0, 99.0);

   function Image (F : Figures) return String is
     (F.Mean_Rate'Image & " a second, off by" & F.Off_99'Image & ", oldest"
      & F.Oldest'Image & "," & F.Sent'Image & " sent," & F.Left_Out'Image
      & " left out");

   procedure Run (From : Source; Phase : Long_Float; Result : out Figures) is
      --  Sends what From delivers, which begins Phase after the grid, as
      --  th_captureImg does, a task that wakes up to 1 ms late

      type Arrival is record
         Since  : Long_Float := 0.0;
         Number : Natural    := 0;
      end record;

      Random  : Generator;
      In_Slot : array (Vision.Slot) of Arrival;
      Begun   : constant Time := Clock;
      Nominal : Long_Float := Phase;
      Coming  : Arrival := (-1_000.0, 0);
      Sent    : Arrival;
      Grid    : Vision.Image_Grid.State := Initial;
      Next    : Long_Float := 0.0;
      Now     : Long_Float;
      Slot    : Vision.Slot;
      Found   : Boolean;
      Ignored : Boolean;
      Reserve : Boolean;
      Came    : Time;
      Step    : Vision.Image_Grid.Microseconds;
      First   : Long_Float := 0.0;
      Last    : Long_Float := 0.0;
      Between : Times.Vector;

      function Chance return Long_Float is
        (Long_Float (Float'(Ada.Numerics.Float_Random.Random (Random))));

      function To_Time (Since : Long_Float) return Time is
        (Begun + Ada.Real_Time.Microseconds (Integer (1_000.0 * Since)));

      procedure Prepare is
         --  When the next image is to come
      begin
         Coming :=
           (Since  => Long_Float'Max
              (Coming.Since + 0.1,
               Nominal + From.Jitter * (2.0 * Chance - 1.0)),
            Number => Coming.Number + 1);
         Nominal := Nominal + 1_000.0
           / (From.First_Rate
              + (From.Last_Rate - From.First_Rate) * Nominal / Length);
      end Prepare;

      procedure Come is
         --  It comes
      begin
         Store.Claim_Empty (Slot);
         In_Slot (Slot) := Coming;
         Publish (Slot, To_Time (Coming.Since));
         Prepare;
      end Come;

      procedure Claim is
         --  What is to be sent
      begin
         Store.Claim_Due
           (To_Time (Now), Period, Slot, Came, Reserve, Found, Ignored);
      end Claim;

   begin
      Reset (Random, 7);
      Result := (others => <>);
      Store.Begin_Delivery (Begun);
      Prepare;
      loop
         Now := Next + Chance;
         while Coming.Since <= Now loop
            Come;
         end loop;
         Claim;
         if not Found then
            Now := Coming.Since;
            Wait_Ended (Grid, Elapsed (To_Time (Next), To_Time (Now)), Period);
            Next := Now;
            Come;
            Claim;
         end if;
         Assert (Found, "an image");
         exit when Now > Length;
         Assert (In_Slot (Slot).Number > Sent.Number, "sent twice");
         if Now > Settled then
            if Result.Sent = 0 then
               First := Now;
            else
               Between.Append (Now - Last);
               Result.Left_Out := Result.Left_Out
                 + In_Slot (Slot).Number - Sent.Number - 1;
            end if;
            Result.Sent := Result.Sent + 1;
            Result.Oldest :=
              Long_Float'Max (Result.Oldest, Now - In_Slot (Slot).Since);
            Last := Now;
         end if;
         Sent := In_Slot (Slot);
         Vision.Image_Grid.Step
           (Grid, Elapsed (Came, To_Time (Now)), Reserve, Period, Step);
         Next := Next + Long_Float (Step) / 1_000.0;
         Store.Release (Slot);
      end loop;
      Store.Release (Slot);
      Result.Mean_Rate :=
        1_000.0 * Long_Float (Result.Sent - 1) / (Last - First);
      for Item of Between loop
         Item := abs (Item - 1_000.0 / Result.Mean_Rate);
      end loop;
      Sorting.Sort (Between);
      Result.Off_99 :=
        Between (Positive (0.99 * Long_Float (Between.Last_Index)));
   end Run;

   type Rates is array (Positive range <>) of Long_Float;

   procedure Check
     (From     : Source;
      Mean     : Long_Float;
      Within   : Long_Float;
      Off_99   : Long_Float := Long_Float'Last;
      Oldest   : Long_Float := Long_Float'Last;
      Left_Out : Natural    := Natural'Last)
   is
      --  Its mean rate, and at most the other figures, in each phase
      Result : Figures;
   begin
      for Phase of Phases loop
         Run (From, Phase, Result);
         Assert (abs (Result.Mean_Rate - Mean) < Within
                 and then Result.Off_99 < Off_99
                 and then Result.Oldest < Oldest
                 and then Result.Left_Out <= Left_Out,
                 From.First_Rate'Image & " a second, jitter"
                 & From.Jitter'Image & ", phase" & Phase'Image & ":"
                 & Image (Result));
      end loop;
   end Check;

   procedure Test_Fast is
   begin
      for Rate of Rates'(10.0, 10.001, 10.1, 10.3, 10.7, 11.0, 12.0, 15.0,
                         25.0, 29.97, 30.0, 60.0)
      loop
         Check (Even (Rate), 10.0, 0.02, 12.0,
                1_000.0 / Rate + (if Rate > 20.0 then 2.0 else 14.0));
      end loop;
   end Test_Fast;

   procedure Test_Slow is
   begin
      for Rate of Rates'(1.0, 5.0, 7.5, 9.0, 9.9, 9.99) loop
         Check (Even (Rate), Rate, 0.002 * Rate, 2.0, 2.0, Left_Out => 0);
      end loop;
   end Test_Slow;

   procedure Test_Jitter is
      Jitter : constant := 30.0;
   begin
      for Rate of Rates'(5.0, 7.5, 9.9, 10.0, 10.1, 12.0, 15.0, 25.0, 29.97,
                         30.0, 60.0)
      loop
         Check (Even (Rate, Jitter),
                Mean     => Long_Float'Min (10.0, Rate),
                Within   => 0.005 * Long_Float'Min (10.0, Rate),
                Off_99   => (if Rate < 10.0 then Long_Float'Last else 20.0),
                Oldest   => 1_000.0 / Rate + 2.0 * Jitter + 14.0,
                Left_Out => (if Rate > 10.0 then Natural'Last else 0));
      end loop;
   end Test_Jitter;

   procedure Test_Drift is
   begin
      Check ((10.05, 9.95, 0.0), 9.9875, 0.02, Off_99 => 5.0);
      Check ((9.95, 10.05, 5.0), 9.9875, 0.02, Off_99 => 12.0);
   end Test_Drift;

   procedure Test_Step is
      Grid : Vision.Image_Grid.State := Initial;

      procedure Expect
        (Age, Length : Vision.Image_Grid.Microseconds;
         What        : String;
         Has_Reserve : Boolean := False)
      is
         Found : Vision.Image_Grid.Microseconds;
      begin
         Step (Grid, Age, Has_Reserve, Period, Found);
         Assert (Found = Length, What & Found'Image);
      end Expect;

   begin
      Wait_Ended (Grid, 15_000, Period);
      Assert (Grid.Lost = 0, "the wait for the first image");
      Expect (0, Period, "nothing is lost");
      Expect (0, Period, "nothing is lost, though there is more", True);
      Wait_Ended (Grid, 15_000, Period);
      Expect (0, Period, "as good as it gets");
      Expect (99_000, 90_000, "a tenth of a period", True);
      Expect (99_000, 95_000, "the rest", True);
      Expect (99_000, Period, "all has been made up for", True);

      Wait_Ended (Grid, Vision.Image_Grid.Microseconds'Last, Period);
      Assert (Grid.Lost = Most_Lost (Period), "so much at most");
      for Image in 1 .. Enough_Early - 1 loop
         Expect (20_000, Period, "may be chance");
      end loop;
      Expect (19_000, Period, "it was");
      for Image in 1 .. Enough_Early - 1 loop
         Expect (20_000, Period, "again, it may be");
      end loop;
      Expect (20_000, 90_000, "it is none");
      Expect (19_000, Period, "that is all");
      Assert (Grid.Lost = Most_Lost (Period) - 10_000,
              "the rest is not forgotten");
   end Test_Step;

begin
   Run_Test ("ten a second from ten or more", Test_Fast'Access);
   Run_Test ("every image of a slower source, as it comes", Test_Slow'Access);
   Run_Test ("jitter of 30 ms", Test_Jitter'Access);
   Run_Test ("a clock that drifts", Test_Drift'Access);
   Run_Test ("a step makes up for little", Test_Step'Access);
end Image_Grid_Tests;
