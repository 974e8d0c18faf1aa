--  SPDX-License-Identifier: GPL-3.0-or-later

with Admission.Networks;

package body Admission.Packet_Filters with SPARK_Mode is

   use type Admission.Networks.Source;

   IPv4 : constant := 16#0800#;  --  ETH_P_IP

   Pass : constant Step := (Return_It, 0, 0, Interfaces.Unsigned_32'Last);

   Kind : constant := 6;
   --  The step that jumps to the IPv6 sources

   procedure Add (P : in out Program; S : Step)
   with
     Pre  => P.Length < Max_Steps and then S.Code /= If_Equal,
     Post => P.Length = P.Length'Old + 1
       and then P.Steps (P.Length) = S
       and then (for all I in 1 .. P.Length'Old =>
                   P.Steps (I) = P.Steps'Old (I));

   procedure Add_Word
     (P     : in out Program;
      At_It : Interfaces.Unsigned_32;
      Value : Interfaces.Unsigned_32;
      Skip  : Interfaces.Unsigned_8)
   with
     Pre  => P.Length <= Max_Steps - 2
       and then Reaches (P, P.Length + 1 + Natural (Skip) + 2),
     Post => P.Length = P.Length'Old + 2
       and then (for all I in 1 .. P.Length'Old =>
                   P.Steps (I) = P.Steps'Old (I))
       and then Reaches (P, P.Length + 1 + Natural (Skip));
   --  Skips so many steps if the word of the IP header differs from Value

   procedure Add (P : in out Program; S : Step) is
   begin
      P.Length := P.Length + 1;
      P.Steps (P.Length) := S;
   end Add;

   procedure Add_Word
     (P     : in out Program;
      At_It : Interfaces.Unsigned_32;
      Value : Interfaces.Unsigned_32;
      Skip  : Interfaces.Unsigned_8) is
   begin
      P.Steps (P.Length + 1) := (Load_Word, 0, 0, At_It);
      P.Steps (P.Length + 2) := (If_Equal, 0, Skip, Value);
      P.Length := P.Length + 2;
   end Add_Word;

   procedure Build (Sources : Admission.Blocklists.List; P : out Program) is
      Source : Admission.Networks.Source;
   begin
      P := (others => <>);
      P.Steps (1) := (Load_Byte, 0, 0, 13);         --  the TCP flags
      P.Steps (2) := (And_With, 0, 0, 16#12#);      --  SYN and ACK
      P.Steps (3) := (If_Equal, 1, 0, 16#02#);      --  SYN alone
      P.Steps (4) := Pass;
      P.Steps (5) := (Load_Half, 0, 0, Protocol);
      P.Steps (Kind) := (If_Equal, 0, 0, IPv4);     --  else: see below
      P.Length := Kind;
      for I in 1 .. Sources.Count loop
         Source := Sources.Items (I);
         if Admission.Networks.Is_IPv4 (Source) then
            Add_Word
              (P, IP_Header + 12,
               Interfaces.Unsigned_32 (Source and 16#FFFF_FFFF#), 1);
            Add (P, (Return_It, 0, 0, 0));
         end if;
         pragma Loop_Invariant (P.Length in Kind .. Kind + 3 * I);
         pragma Loop_Invariant (P.Steps (Kind).Code = If_Equal);
         pragma Loop_Invariant (P.Steps (Kind).If_True = 0);
         pragma Loop_Invariant (Reaches (P, P.Length + 1));
      end loop;
      Add (P, Pass);
      pragma Assert (Reaches (P, P.Length));
      P.Steps (Kind).If_False := Interfaces.Unsigned_8 (P.Length - Kind);
      pragma Assert (Reaches (P, P.Length + 1));
      for I in 1 .. Sources.Count loop
         Source := Sources.Items (I);
         if not Admission.Networks.Is_IPv4 (Source) then
            Add_Word
              (P, IP_Header + 8,
               Interfaces.Unsigned_32
                 (Interfaces.Shift_Right (Source, 32)), 3);
            Add_Word
              (P, IP_Header + 12,
               Interfaces.Unsigned_32 (Source and 16#FFFF_FFFF#), 1);
            Add (P, (Return_It, 0, 0, 0));
         end if;
         pragma Loop_Invariant
           (P.Length in Kind .. Kind + 1 + 3 * Sources.Count + 5 * I);
         pragma Loop_Invariant (Reaches (P, P.Length + 1));
      end loop;
      Add (P, Pass);
   end Build;

end Admission.Packet_Filters;
