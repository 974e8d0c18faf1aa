--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong with an answer: repeatable, the random bytes come from
--  the plan's own seed.

package body Answer_Faults with SPARK_Mode is

   use Robot_Core;
   use Interfaces;

   Carriage_Return : constant Octet := 16#0D#;

   function Spoilt (Sum : Octet) return Octet is
     (if (Sum xor 1) = Carriage_Return then Sum xor 2 else Sum xor 1);
   --  One bit of it wrong, but not the one that would end the frame

   procedure Count
     (Every : Interval; Passed : in out Passed_Count; Has_Turn : out Boolean)
   with Post => (if Every = 0 then not Has_Turn)
   is
      --  Has_Turn: this one is to be lost as Every has it
   begin
      Has_Turn := False;
      if Every > 0 then
         Passed   := (Passed + 1) mod Every;
         Has_Turn := Passed = 0;
      end if;
   end Count;

   procedure Make_Garbage (Seed : in out Unsigned_32; Wire : out Wire_Bytes)
     with Post => Wire.Length > 0
   is
      Byte  : Octet;
      Ended : Boolean;
   begin
      Wire := (others => <>);
      Draw (Seed, Byte);
      Wire.Length := 3 + Natural (Byte mod 10);
      for K in 1 .. Wire.Length loop
         Draw (Seed, Byte);
         Wire.Data (K) := (if Byte = Carriage_Return then 0 else Byte);
      end loop;

      --  Half of it ends as a frame does, with anything but its checksum

      Draw (Seed, Byte);
      Ended := Byte >= 128;
      if Ended then
         if Checksum (Wire.Data (1 .. Wire.Length - 2))
            = Wire.Data (Wire.Length - 1)
         then
            Wire.Data (Wire.Length - 1) :=
              Spoilt (Wire.Data (Wire.Length - 1));
         end if;
         Wire.Data (Wire.Length) := Carriage_Return;
      end if;
   end Make_Garbage;

   procedure Set (Wire : in out Wire_Bytes; C : Character)
     with Post => Is_Text (Wire, C)
   is
      --  The frame of C
   begin
      Wire.Length := 3;
      Wire.Data (1 .. 3) :=
        (Character'Pos (C), Character'Pos (C), Carriage_Return);
   end Set;

   procedure Set_Version (Wire : in out Wire_Bytes)
     with Post => Is_Version (Wire)
   is
   begin
      Wire.Length := 5;
      Wire.Data (1 .. 5) :=
        (Character'Pos ('3'), Character'Pos ('.'), Character'Pos ('5'),
         16#28#, Carriage_Return);
   end Set_Version;

   procedure Choose
     (To   : Command_Kind;
      Turn : Unsigned_8;
      Wire : in out Wire_Bytes)
   with Post => Is_Of_Another_Kind (To, Wire)
   is
      --  One of the answers to other questions, another with another Turn
   begin
      case To is
         when Get_Battery | Get_Busy =>
            case Turn mod 3 is
               when 0      => Set (Wire, 'O');
               when 1      => Set_Version (Wire);
               when others =>
                  Set (Wire, (if To = Get_Battery then '0' else '2'));
            end case;
         when Get_Version =>
            Set (Wire, (if Turn mod 2 = 0 then 'O' else '1'));
         when others =>
            if Turn mod 2 = 0 then
               Set (Wire, '1');
            else
               Set_Version (Wire);
            end if;
      end case;
   end Choose;

   procedure Add (Kept : in out Wire_Bytes; Reply : Answer)
     with Pre  => Kept.Length <= Max_Wire - Reply.Length,
          Post => Kept.Length = Kept.Length'Old + Reply.Length
   is
      --  Reply behind what is kept
   begin
      Kept.Data (Kept.Length + 1 .. Kept.Length + Reply.Length) :=
        Reply.Data (1 .. Reply.Length);
      Kept.Length := Kept.Length + Reply.Length;
   end Add;

   procedure Apply
     (P      : in out Plan;
      To     : Command_Kind;
      Reply  : Answer;
      Wire   : out Wire_Bytes;
      Effect : out Effect_Kind)
   is
      Has_Turn : Boolean := False;
   begin
      Wire := (others => <>);
      Wire.Length := Reply.Length;
      Wire.Data (Reply.Data'Range) := Reply.Data;
      Effect := None;
      if Reply.Length >= 2 then
         Count (P.Every, P.Passed, Has_Turn);
      end if;

      if Reply.Length < 2 then
         null;

      elsif P.Silent then
         Wire.Length := 0;
         Effect := Silent;

      elsif P.Endless then
         Wire.Length := Reply.Length - 1;
         Effect := Endless;

      elsif P.Drop > 0 then
         P.Drop := P.Drop - 1;
         Wire.Length := 0;
         Effect := Dropped;

      elsif Has_Turn then
         Wire.Length := 0;
         Effect := Dropped;

      elsif P.Pile > 0 or else P.Kept.Length > 0 then
         P.Pile := Natural'Max (P.Pile, 1) - 1;
         if P.Kept.Length > Max_Wire - Reply.Length then
            --  No room: what was kept so far is lost
            P.Kept.Length := 0;
         end if;
         Add (P.Kept, Reply);
         if P.Pile > 0 then
            Wire.Length := 0;
            Effect := Held;
         else
            Wire := P.Kept;
            P.Kept.Length := 0;
            Effect := Together;
         end if;

      elsif P.Garbage > 0 then
         P.Garbage := P.Garbage - 1;
         Make_Garbage (P.Seed, Wire);
         Effect := Garbage;

      elsif P.Truncate > 0 then
         P.Truncate := P.Truncate - 1;
         Wire.Length :=
           (if P.Keep = 0 then Reply.Length - 1
            else Natural'Min (P.Keep, Reply.Length - 1));
         Effect := Truncated;

      elsif P.Corrupt > 0 then
         P.Corrupt := P.Corrupt - 1;
         Wire.Data (Reply.Length - 1) :=
           Spoilt (Wire.Data (Reply.Length - 1));
         Effect := Corrupt;

      elsif P.Flip > 0 then
         P.Flip := P.Flip - 1;
         declare
            Place : constant Positive := Flipped_Byte (P.Bit, Reply.Length);
         begin
            Wire.Data (Place) := Wire.Data (Place) xor Mask (P.Bit mod 8);
         end;
         P.Bit := (if P.Bit < Bit_Number'Last then P.Bit + 1 else 0);
         Effect := Flipped;

      elsif P.Wrong > 0 then
         P.Wrong := P.Wrong - 1;
         Choose (To, P.Turn, Wire);
         P.Turn := P.Turn + 1;
         Effect := Wrong_Kind;
      end if;
   end Apply;

   procedure Babble (P : in out Plan; Byte : out Octet) is
   begin
      Draw (P.Seed, Byte);
      if Byte = Carriage_Return then
         Byte := 0;
      end if;
   end Babble;

   procedure Draw (Seed : in out Unsigned_32; Value : out Octet) is
   begin
      Seed  := Seed * 1_664_525 + 1_013_904_223;
      Value := Octet (Shift_Right (Seed, 24));
   end Draw;

   procedure Take_Command (P : in out Plan; Lost : out Boolean) is
   begin
      Count (P.Lose_Every, P.Lose_Passed, Lost);
      Lost   := Lost or else P.Lose > 0;
      P.Lose := Natural'Max (P.Lose, 1) - 1;
   end Take_Command;

end Answer_Faults;
