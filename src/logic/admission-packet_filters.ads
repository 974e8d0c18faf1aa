--  SPDX-License-Identifier: GPL-3.0-or-later
--  The packet filter against sources that flood: a BPF program, which the
--  kernel applies to each packet to the listening socket.

with Admission.Blocklists;
with Interfaces;

package Admission.Packet_Filters with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Admission.Packet_Filters);

   use type Interfaces.Unsigned_8;
   use type Interfaces.Unsigned_16;
   use type Interfaces.Unsigned_32;

   --  Instructions (linux/bpf_common.h). The accumulator is set by a load
   Load_Byte : constant := 16#30#;  --  at the offset Operand
   Load_Half : constant := 16#28#;
   Load_Word : constant := 16#20#;
   And_With  : constant := 16#54#;
   If_Equal  : constant := 16#15#;  --  jumps; all others go to the next step
   Return_It : constant := 16#06#;  --  so many bytes of the packet; 0: drop

   --  Offsets: in the TCP segment, or else
   Protocol  : constant := 16#FFFF_F000#;  --  SKF_AD_PROTOCOL
   IP_Header : constant := 16#FFF0_0000#;  --  SKF_NET_OFF, its beginning

   type Step is record
      Code     : Interfaces.Unsigned_16 := Return_It;
      If_True  : Interfaces.Unsigned_8  := 0;
      If_False : Interfaces.Unsigned_8  := 0;
      Operand  : Interfaces.Unsigned_32 := 0;
   end record
   with Convention => C;
   --  struct sock_filter (linux/filter.h). A jump skips so many steps

   Max_Steps : constant := 8 + 8 * Admission.Blocklists.Max_Sources;

   subtype Step_Count is Natural range 0 .. Max_Steps;

   subtype Step_Place is Positive range 1 .. Max_Steps;

   type Step_Array is array (Step_Place) of Step with Convention => C;

   type Program is record
      Steps  : Step_Array;
      Length : Step_Count := 0;
   end record;
   --  The first Length steps

   function Reaches (P : Program; Last : Natural) return Boolean is
     (for all I in 1 .. P.Length =>
        (if P.Steps (I).Code = If_Equal then
            I + 1 + Natural (P.Steps (I).If_True) <= Last
            and then I + 1 + Natural (P.Steps (I).If_False) <= Last))
   with Pre => Last < Natural'Last;
   --  No jump goes beyond the step Last

   function Is_Sound (P : Program) return Boolean is
     (P.Length > 0
      and then P.Steps (P.Length).Code = Return_It
      and then Reaches (P, P.Length));
   --  It ends within its steps, whatever the packet

   procedure Build (Sources : Admission.Blocklists.List; P : out Program)
   with
     Pre  => Sources.Count > 0,
     Post => Is_Sound (P) and then P.Length <= 8 + 8 * Sources.Count;
   --  Drops the packets that open a connection from one of Sources: SYN
   --  without ACK. All others pass

end Admission.Packet_Filters;
