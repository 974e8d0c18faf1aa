--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong with an answer on request.

with AUnit.Assertions; use AUnit.Assertions;

with Answer_Faults;    use Answer_Faults;
with Robot_Core;       use Robot_Core;
with Unit_Runs; use Unit_Runs;

package body Answer_Faults_Tests is

   use type Octet;

   CR : constant Octet := 16#0D#;

   Ack : constant Answer :=
     (Length => 3, Data => (16#4F#, 16#4F#, CR, others => 0));

   Version : constant Answer :=
     (Length => 5,
      Data   => (16#33#, 16#2E#, 16#35#, 16#28#, CR, others => 0));

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
            return K >= 3
              and then Data (K - 1) = Checksum (Data (1 .. K - 2));
         end if;
      end loop;
      return False;
   end Is_Good_Frame;

   procedure Test_Corrupt is
      Close : constant Answer :=
        (Length => 3, Data => (16#0C#, 16#0C#, CR, others => 0));
   begin
      P := (Corrupt => 2, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Corrupt and then Sent'Length = 3
              and then Wire.Data (3) = CR
              and then not Is_Good_Frame (Sent), "first");

      --  The wrong checksum does not end the frame: 0x0C is near 0x0D

      Apply (P, Ping, Close, Wire, Effect);
      Assert (Effect = Corrupt and then Wire.Data (2) not in 16#0C# | CR,
              "second");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None and then Is_Good_Frame (Sent), "third is good");
   end Test_Corrupt;

   procedure Test_Cut is
   begin
      P := (Truncate => 3, Keep => 1, others => <>);
      Apply (P, Get_Version, Version, Wire, Effect);
      Assert (Effect = Truncated and then Sent = Version.Data (1 .. 1),
              "one byte");
      P.Keep := 4;
      Apply (P, Get_Version, Version, Wire, Effect);
      Assert (Effect = Truncated and then Sent = Version.Data (1 .. 4),
              "four");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Truncated and then Sent = Ack.Data (1 .. 2),
              "never the whole answer");
   end Test_Cut;

   procedure Test_Drop is
   begin
      P := (Drop => 3, others => <>);
      for K in 1 .. 3 loop
         Apply (P, Ping, Ack, Wire, Effect);
         Assert (Effect = Dropped and then Sent'Length = 0, "dropped");
      end loop;
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None and then Sent = Ack.Data (1 .. 3), "sent");
   end Test_Drop;

   procedure Test_Endless is
      Byte  : Octet;
      Count : Natural := 0;
   begin
      P := (Endless => True, Drop => 1, others => <>);
      for K in 1 .. 3 loop
         Apply (P, Ping, Ack, Wire, Effect);
         Assert (Effect = Endless and then Sent = Ack.Data (1 .. 2), "cut");
      end loop;
      Assert (P.Drop = 1, "used up");
      for K in 1 .. 10_000 loop
         Babble (P, Byte);
         Assert (Byte /= CR, "an end");
         if Byte >= 128 then
            Count := Count + 1;
         end if;
      end loop;
      Assert (Count in 4_000 .. 6_000, "not at random");
   end Test_Endless;

   procedure Test_Every is
      Nothing : constant Answer := (others => <>);
   begin
      for Every of Intervals'(2, 3, 10, 1_000) loop
         P := (Every => Every, others => <>);
         for K in 1 .. 3_000 loop
            if K mod 7 = 0 then
               Apply (P, Ping, Nothing, Wire, Effect);
               Assert (Effect = None, "what is no answer is lost");
            end if;
            Apply (P, Ping, Ack, Wire, Effect);
            if K mod Every = 0 then
               Assert (Effect = Dropped and then Sent'Length = 0,
                       "sent:" & K'Image);
            else
               Assert (Effect = None and then Sent = Ack.Data (1 .. 3),
                       "lost:" & K'Image);
            end if;
         end loop;
      end loop;

      --  Answers with another fault count, and use it only in their turn

      P := (Every => 3, Drop => 1, Corrupt => 3, others => <>);
      for Expected of Effects'
        (Dropped, Corrupt, Dropped, Corrupt, Corrupt, Dropped, None, None,
         Dropped)
      loop
         Apply (P, Ping, Ack, Wire, Effect);
         Assert (Effect = Expected, "other faults");
      end loop;
   end Test_Every;

   procedure Test_Flip is
      Other : Natural;
      Value : Octet;
   begin
      for Reply of Answers'(Ack, Version) loop
         P := (Flip => 8 * Reply.Length + 1, others => <>);
         for Bit in 0 .. 8 * Reply.Length - 1 loop
            Apply (P, Ping, Reply, Wire, Effect);
            Assert (Effect = Flipped and then Sent'Length = Reply.Length,
                    "effect");
            Other := 0;
            for K in 1 .. Reply.Length loop
               Value := Sent (K) xor Reply.Data (K);
               if Value /= 0 then
                  Other := Other + 1;
                  Assert (K = 1 + Bit / 8 and then Value = 2 ** (Bit mod 8),
                          "bit" & Bit'Image);
               end if;
            end loop;
            Assert (Other = 1, "one byte is another");
            Assert (not Is_Good_Frame (Sent), "a good frame all the same");
         end loop;

         --  Then from the first one again

         Apply (P, Ping, Reply, Wire, Effect);
         Assert (Effect = Flipped
                 and then Sent (1) = (Reply.Data (1) xor 1), "again");
         Apply (P, Ping, Reply, Wire, Effect);
         Assert (Effect = None and then Is_Good_Frame (Sent), "over");
      end loop;

      P := (Flip => 1, Bit => 23, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Sent (3) = (CR xor 128) and then P.Bit = 24, "a chosen bit");
      P := (Flip => 1, Bit => Bit_Number'Last, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (P.Bit = 0, "the last of all");
   end Test_Flip;

   procedure Test_Garbage is
      Ended, Open : Natural := 0;
   begin
      P := (Garbage => 10_000, others => <>);
      for K in 1 .. 10_000 loop
         Apply (P, Ping, Ack, Wire, Effect);
         Assert (Effect = Garbage, "effect");
         Assert (not Is_Good_Frame (Sent), "a good frame by chance");
         if Wire.Data (Wire.Length) = CR then
            Ended := Ended + 1;
         else
            Open := Open + 1;
         end if;
      end loop;
      Assert (Ended > 1_000 and then Open > 1_000, "one kind only");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None, "over");
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
            Apply (P, Ping, Ack, Wire, Effect);
            Assert ((Effect = Dropped) = (K mod 2 = 0), "answers as well");
         end loop;
      end loop;
   end Test_Lost_Command;

   procedure Test_No_Answer is
      Nothing : constant Answer := (others => <>);
   begin
      P := (Silent => False, Drop => 1, Garbage => 1, Truncate => 1,
            Corrupt => 1, others => <>);
      for K in 1 .. 5 loop
         Apply (P, Ping, Nothing, Wire, Effect);
         Assert (Effect = None and then Sent'Length = 0, "something sent");
      end loop;
      Assert (P.Drop = 1 and then P.Garbage = 1 and then P.Truncate = 1
              and then P.Corrupt = 1, "used up");
   end Test_No_Answer;

   procedure Test_None is
   begin
      P := (others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None and then Sent = Ack.Data (1 .. 3), "changed");
   end Test_None;

   procedure Test_Order is
   begin
      P := (Drop => 1, Garbage => 1, Truncate => 1, Corrupt => 1,
            others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Dropped, "first");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Garbage, "second");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Truncated, "third");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Corrupt, "fourth");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None, "fifth");
   end Test_Order;

   procedure Test_Silent is
   begin
      P := (Silent => True, Drop => 1, others => <>);
      for K in 1 .. 10 loop
         Apply (P, Ping, Ack, Wire, Effect);
         Assert (Effect = Silent and then Sent'Length = 0, "said something");
      end loop;
      Assert (P.Drop = 1, "silence uses up nothing");
   end Test_Silent;

   procedure Test_Truncate is
   begin
      P := (Truncate => 1, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Truncated and then Sent = Ack.Data (1 .. 2), "cut");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None, "over");
   end Test_Truncate;

   procedure Test_Pile is
   begin
      P := (Pile => 3, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Held and then Sent'Length = 0, "first");
      Apply (P, Get_Version, Version, Wire, Effect);
      Assert (Effect = Held and then Sent'Length = 0, "second");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Together
              and then Sent = Ack.Data (1 .. 3) & Version.Data (1 .. 5)
                              & Ack.Data (1 .. 3), "together, in order");
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = None and then Sent = Ack.Data (1 .. 3), "over");

      --  One that is called off early, and one of a single answer

      P := (Pile => 3, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      P.Pile := 0;
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Effect = Together and then Sent'Length = 6, "called off");
      P := (Pile => 1, others => <>);
      Apply (P, Ping, Ack, Wire, Effect);
      Assert (Sent = Ack.Data (1 .. 3), "alone");
   end Test_Pile;

   procedure Test_Pile_Is_Full is
      Longest : constant Answer := (Length => 8, Data => (others => 65));
   begin
      P := (Pile => Max_Pile, others => <>);
      for K in 1 .. Max_Pile - 1 loop
         Apply (P, Ping, Longest, Wire, Effect);
         Assert (Effect = Held, "held");
      end loop;
      P.Pile := 5;
      for K in 1 .. 4 loop
         Apply (P, Ping, Longest, Wire, Effect);
         Assert (Effect = Held, "held on");
      end loop;
      Apply (P, Ping, Longest, Wire, Effect);
      Assert (Effect = Together and then Sent'Length = 8 * 4,
              "the newest, from the one on for which there was no room");
   end Test_Pile_Is_Full;

   procedure Test_Wrong_Kind is

      procedure Expect (To : Command_Kind; Texts : String) is
         --  In turn, one character each; V for the version
      begin
         P := (Wrong => 2 * Texts'Length, others => <>);
         for K in 1 .. 2 loop
            for C of Texts loop
               Apply (P, To, Ack, Wire, Effect);
               Assert (Effect = Wrong_Kind and then Is_Good_Frame (Sent),
                       "a good frame");
               if C = 'V' then
                  Assert (Sent = Version.Data (1 .. 5), "the version");
               else
                  Assert (Sent'Length = 3
                          and then Sent (1) = Character'Pos (C),
                          "text " & C);
               end if;
            end loop;
         end loop;
         Apply (P, To, Ack, Wire, Effect);
         Assert (Effect = None, "over");
      end Expect;
   begin
      Expect (Get_Battery, "OV0");
      Expect (Get_Busy, "OV2");
      Expect (Get_Version, "O1");
      Expect (Ping, "1V");
      Expect (Move, "1V");
      Expect (Unknown, "1V");
   end Test_Wrong_Kind;

   procedure Add_Tests is
   begin
      Add_Test ("none", Test_None'Access);
      Add_Test ("silent", Test_Silent'Access);
      Add_Test ("drop", Test_Drop'Access);
      Add_Test ("drop every", Test_Every'Access);
      Add_Test ("lost commands", Test_Lost_Command'Access);
      Add_Test ("corrupt", Test_Corrupt'Access);
      Add_Test ("truncate", Test_Truncate'Access);
      Add_Test ("garbage", Test_Garbage'Access);
      Add_Test ("cut anywhere", Test_Cut'Access);
      Add_Test ("every bit flipped", Test_Flip'Access);
      Add_Test ("wrong kind", Test_Wrong_Kind'Access);
      Add_Test ("piled up", Test_Pile'Access);
      Add_Test ("a pile too high", Test_Pile_Is_Full'Access);
      Add_Test ("endless", Test_Endless'Access);
      Add_Test ("several at once", Test_Order'Access);
      Add_Test ("no answer", Test_No_Answer'Access);
   end Add_Tests;

end Answer_Faults_Tests;
