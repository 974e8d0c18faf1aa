--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong with an answer on request.

with Answer_Faults;    use Answer_Faults;
with Robot_Core;       use Robot_Core;
with Unit_Runs; use Unit_Runs;

procedure Answer_Faults_Tests is

   use type Octet;

   CR : constant Octet := 16#0D#;

   Ack : constant Answer :=
     (Length => 3, Data => (16#4F#, 16#4F#, CR, others => 0));

   Version : constant Answer :=
     (Length => 5,
      Data   => (16#33#, 16#2E#, 16#35#, 16#28#, CR, others => 0));

   Nothing : constant Answer := (others => <>);

   type Answers is array (Positive range <>) of Answer;
   type Intervals is array (Positive range <>) of Interval;
   type Effects is array (Positive range <>) of Effect_Kind;

   P      : Plan;
   Wire   : Wire_Bytes;
   Effect : Effect_Kind;

   function Sent return Octets is (Wire.Data (1 .. Wire.Length));

   function Is_Good_Frame (Data : Octets) return Boolean is
   begin
      for K in Data'Range loop
         if Data (K) = CR then
            return K >= 3 and then Data (K - 1) = Checksum (Data (1 .. K - 2));
         end if;
      end loop;
      return False;
   end Is_Good_Frame;

   procedure Ask
     (Expected : Effect_Kind;
      What     : String := "an answer";
      Reply    : Answer := Ack)
   is
      --  Reply to a ping. What is sent is checked as far as the contract
      --  leaves it open
   begin
      Apply (P, Ping, Reply, Wire, Effect);
      Assert (Effect = Expected, What & ": " & Effect'Image);
      if Effect = None then
         Assert (Sent = Reply.Data (1 .. Reply.Length), What & " is changed");
      elsif Effect in Corrupt | Garbage | Flipped then
         Assert (not Is_Good_Frame (Sent), What & " is a good frame");
      end if;
   end Ask;

   procedure Expect_Cut (Length : Positive; Reply : Answer := Version) is
      --  The answer's first bytes
   begin
      Ask (Truncated, Reply => Reply);
      Assert (Sent = Reply.Data (1 .. Length), "not cut after" & Length'Image);
   end Expect_Cut;

   procedure Test_Endless is
      Byte  : Octet;
      Count : Natural := 0;
   begin
      P := (Endless => True, Drop => 1, others => <>);
      for K in 1 .. 3 loop
         Ask (Endless);
         Assert (Sent = Ack.Data (1 .. 2), "cut");
      end loop;
      Assert (P.Drop = 1, "used up");
      for K in 1 .. 10_000 loop
         Babble (P, Byte);
         Count := Count + Natural (Byte / 128);
      end loop;
      Assert (Count in 4_000 .. 6_000, "not at random");
   end Test_Endless;

   procedure Test_Every is
   begin
      for Every of Intervals'(2, 3, 10, 1_000) loop
         P := (Every => Every, others => <>);
         for K in 1 .. 3_000 loop
            if K mod 7 = 0 then
               Ask (None, "what is no answer", Nothing);
            end if;
            Ask ((if K mod Every = 0 then Dropped else None), K'Image);
         end loop;
      end loop;

      --  Answers with another fault count, and use it only in their turn

      P := (Every => 3, Drop => 1, Corrupt => 3, others => <>);
      for Effect of Effects'(Dropped, Corrupt, Dropped, Corrupt, Corrupt,
                             Dropped, None, None, Dropped)
      loop
         Ask (Effect, "other faults");
      end loop;
   end Test_Every;

   procedure Test_Flip is
   begin
      for Reply of Answers'(Ack, Version) loop
         P := (Flip => 8 * Reply.Length + 1, others => <>);
         for Bit in 0 .. 8 * Reply.Length - 1 loop
            Assert (P.Bit = Bit, "not each bit in its turn");
            Ask (Flipped, Bit'Image, Reply);
         end loop;

         --  Then from the first one again

         Ask (Flipped, "again", Reply);
         Assert (Sent (1) = (Reply.Data (1) xor 1), "again");
         Ask (None, "over", Reply);
      end loop;

      P := (Flip => 1, Bit => 23, others => <>);
      Ask (Flipped);
      Assert (P.Bit = 24, "a chosen bit");
      P := (Flip => 1, Bit => Bit_Number'Last, others => <>);
      Ask (Flipped);
      Assert (P.Bit = 0, "the last of all");
   end Test_Flip;

   procedure Test_Garbage is
      Ended : Natural := 0;
   begin
      P := (Garbage => 10_000, others => <>);
      for K in 1 .. 10_000 loop
         Ask (Garbage);
         if Wire.Data (Wire.Length) = CR then
            Ended := Ended + 1;
         end if;
      end loop;
      Assert (Ended in 1_001 .. 8_999, "one kind only");
      Ask (None);
   end Test_Garbage;

   procedure Test_Lost_Command is
      Lost : Boolean;
   begin
      P := (Lose => 2, others => <>);
      for K in 1 .. 5 loop
         Take_Command (P, Lost);
         Assert (Lost = (K <= 2), "the next 2:" & K'Image);
      end loop;
      for Every of Intervals'(2, 3, 1_000) loop
         P := (Lose_Every => Every, Every => 2, others => <>);
         for K in 1 .. 3_000 loop
            Take_Command (P, Lost);
            Assert (Lost = (K mod Every = 0), "every:" & K'Image);
            Ask ((if K mod 2 = 0 then Dropped else None), "answers as well");
         end loop;
      end loop;
   end Test_Lost_Command;

   procedure Test_One_By_One is
      Close : constant Answer :=
        (Length => 3, Data => (16#0C#, 16#0C#, CR, others => 0));
   begin
      P := (others => <>);
      Ask (None);
      P := (Silent => True, Drop => 1, others => <>);
      for K in 1 .. 10 loop
         Ask (Silent);
      end loop;
      Assert (P.Drop = 1, "silence uses up nothing");
      P := (Truncate => 4, Keep => 1, others => <>);
      Expect_Cut (1);
      P.Keep := 4;
      Expect_Cut (4);
      Expect_Cut (2, Ack);  --  never the whole answer
      P.Keep := 0;
      Expect_Cut (2, Ack);

      --  The wrong checksum does not end the frame: 0x0C is near 0x0D

      P := (Corrupt => 2, others => <>);
      Ask (Corrupt);
      Assert (Wire.Data (3) = CR, "it has no end");
      Ask (Corrupt, Reply => Close);
      Assert (Wire.Data (2) not in 16#0C# | CR, "the end comes too early");

      --  Several at once; what is no answer uses up none

      P := (Drop => 3, Garbage => 1, Truncate => 1, Corrupt => 1,
            others => <>);
      for K in 1 .. 5 loop
         Ask (None, "what is no answer", Nothing);
      end loop;
      for Effect of Effects'(Dropped, Dropped, Dropped, Garbage, Truncated,
                             Corrupt, None)
      loop
         Ask (Effect, "in order");
      end loop;
   end Test_One_By_One;

   procedure Test_Pile is
      Longest : constant Answer := (Length => 8, Data => (others => 65));
   begin
      P := (Pile => 3, others => <>);
      Ask (Held);
      Ask (Held, Reply => Version);
      Ask (Together);
      Assert (Sent = Ack.Data (1 .. 3) & Version.Data (1 .. 5)
                     & Ack.Data (1 .. 3), "together, in order");
      Ask (None);

      --  One that is called off early, and one of a single answer

      P := (Pile => 3, others => <>);
      Ask (Held);
      P.Pile := 0;
      Ask (Together);
      Assert (Sent'Length = 6, "called off");
      P := (Pile => 1, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Sent = Ack.Data (1 .. 3), "alone");

      --  Of one that is too high the newest are left, from the one on for
      --  which there was no room

      P := (Pile => Max_Pile, others => <>);
      for K in 1 .. Max_Pile + 3 loop
         if K = Max_Pile then
            P.Pile := 5;
         end if;
         Ask (Held, Reply => Longest);
      end loop;
      Ask (Together, Reply => Longest);
      Assert (Sent'Length = 8 * 4, "too high");
   end Test_Pile;

   procedure Test_Wrong_Kind is

      procedure Expect (To : Command_Kind; Texts : String) is
         --  In turn, their first characters
      begin
         P := (Wrong => 2 * Texts'Length, others => <>);
         for C of String'(Texts & Texts) loop
            Apply (P, To, Ack, Wire, Effect);
            Assert (Effect = Wrong_Kind and then Sent (1) = Character'Pos (C),
                    To'Image & " " & C & ": " & Effect'Image);
         end loop;
         Ask (None);
      end Expect;
   begin
      Expect (Get_Battery, "O30");
      Expect (Get_Busy, "O32");
      Expect (Get_Version, "O1");
      Expect (Ping, "13");
      Expect (Move, "13");
      Expect (Unknown, "13");
   end Test_Wrong_Kind;

begin
   Run_Test ("drop every", Test_Every'Access);
   Run_Test ("lost commands", Test_Lost_Command'Access);
   Run_Test ("silent, dropped, cut, corrupt, several",
             Test_One_By_One'Access);
   Run_Test ("garbage", Test_Garbage'Access);
   Run_Test ("every bit flipped", Test_Flip'Access);
   Run_Test ("wrong kind", Test_Wrong_Kind'Access);
   Run_Test ("piled up", Test_Pile'Access);
   Run_Test ("endless", Test_Endless'Access);
end Answer_Faults_Tests;
