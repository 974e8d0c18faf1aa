--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of an answer on the wire, on request: the robot itself has received
--  and carried out the command. And commands that are lost before the robot.

with Interfaces;
with Robot_Core;

package Answer_Faults with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Answer_Faults);
   --  A claim that GNATprove checks: every subprogram ends

   use type Robot_Core.Octet;

   type Effect_Kind is
     (None, Silent, Endless, Dropped, Held, Together, Garbage, Truncated,
      Corrupt, Flipped, Wrong_Kind, Lost);
   --  Lost: the command

   subtype Remaining is Natural range 0 .. 1_000_000;
   --  Number of answers, or of commands, still to be affected

   subtype Interval is Natural range 0 .. 1_000
     with Static_Predicate => Interval in 0 | 2 .. 1_000;
   --  Answers, or commands, from a lost one to the next; 0: none is lost

   subtype Passed_Count is Natural range 0 .. 999;
   --  Answers, or commands, since the last that was lost at an Interval

   subtype Bit_Number is Natural range 0 .. 1_000_000;
   --  Counts the bits of an answer, from bit 0 of its first byte, cyclically

   Max_Pile : constant := 16;

   subtype Pile_Size is Natural range 0 .. Max_Pile;

   Max_Wire : constant := Max_Pile * Robot_Core.Answer_Length'Last;

   subtype Wire_Length is Natural range 0 .. Max_Wire;

   type Wire_Bytes is record
      Length : Wire_Length := 0;
      Data   : Robot_Core.Octets (1 .. Max_Wire) := (others => 0);
   end record;

   type Plan is record
      Silent   : Boolean   := False;  --  no answer at all, until ended
      Endless  : Boolean   := False;  --  no carriage return, until ended
      Drop     : Remaining := 0;      --  not sent
      Every    : Interval  := 0;      --  each of this number is not sent
      Pile     : Pile_Size := 0;      --  held, and sent with the last of them
      Garbage  : Remaining := 0;      --  random bytes instead
      Truncate : Remaining := 0;      --  only the first Keep bytes
      Corrupt  : Remaining := 0;      --  with a wrong checksum
      Flip     : Remaining := 0;      --  with one bit flipped
      Wrong    : Remaining := 0;      --  a good frame of another kind
      Keep     : Robot_Core.Answer_Length := 0;
      --  Of a truncated answer; 0: all but its carriage return
      Bit      : Bit_Number := 0;
      --  The next to be flipped. Each answer has its turn and moves it on.
      Turn     : Interfaces.Unsigned_8 := 0;
      --  Which wrong kind is next
      Passed   : Passed_Count := 0;
      --  Of Every
      Lose        : Remaining    := 0;  --  commands: not received
      Lose_Every  : Interval     := 0;  --  each of this number is not
      Lose_Passed : Passed_Count := 0;
      --  Of Lose_Every
      Seed     : Interfaces.Unsigned_32 := 1;
      Kept     : Wire_Bytes;
      --  Answers held
   end record;
   --  If several apply, one is used at a time, in this order. Every counts
   --  all answers, those with another fault too.

   --  Used in the contract

   function Flipped_Byte
     (Bit : Bit_Number; Length : Robot_Core.Answer_Length) return Positive
   is (1 + Bit / 8 mod Length)
   with Pre => Length > 0, Post => Flipped_Byte'Result <= Length;

   Mask : constant array (Natural range 0 .. 7) of Robot_Core.Octet :=
     (1, 2, 4, 8, 16, 32, 64, 128);

   function Is_Flipped
     (Reply : Robot_Core.Answer; Wire : Wire_Bytes; Bit : Bit_Number)
      return Boolean
   is (for all K in 1 .. Reply.Length =>
         Wire.Data (K) =
           (if K = Flipped_Byte (Bit, Reply.Length)
            then Reply.Data (K) xor Mask (Bit mod 8)
            else Reply.Data (K)))
   with Pre => Reply.Length > 0;
   --  Exactly that bit is inverted

   function Is_Text (Wire : Wire_Bytes; C : Character) return Boolean is
     (Wire.Length = 3
      and then Wire.Data (1) = Character'Pos (C)
      and then Wire.Data (2) = Character'Pos (C)
      and then Wire.Data (3) = 16#0D#);
   --  The frame of one character, which is its own checksum

   function Is_Version (Wire : Wire_Bytes) return Boolean is
     (Wire.Length = 5
      and then Wire.Data (1) = Character'Pos ('3')
      and then Wire.Data (2) = Character'Pos ('.')
      and then Wire.Data (3) = Character'Pos ('5')
      and then Wire.Data (4) = 16#28#
      and then Wire.Data (5) = 16#0D#);

   function Is_Of_Another_Kind
     (To : Robot_Core.Command_Kind; Wire : Wire_Bytes) return Boolean
   is (case To is
          when Robot_Core.Get_Battery =>
            Is_Text (Wire, 'O') or else Is_Version (Wire)
            or else Is_Text (Wire, '0'),
          when Robot_Core.Get_Busy    =>
            Is_Text (Wire, 'O') or else Is_Version (Wire)
            or else Is_Text (Wire, '2'),
          when Robot_Core.Get_Version =>
            Is_Text (Wire, 'O') or else Is_Text (Wire, '1'),
          when others                 =>
            Is_Version (Wire) or else Is_Text (Wire, '1'));
   --  A valid frame that answers another question. A state instead of a
   --  battery level cannot be distinguished from a level of 0.

   procedure Apply
     (P      : in out Plan;
      To     : Robot_Core.Command_Kind;
      Reply  : Robot_Core.Answer;
      Wire   : out Wire_Bytes;
      Effect : out Effect_Kind)
   with
     Post =>
       (case Effect is
           when Lost                    => False,
           when None | Corrupt          => Wire.Length = Reply.Length,
           when Silent | Dropped | Held => Wire.Length = 0,
           when Endless                 => Wire.Length = Reply.Length - 1,
           when Together                => Wire.Length >= Reply.Length,
           when Truncated               =>
             Wire.Length in 1 .. Reply.Length - 1,
           when Garbage                 => Wire.Length > 0,
           when Flipped                 =>
             Wire.Length = Reply.Length
             and then Is_Flipped (Reply, Wire, P'Old.Bit),
           when Wrong_Kind              =>
             Is_Of_Another_Kind (To, Wire));
   --  The bytes sent instead of Reply, the answer to To. An empty reply stays
   --  empty and uses no fault. Garbage is never a valid frame.

   procedure Take_Command (P : in out Plan; Lost : out Boolean)
   with
     Post =>
       P.Lose = Natural'Max (P.Lose'Old, 1) - 1
       and then (if P.Lose'Old > 0 then Lost
                 elsif P.Lose_Every = 0 then not Lost);
   --  A command begins. Lost: the robot does not receive it.

   procedure Draw
     (Seed : in out Interfaces.Unsigned_32; Value : out Robot_Core.Octet);
   --  The next byte of a linear congruential sequence

   procedure Babble (P : in out Plan; Byte : out Robot_Core.Octet)
     with Post => Byte /= 16#0D#;
   --  The next byte of an endless answer

end Answer_Faults;
