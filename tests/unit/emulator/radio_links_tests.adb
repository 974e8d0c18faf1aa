--  SPDX-License-Identifier: GPL-3.0-or-later
--  Packets, delays and losses of a pair of radios.

with Radio_Links;      use Radio_Links;
with Samples;
with Unit_Runs;        use Unit_Runs;

procedure Radio_Links_Tests is

   Each : constant Byte_Time := 1_041_666;
   --  At 9600 baud

   Ms   : constant := 1_000_000;

   Exchanges : constant := 10_000;

   procedure Exchange
     (There, Back : in out Link;
      C           : Chances;
      Length      : Positive;
      Clock       : in out Time;
      Took        : out Time;
      Lost        : out Boolean)
   is
      --  A command of Length bytes begins at Clock; its answer has three, and
      --  the robot needs no time. Took: from the end of the command. Clock:
      --  what came last is over.
      Ended : constant Time := Clock + Time (Length) * Each;

      procedure Carry (L : in out Link; Bytes : Positive) is
         --  From Clock on; then Clock is the end of the second wire
         Arrival : Time;
      begin
         for K in 1 .. Bytes loop
            Clock := Clock + Each;
            Assert (Joins (L, Clock, Each), "two packets");
            Gather (L, Clock);
         end loop;
         Send (L, C, Closing (L, Each), Arrival, Lost);
         Clock := Arrival + Time (Bytes) * Each;
      end Carry;

   begin
      Carry (There, Length);
      if not Lost then
         Carry (Back, 3);
      end if;
      Took := Clock - Ended;
   end Exchange;

   procedure Exchange_All
     (C : Chances; Times : out Samples.Set; Lost : out Natural)
   is
      --  Commands of 3 to 9 bytes in turn, 50 ms apart
      There : Link := (Seed => 2, others => <>);
      Back  : Link := (Seed => 3, others => <>);
      Clock : Time := 0;
      Took  : Time;
      Misses : Boolean;
   begin
      Lost := 0;
      Times := Samples.None;
      for K in 1 .. Exchanges loop
         Exchange (There, Back, C, 3 + 2 * (K mod 4), Clock, Took, Misses);
         Times.Add (Duration (Took) / 1_000_000_000);
         Lost  := Lost + Boolean'Pos (Misses);
         Clock := Clock + 50 * Ms;
      end loop;
   end Exchange_All;

   procedure Test_Bursts is
      --  What is late comes together: independent of each other, one in fifty
      --  would follow another
      There, Back : Link;
      Clock : Time := 0;
      Took  : Time := 0;
      Before : Time;
      Lost  : Boolean;
      Late, Followed : Natural := 0;
   begin
      for K in 1 .. Exchanges loop
         Before := Took;
         Exchange
           (There, Back, (Bursts => 1, others => <>), 3, Clock, Took, Lost);
         Clock := Clock + 50 * Ms;
         Late := Late + Boolean'Pos (Took > 80 * Ms);
         Followed := Followed
           + Boolean'Pos (Took > 80 * Ms and then Before > 80 * Ms);
      end loop;
      Assert (Late in 100 .. 800, "late:" & Late'Image);
      Assert (5 * Followed > Late,
              "together:" & Followed'Image & " of" & Late'Image);
   end Test_Bursts;

   procedure Test_Exchanges is
      All_Of : Samples.Set;
      Lost   : Natural;

      procedure Expect (Value, Low, High : Duration; What : String) is
      begin
         Assert (Value in Low .. High, What & Value'Image);
      end Expect;

   begin
      --  Against the model with the real firmware: 35.6 ms at the median, 68
      --  at p99, 78 to 90 at most; none is faster than its parts

      Exchange_All ((others => <>), All_Of, Lost);
      Assert (Lost = 0, "lost");
      Expect (All_Of.Quantile (0.0), 0.022, 0.038, "shortest");
      Expect (All_Of.Quantile (0.5), 0.033, 0.038, "median");
      Expect (All_Of.Quantile (0.99), 0.063, 0.073, "p99");
      Expect (All_Of.Quantile (1.0), 0.078, 0.110, "longest");

      --  A command or its answer: 1 - 0.97 ** 2 are 5.91 %

      Exchange_All ((Losses => 3, others => <>), All_Of, Lost);
      Assert (Lost in 530 .. 650, "of 3 %:" & Lost'Image);
      Exchange_All ((Losses => 100, others => <>), All_Of, Lost);
      Assert (Lost = Exchanges, "of all:" & Lost'Image);

      --  Of the model: with 10 % retries 80 ms are too short for 2.8 % of all
      --  exchanges, 150 ms for 0.04 %

      Exchange_All ((Retries => 10, others => <>), All_Of, Lost);
      Expect (All_Of.Quantile (0.967), 0.0, 0.080, "3.3 % at most");
      Expect (All_Of.Quantile (0.977), 0.080, 1.0, "2.3 % at least");
      Expect (All_Of.Quantile (0.999), 0.0, 0.150, "0.1 % at most");
      Expect (All_Of.Quantile (1.0), 0.150, 1.0, "some");
      Exchange_All ((Retries => 0, others => <>), All_Of, Lost);
      Expect (All_Of.Quantile (1.0), 0.022, 0.050, "without retries");
   end Test_Exchanges;

   procedure Test_Order is
      --  A packet waits for those before it
      L       : Link;
      Before  : Time := 0;
      Arrival : Time;
      Lost    : Boolean;
   begin
      for K in 1 .. Exchanges loop
         Gather (L, Ms);
         Send (L, (Retries => 50, others => <>), Ms, Arrival, Lost);
         Assert
           (Arrival - Before
            in Shortest_Air .. Longest_Air + Max_Retries * Retry_Time + Ms,
            "overtakes" & K'Image);
         Before := Arrival;
      end loop;
   end Test_Order;

   procedure Test_Packets is
      L       : Link;
      Arrival : Time;
      Lost    : Boolean;
   begin
      Assert (Joins (L, 0, Each), "the first of all");
      Gather (L, 10 * Ms);
      Gather (L, 10 * Ms + 3 * Each);
      Assert (Closing (L, Each) = 10 * Ms + 6 * Each, "silence");
      Assert (Joins (L, 10 * Ms + 6 * Each, Each), "a byte in time");
      Assert (not Joins (L, 10 * Ms + 6 * Each + 1, Each), "a late one");
      Send (L, (Retries => 0, others => <>), Closing (L, Each), Arrival, Lost);
      Assert (L.Length = 0 and then Joins (L, 100 * Ms, Each), "the next");

      for K in 1 .. Max_Packet loop
         Assert (Joins (L, 100 * Ms, Each), "no room for" & K'Image);
         Gather (L, 100 * Ms);
      end loop;
      Assert (not Joins (L, 100 * Ms, Each), "room for one more");
      Assert (Closing (L, Each) = 100 * Ms, "a full packet waits");
   end Test_Packets;

begin
   Run_Test ("packets", Test_Packets'Access);
   Run_Test ("delays, losses, retries", Test_Exchanges'Access);
   Run_Test ("bursts of retries", Test_Bursts'Access);
   Run_Test ("order", Test_Order'Access);
end Radio_Links_Tests;
