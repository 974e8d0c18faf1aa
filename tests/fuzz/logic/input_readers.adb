--  SPDX-License-Identifier: GPL-3.0-or-later
--  An input of the fuzzer, read from its beginning: the bytes decide what a
--  target does.

with Interfaces; use Interfaces;

package body Input_Readers is

   procedure Take (R : in out Reader; B : out Bytes.Byte) is
   begin
      if Is_Empty (R) then
         B := 0;
      else
         R.Used := R.Used + 1;
         B := R.Data (R.Used);
      end if;
   end Take;

   procedure Take (R : in out Reader; C : out Character) is
      B : Bytes.Byte;
   begin
      Take (R, B);
      C := Character'Val (B);
   end Take;

   procedure Take
     (R : in out Reader; First, Last : Integer; Value : out Integer)
   is
      Count  : constant Integer_64 :=
        Integer_64 (Last) - Integer_64 (First) + 1;
      Number : Integer_64 := 0;
      B      : Bytes.Byte;
   begin
      for I in 1 .. 4 loop
         Take (R, B);
         Number := 256 * Number + Integer_64 (B);
      end loop;
      Value := Integer (Integer_64 (First) + Number mod Count);
   end Take;

   function Rest (R : Reader) return String is
   begin
      return Text : String (1 .. Remaining (R)) do
         for I in Text'Range loop
            Text (I) := Character'Val (R.Data (R.Used + I));
         end loop;
      end return;
   end Rest;

end Input_Readers;
