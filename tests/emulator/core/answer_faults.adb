--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong with an answer: repeatable, the random bytes come from
--  the plan's own seed.

package body Answer_Faults with SPARK_Mode is

   use Robot_Core;
   use Interfaces;

   Carriage_Return : constant Octet := 16#0D#;

   procedure Draw (Seed : in out Unsigned_32; Value : out Octet);
   --  The next byte of a linear congruential sequence

   procedure Make_Garbage (Seed : in out Unsigned_32; Wire : out Wire_Bytes)
     with Post => Wire.Length > 0;

   function Spoilt (Sum : Octet) return Octet is
     (if (Sum xor 1) = Carriage_Return then Sum xor 2 else Sum xor 1);
   --  One bit of it wrong, but not the one that would end the frame

   -----------
   -- Apply --
   -----------

   procedure Apply
     (P      : in out Plan;
      Reply  : Answer;
      Wire   : out Wire_Bytes;
      Effect : out Effect_Kind) is
   begin
      Wire := (others => <>);
      Wire.Length := Reply.Length;
      Wire.Data (Reply.Data'Range) := Reply.Data;
      Effect := None;

      if Reply.Length < 2 then
         null;

      elsif P.Silent then
         Wire.Length := 0;
         Effect := Silent;

      elsif P.Drop > 0 then
         P.Drop := P.Drop - 1;
         Wire.Length := 0;
         Effect := Dropped;

      elsif P.Garbage > 0 then
         P.Garbage := P.Garbage - 1;
         Make_Garbage (P.Seed, Wire);
         Effect := Garbage;

      elsif P.Truncate > 0 then
         P.Truncate := P.Truncate - 1;
         Wire.Length := Reply.Length - 1;
         Effect := Truncated;

      elsif P.Corrupt > 0 then
         P.Corrupt := P.Corrupt - 1;
         Wire.Data (Reply.Length - 1) :=
           Spoilt (Wire.Data (Reply.Length - 1));
         Effect := Corrupt;
      end if;
   end Apply;

   ----------
   -- Draw --
   ----------

   procedure Draw (Seed : in out Unsigned_32; Value : out Octet) is
   begin
      Seed  := Seed * 1_664_525 + 1_013_904_223;
      Value := Octet (Shift_Right (Seed, 24));
   end Draw;

   ------------------
   -- Make_Garbage --
   ------------------

   procedure Make_Garbage (Seed : in out Unsigned_32; Wire : out Wire_Bytes)
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

end Answer_Faults;
