--  SPDX-License-Identifier: GPL-3.0-or-later
--  The packet filter, interpreted as the kernel does: who is dropped.

with AUnit.Assertions;         use AUnit.Assertions;

with Admission.Blocklists;     use Admission.Blocklists;
with Admission.Networks;       use Admission.Networks;
with Admission.Packet_Filters; use Admission.Packet_Filters;
with Bytes;                    use Bytes;
with Interfaces;               use Interfaces;
with Unit_Runs; use Unit_Runs;

package body Packet_Filters_Tests is

   Syn     : constant Byte := 16#02#;
   Syn_Ack : constant Byte := 16#12#;
   Ack     : constant Byte := 16#10#;
   Reset   : constant Byte := 16#04#;

   Near : constant Peer_Address :=
     (11 | 12 => 255, 13 => 192, 14 => 168, 15 => 1, 16 => 7, others => 0);

   Far : constant Peer_Address :=
     (16#20#, 16#01#, 16#0D#, 16#B8#, 1, 2, 3, 4, others => 9);

   function With_Byte
     (P : Peer_Address; Index : Positive; Value : Byte) return Peer_Address
   is
      Result : Peer_Address := P;
   begin
      Result (Index) := Value;
      return Result;
   end With_Byte;

   function Passes
     (P : Program; Flags : Byte; From : Peer_Address) return Boolean
   is
      --  A packet of this peer, with these TCP flags
      Header  : array (Unsigned_32 range 0 .. 39) of Byte := (others => 0);
      Value   : Unsigned_32 := 0;
      Current : Step;
      Next    : Positive := 1;

      function Word (First : Unsigned_32) return Unsigned_32 is
        (Joined (Header (First), Header (First + 1), Header (First + 2),
                 Header (First + 3)));

   begin
      if Is_IPv4 (From) then
         for I in Unsigned_32 range 0 .. 3 loop
            Header (12 + I) := From (13 + Natural (I));
         end loop;
      else
         for I in Unsigned_32 range 0 .. 15 loop
            Header (8 + I) := From (1 + Natural (I));
         end loop;
      end if;
      loop
         Assert (Next <= P.Length, "beyond the program");
         Current := P.Steps (Next);
         Next := Next + 1;
         case Current.Code is
            when Load_Byte =>
               Assert (Current.Operand = 13, "flags");
               Value := Unsigned_32 (Flags);
            when Load_Half =>
               Assert (Current.Operand = Protocol, "protocol");
               Value := (if Is_IPv4 (From) then 16#0800# else 16#86DD#);
            when Load_Word =>
               Value := Word (Current.Operand - IP_Header);
            when And_With =>
               Value := Value and Current.Operand;
            when If_Equal =>
               Next := Next + Natural
                 (if Value = Current.Operand then Current.If_True
                  else Current.If_False);
            when Return_It =>
               Assert
                 (Current.Operand in 0 | Unsigned_32'Last, "part of it");
               return Current.Operand /= 0;
            when others =>
               Assert (False, "an unknown step");
         end case;
      end loop;
   end Passes;

   function Program_For (L : Admission.Blocklists.List) return Program is
      P : Program;
   begin
      Build (L, P);
      return P;
   end Program_For;

   procedure Test_Both is
      Other : constant Peer_Address := With_Byte (Near, 13, 10);
      P     : constant Program := Program_For
        ((Items  => (1 => Source_Of (Far), 2 => Source_Of (Near),
                     3 => Source_Of (With_Byte (Far, 1, 16#2A#)),
                     4 => Source_Of (Other), others => 0),
          Count  => 4));
   begin
      for Flags in Byte loop
         declare
            Opens : constant Boolean := (Flags and Syn_Ack) = Syn;
         begin
            Assert (Passes (P, Flags, Near) = not Opens, "IPv4");
            Assert (Passes (P, Flags, Other) = not Opens, "other IPv4");
            Assert (Passes (P, Flags, Far) = not Opens, "IPv6");
            Assert
              (Passes (P, Flags, With_Byte (Far, 1, 16#2A#)) = not Opens,
               "other IPv6");
            Assert (Passes (P, Flags, With_Byte (Near, 16, 8)), "IPv4 passes");
            Assert (Passes (P, Flags, With_Byte (Far, 8, 5)), "IPv6 passes");
         end;
      end loop;
   end Test_Both;

   procedure Test_Full is
      L : Admission.Blocklists.List;
   begin
      --  from none of IPv4 to nothing else
      for IPv4_Count in 0 .. Max_Sources loop
         L.Count := Max_Sources;
         for I in 1 .. Max_Sources loop
            L.Items (I) := Source_Of
              (With_Byte
                 ((if I <= IPv4_Count then Near else Far),
                  (if I <= IPv4_Count then 16 else 8), Byte (I)));
         end loop;
         declare
            P : constant Program := Program_For (L);
         begin
            for I in 1 .. Max_Sources + 1 loop
               Assert
                 (Passes (P, Syn, With_Byte (Near, 16, Byte (I)))
                    = (I > IPv4_Count),
                  "IPv4");
               Assert
                 (Passes (P, Syn, With_Byte (Far, 8, Byte (I)))
                    = (I <= IPv4_Count or else I > Max_Sources),
                  "IPv6");
            end loop;
         end;
      end loop;
   end Test_Full;

   procedure Test_IPv4 is
      P : constant Program := Program_For
        ((Items => (1 => Source_Of (Near), others => 0), Count => 1));
   begin
      Assert (not Passes (P, Syn, Near), "opens a connection");
      Assert (not Passes (P, Syn + 16#C0#, Near), "with ECN");
      Assert (Passes (P, Syn_Ack, Near), "SYN and ACK");
      Assert (Passes (P, Ack, Near), "ACK");
      Assert (Passes (P, Reset, Near), "RST");
      for I in 13 .. 16 loop
         Assert
           (Passes (P, Syn, With_Byte (Near, I, Near (I) + 1)),
            "another address");
      end loop;
      Assert (Passes (P, Syn, Far), "IPv6");
      --  the same word at the place of the IPv4 address
      Assert
        (Passes
           (P, Syn, (5 => 192, 6 => 168, 7 => 1, 8 => 7, others => 0)),
         "IPv6 that looks like it");
   end Test_IPv4;

   procedure Test_IPv6 is
      P : constant Program := Program_For
        ((Items => (1 => Source_Of (Far), others => 0), Count => 1));
   begin
      Assert (not Passes (P, Syn, Far), "opens a connection");
      Assert (Passes (P, Syn_Ack, Far), "SYN and ACK");
      Assert (Passes (P, Ack, Far), "ACK");
      for I in 1 .. 8 loop
         Assert
           (Passes (P, Syn, With_Byte (Far, I, Far (I) + 1)),
            "another network");
      end loop;
      for I in 9 .. 16 loop
         Assert
           (not Passes (P, Syn, With_Byte (Far, I, Far (I) + 1)),
            "the same network");
      end loop;
      Assert (Passes (P, Syn, Near), "IPv4");
      Assert
        (Passes
           (P, Syn, (11 | 12 => 255, 13 => 1, 14 => 2, 15 => 3, 16 => 4,
                     others => 0)),
         "IPv4 that looks like it");
   end Test_IPv6;

   procedure Test_Steps is
      --  as written by hand: numbers of linux/bpf_common.h
      Expected : constant array (1 .. 11) of Step :=
        ((16#30#, 0, 0, 13),
         (16#54#, 0, 0, 16#12#),
         (16#15#, 1, 0, 16#02#),
         (16#06#, 0, 0, 16#FFFF_FFFF#),
         (16#28#, 0, 0, 16#FFFF_F000#),
         (16#15#, 0, 4, 16#0800#),
         (16#20#, 0, 0, 16#FFF0_000C#),
         (16#15#, 0, 1, 16#C0A8_0107#),
         (16#06#, 0, 0, 0),
         (16#06#, 0, 0, 16#FFFF_FFFF#),
         (16#06#, 0, 0, 16#FFFF_FFFF#));
      P : constant Program := Program_For
        ((Items => (1 => Source_Of (Near), others => 0), Count => 1));
   begin
      Assert (P.Length = Expected'Length, "length");
      for I in Expected'Range loop
         Assert (P.Steps (I) = Expected (I), "step" & I'Image);
      end loop;
      Assert (Step'Size = 64 and then Step_Array'Component_Size = 64, "size");
   end Test_Steps;

   procedure Add_Tests is
   begin
      Add_Test ("an IPv4 source", Test_IPv4'Access);
      Add_Test ("an IPv6 source", Test_IPv6'Access);
      Add_Test ("sources of both kinds", Test_Both'Access);
      Add_Test ("as many as there is room for", Test_Full'Access);
      Add_Test ("the steps for one source", Test_Steps'Access);
   end Add_Tests;

end Packet_Filters_Tests;
